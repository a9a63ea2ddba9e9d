#include "pipeline/production/report/report_ratings.h"

#include <cmath>

#include <fmt/format.h>

#include "pipeline/base/documents/html.h"
#include "pipeline/production/methods/study_facts.h"

namespace mien::pipeline {

namespace {

std::string expectation_list(const Manifest& manifest, const Repertoire& repertoire) {
  if (manifest.ratings.expected.empty()) return "";
  std::string list = "<h3>Expected orders</h3>\n<ul class=\"expected\">\n";
  for (const ExpectationCheck& check : expectation_checks(manifest, repertoire)) {
    const char* state = check.is_certain() ? "holds" : check.holds() ? "unsure" : "fails";
    list += fmt::format("<li class=\"{}\">{}</li>\n", state, html_escaped(sentence_of(check)));
  }
  return list + "</ul>\n";
}

/// A cell whose shade tells how far from the middle a mean lies, and to which end.
std::string cell(const Impressions& impressions, Eigen::Index scale, Eigen::Index example) {
  const double mean = impressions.mean(scale, example);
  const double deviation = impressions.deviation(scale, example);
  const int answers = impressions.count(scale, example);
  const std::string spread = std::isnan(deviation) ? "" : fmt::format(", SD {:.2f}", deviation);
  return fmt::format("<td class=\"{}\" style=\"--far:{:.0f}%\" title=\"{} answers{}\">{:.2f}</td>",
                     mean < 0.5 ? "low" : "high", 200.0 * std::abs(mean - 0.5), answers, spread,
                     mean);
}

std::string impression_table(const Impressions& impressions, const ScaleSet& scales) {
  std::string table = "<div class=\"wide\"><table class=\"impressions\"><thead><tr><th></th>";
  for (const std::string& example : impressions.examples) {
    table += fmt::format("<th scope=\"col\">{}</th>", html_escaped(example));
  }
  table += "</tr></thead>\n<tbody>";
  for (Eigen::Index j = 0; j < impressions.mean.rows(); ++j) {
    const Scale& scale = *find_scale(scales, impressions.scales[static_cast<std::size_t>(j)]);
    table += fmt::format("<tr><th scope=\"row\">{} – {}</th>", html_escaped(scale.low),
                         html_escaped(scale.high));
    for (Eigen::Index i = 0; i < impressions.mean.cols(); ++i) table += cell(impressions, j, i);
    table += "</tr>\n";
  }
  return table + "</tbody></table></div>\n";
}

}  // namespace

std::string ratings_section(const Manifest& manifest, const Repertoire& repertoire) {
  if (!repertoire.impressions) return "";
  return "<section><h2>Ratings of the examples</h2>\n" + expectation_list(manifest, repertoire) +
         "<details><summary>Mean ratings: 0 low end, 1 high end</summary>\n" +
         impression_table(*repertoire.impressions, repertoire.scales) + "</details>\n</section>\n";
}

}  // namespace mien::pipeline

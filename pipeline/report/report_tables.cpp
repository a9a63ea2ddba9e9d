#include "pipeline/report/report_tables.h"

#include <algorithm>

#include <fmt/format.h>

#include "motion/measures/distance.h"
#include "pipeline/documents/html.h"
#include "pipeline/report/feature_changes.h"
#include "pipeline/synthesis/parameter_label.h"

namespace mien::pipeline {

namespace {

constexpr int most_weights = 6;

}  // namespace

std::string parameter_table(const Stimulus& stimulus, const Synthesis& made, Motions& motions) {
  std::string rows;
  for (std::size_t i = 0; i < made.asked.size(); ++i) {
    const auto& [id, asked] = made.asked[i];
    const ParameterLabel label = label_of(id, stimulus, motions.repertoire());
    const std::string name = english_text(label) + " " + japanese_text(label);
    rows += fmt::format(
        "<tr><th scope=\"row\">{}</th><td class=\"bar\"><meter min=\"0\" max=\"1\" "
        "value=\"{:.3f}\"></meter></td><td>{:.2f}</td><td>{:.2f}</td></tr>\n",
        html_escaped(name), asked, asked, made.reached[i].second);
  }
  if (rows.empty()) return rows;
  return html_table({"parameter", "", "asked", "reached"}, rows);
}

std::string weight_table(const Synthesis& made, Motions& motions) {
  if (made.weights.size() == 0) return "";
  std::vector<std::pair<double, std::string>> weights;
  for (Eigen::Index i = 0; i < made.weights.size(); ++i) {
    weights.emplace_back(made.weights[i],
                         motions.repertoire().names[static_cast<std::size_t>(i)].name);
  }
  std::stable_sort(weights.begin(), weights.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::string rows;
  int shown = 0;
  for (const auto& [weight, name] : weights) {
    if (weight < 0.005 || shown++ == most_weights) break;
    rows += fmt::format(
        "<tr><th scope=\"row\">{}</th><td class=\"bar\"><meter min=\"0\" max=\"1\" "
        "value=\"{:.3f}\"></meter></td><td>{:.2f}</td></tr>\n",
        html_escaped(name), weight, weight);
  }
  return html_table({"example", "", "weight"}, rows);
}

std::string distance_table(const Manifest& manifest, Motions& motions) {
  std::string rows;
  for (const Sheet& sheet : manifest.sheets) {
    for (const auto& [target, created] : pairs_on(sheet)) {
      const motion::Distance d =
          motion::distance(motions.of(target).motion, motions.of(created).motion);
      rows += fmt::format(
          "<tr><th scope=\"row\">{}</th><td>{}</td><td>{:.4f}</td><td>{:.3f}</td><td>{:.4f}</td>"
          "<td>{}</td></tr>\n",
          html_escaped(target), html_escaped(created), d.mean, d.sum, d.mpjpe,
          d.matches() ? "yes" : "no");
    }
  }
  return html_table({"target", "created", "D (m)", "sum (m)", "MPJPE (m)", "D &lt; 0.06 m"}, rows);
}

std::string feature_agreement_table(const Manifest& manifest, Motions& motions) {
  std::string rows;
  for (const Sheet& sheet : manifest.sheets) {
    const std::vector<motion::FeatureChange> changes = feature_changes(sheet, motions);
    const auto moved =
        std::count_if(changes.begin(), changes.end(),
                      [](const motion::FeatureChange& change) { return change.moved(); });
    const auto agree =
        std::count_if(changes.begin(), changes.end(),
                      [](const motion::FeatureChange& change) { return change.agrees(); });
    if (moved == 0) continue;
    rows += fmt::format("<tr><th scope=\"row\">{}</th><td>{}</td><td>{}</td><td>{}</td></tr>\n",
                        html_escaped(sheet.target), html_escaped(sheet.created), moved, agree);
  }
  if (rows.empty()) return rows;
  return html_table({"target", "created", "features that the target moved from the reference",
                     "moved the same way"},
                    rows);
}

}  // namespace mien::pipeline

#include "pipeline/production/report/report.h"

#include <algorithm>
#include <cmath>
#include <span>

#include <fmt/format.h>

#include "pipeline/base/documents/html.h"
#include "pipeline/manifest/people.h"
#include "pipeline/manifest/repetitions.h"
#include "pipeline/production/design/design_findings.h"
#include "pipeline/production/methods/study_facts.h"
#include "pipeline/production/report/design_section.h"
#include "pipeline/production/report/recordings_section.h"
#include "pipeline/production/report/report_sections.h"
#include "pipeline/tasks/code_identity.h"

namespace mien::pipeline {

namespace {

/// Style sheet of report.html: light and dark, screen and paper.
constexpr std::string_view report_style = R"(:root {
  color-scheme: light dark;
  --ink: #1d2126; --quiet: #5b6570; --paper: #ffffff; --card: #f4f6f8; --line: #d6dbe1;
  --target: #1f7a45; --created: #2a62b8; --reference: #b23c30; --warn: #fde9bd; --warn-ink: #5c4300;
}
@media (prefers-color-scheme: dark) {
  :root {
    --ink: #e7eaee; --quiet: #a3adb8; --paper: #15181c; --card: #1e2329; --line: #363d46;
    --target: #5cc389; --created: #7aa9f0; --reference: #ee8a7f; --warn: #4b3a10; --warn-ink: #ffe7ae;
  }
}
* { box-sizing: border-box; }
body { margin: 0 auto; max-width: 86rem; padding: 2rem 1.5rem; background: var(--paper); color: var(--ink);
  font: 16px/1.5 "Noto Sans", "Noto Sans CJK JP", system-ui, sans-serif; }
h1 { font-size: 2rem; margin: 0 0 .5rem; }
h2 { font-size: 1.3rem; margin: 2.5rem 0 1rem; }
h3 { margin: 0 0 .6rem; font-size: 1.1rem; }
h3 small { color: var(--quiet); font-weight: 400; }
.cards { display: grid; gap: 1.5rem; grid-template-columns: repeat(auto-fill, minmax(22rem, 1fr)); }
article { background: var(--card); border-top: .3rem solid var(--line); border-radius: .4rem; padding: 1rem; }
article.target { border-color: var(--target); }
article.created { border-color: var(--created); }
article.reference { border-color: var(--reference); }
video, img { display: block; width: 100%; height: auto; border-radius: .3rem; margin-bottom: .6rem; background: #ccc; }
figure { margin: 1.5rem 0; }
figure img { border: 1px solid var(--line); background: #fff; }
figcaption, p, footer { color: var(--quiet); }
table { border-collapse: collapse; width: 100%; margin: .6rem 0; font-variant-numeric: tabular-nums; }
th, td { text-align: left; padding: .2rem .6rem .2rem 0; border-bottom: 1px solid var(--line); font-weight: 400; }
thead th { color: var(--quiet); font-size: .85rem; }
.number { text-align: right; }
.wide { overflow-x: auto; }
.impressions th[scope="col"] { text-align: right; }
.impressions td { text-align: right; background: color-mix(in srgb, var(--tone) var(--far), transparent); }
.impressions .low { --tone: #d08a2e; }
.impressions .high { --tone: #3f8fb5; }
.expected { list-style: none; padding: 0; }
.holds::before { content: "✓ "; color: var(--target); font-weight: 700; }
.unsure::before { content: "? "; color: var(--quiet, #777); font-weight: 700; }
.fails::before { content: "✗ "; color: var(--reference); font-weight: 700; }
article, figure { content-visibility: auto; contain-intrinsic-size: auto 40rem; }
.parts a { margin-right: .6rem; }
summary { cursor: pointer; }
meter { width: 100%; min-width: 5rem; }
.simulated, .warnings { background: var(--warn); color: var(--warn-ink); border-radius: .4rem; padding: .7rem 1rem; }
.warnings { padding-left: 2rem; }
.errors { border-left: .3rem solid var(--reference); margin: .6rem 0; padding-left: 1.6rem; }
details ul { font-size: .9rem; padding-left: 1.2rem; }
a { color: inherit; }
@media print { video { display: none; } article, figure { break-inside: avoid; } }
)";

std::string expectation_list(const Manifest& manifest, const Repertoire& repertoire) {
  if (manifest.ratings.expected.empty()) return "";
  std::string list = "<h3>Expected orders</h3>\n<ul class=\"expected\">\n";
  for (const ExpectationCheck& check : expectation_checks(manifest, repertoire)) {
    const char* state = check.is_certain() ? "holds" : check.holds() ? "unsure" : "fails";
    list += fmt::format("<li class=\"{}\">{}</li>\n", state, html_escaped(sentence_of(check)));
  }
  return list + "</ul>\n";
}

/// A cell whose shade shows how far from the middle a mean is, and towards which end.
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

/// The part of report.html about the examples' ratings: which expected orders hold, and the mean
/// answers as a table. Empty without ratings.
std::string ratings_section(const Manifest& manifest, const Repertoire& repertoire) {
  if (!repertoire.impressions) return "";
  return "<section><h2>Ratings of the examples</h2>\n" + expectation_list(manifest, repertoire) +
         "<details><summary>Mean ratings: 0 low end, 1 high end</summary>\n" +
         impression_table(*repertoire.impressions, repertoire.scales) + "</details>\n</section>\n";
}

/// The table of warnings has all.
constexpr std::size_t most_warnings_of_one_kind = 100;

bool rests_on_simulated_ratings(const Manifest& manifest, Motions& motions) {
  const bool any = std::ranges::any_of(
      motion_sources(manifest), [](const Stimulus* motion) { return !motion->adjectives.empty(); });
  return any && motions.repertoire().simulated_ratings;
}

std::string page_header(const Manifest& manifest, Motions& motions) {
  std::string header = "<header><h1>" + html_escaped(manifest.study) + "</h1>\n";
  if (rests_on_simulated_ratings(manifest, motions)) {
    header +=
        "<p class=\"simulated\"><strong>Simulated ratings.</strong> No participants have rated the "
        "example motions; adjective values are those of simulated raters.</p>\n";
  }
  return header + "</header>\n";
}

std::string methods_section(const Methods& methods) {
  return titled_section("Methods",
                        methods_html(methods.markdown) +
                            "<p>As text with citations: <a href=\"methods.md\">methods.md</a>, <a "
                            "href=\"references.bib\">references.bib</a>.</p>\n");
}

std::string page_footer(const Manifest& manifest) {
  return fmt::format(
      "<footer><p>mien {} · seed {} · manifest {} · {}tables in <a href=\"metrics/\">metrics/</a>, "
      "documented in <a href=\"metrics/codebook.json\">codebook.json</a> · settings of all stimuli "
      "and hashes of all inputs and artifacts in <a "
      "href=\"provenance.json\">provenance.json</a></p></footer>\n",
      program_version(), manifest.seed, html_escaped(manifest.file.filename().string()),
      manifest.command.empty()
          ? ""
          : "made with <code>" + html_escaped(manifest.command) + "</code> · ");
}

std::string links_to_neighbours(const std::vector<ReportPart>& parts, std::size_t which,
                                const Manifest& manifest) {
  const auto link = [](const std::string& path, const std::string& text) {
    return fmt::format("<a href=\"{}\">{}</a>", path, text);
  };
  std::vector<std::string> links = {link("report.html", html_escaped(manifest.study))};
  if (which > 0) links.push_back("← " + link(parts[which - 1].path(), parts[which - 1].title()));
  if (which + 1 < parts.size())
    links.push_back(link(parts[which + 1].path(), parts[which + 1].title()) + " →");
  return fmt::format("<nav>{}</nav>\n", fmt::join(links, " · "));
}

/// Warnings about the examples and about several stimuli; those of one stimulus are on its card.
std::vector<std::string> warnings_of_all(const Manifest& manifest, Motions& motions,
                                         const DesignFindings& design) {
  std::vector<std::string> warnings;
  if (blends_examples(manifest)) warnings = motions.repertoire().warnings;
  for (const DesignWarning& warning : design_warnings(manifest, design))
    warnings.push_back(to_sentence(warning));
  std::vector<std::string> repetitions = repetition_warnings(manifest);
  const std::size_t shown = std::min(repetitions.size(), most_warnings_of_one_kind);
  warnings.insert(warnings.end(), repetitions.begin(),
                  repetitions.begin() + static_cast<std::ptrdiff_t>(shown));
  if (shown < repetitions.size()) {
    warnings.push_back(fmt::format("the same applies to {} others, listed in metrics/warnings.csv",
                                   repetitions.size() - shown));
  }
  return warnings;
}

}  // namespace

std::string report(const Manifest& manifest, Motions& motions, const Methods& methods,
                   const DesignFindings& design, const FilmWarnings& films) {
  std::string body = page_header(manifest, motions) + "<main>\n";
  body += html_list("warnings", warnings_of_all(manifest, motions, design));
  const std::vector<ReportPart> parts = report_parts(manifest);
  body += findings_section(manifest, motions, films);
  if (parts.empty()) {
    body += comparisons_section("Comparisons", comparisons_in(manifest), motions) +
            stills_section(manifest, motions) +
            stimuli_section("Stimuli", manifest.stimuli, manifest, motions, films) +
            overlays_section("Overlays", manifest.overlays, manifest, motions, films);
  } else {
    body += parts_section(parts, manifest) + stills_section(manifest, motions);
  }
  body += design_section(design.properties) + recordings_section(manifest, motions);
  if (blends_examples(manifest)) body += ratings_section(manifest, motions.repertoire());
  body += methods_section(methods) + "</main>\n" + page_footer(manifest);
  return html_page(manifest.study + " · mien", report_style, body);
}

std::string report_part(const std::vector<ReportPart>& parts, std::size_t which,
                        const Manifest& manifest, Motions& motions, const FilmWarnings& films) {
  const ReportPart& part = parts[which];
  const std::size_t count = part.end - part.first;
  std::string cards;
  if (part.kind == CardKind::stimulus) {
    cards = stimuli_section(part.title(), std::span(manifest.stimuli).subspan(part.first, count),
                            manifest, motions, films);
  } else if (part.kind == CardKind::overlay) {
    cards = overlays_section(part.title(), std::span(manifest.overlays).subspan(part.first, count),
                             manifest, motions, films);
  } else {
    const std::vector<const Sheet*> all = comparisons_in(manifest);
    cards = comparisons_section(part.title(), std::span(all).subspan(part.first, count), motions);
  }
  const std::string links = links_to_neighbours(parts, which, manifest);
  const std::string body = page_header(manifest, motions) + links + "<main>\n" + cards +
                           "</main>\n" + links + page_footer(manifest);
  return html_page(manifest.study + " · " + part.title() + " · mien", report_style, body, "../");
}

}  // namespace mien::pipeline

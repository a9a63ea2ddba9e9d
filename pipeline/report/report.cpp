#include "pipeline/report/report.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "pipeline/documents/html.h"
#include "pipeline/manifest/repetitions.h"
#include "pipeline/report/report_cards.h"
#include "pipeline/report/report_ratings.h"
#include "pipeline/report/report_style.h"
#include "pipeline/report/report_tables.h"
#include "pipeline/tasks/code_identity.h"

namespace mien::pipeline {

namespace {

bool rests_on_simulated_ratings(const Manifest& manifest, Motions& motions) {
  const bool any = std::any_of(manifest.stimuli.begin(), manifest.stimuli.end(),
                               [](const Stimulus& s) { return !s.adjectives.empty(); });
  return any && motions.repertoire().simulated_ratings;
}

std::string page_header(const Manifest& manifest, Motions& motions) {
  std::string header = "<header><h1>" + html_escaped(manifest.study) + "</h1>\n";
  if (rests_on_simulated_ratings(manifest, motions)) {
    header +=
        "<p class=\"simulated\"><strong>Simulated ratings.</strong> No person has rated the "
        "example motions: what is shown for an adjective is what made-up raters would say.</p>\n";
  }
  return header + "</header>\n";
}

/// What the films of a study have in common because it asks for that.
std::string alike(const Equalize& equalize) {
  std::vector<std::string> what;
  if (equalize.duration) what.emplace_back("length (as the shortest)");
  if (equalize.size) {
    what.emplace_back(
        "height of the standing figure in pixels (as the smallest: "
        "<a href=\"metrics/sizes.csv\">sizes.csv</a>)");
  }
  if (equalize.place) {
    what.emplace_back("place in the picture (<a href=\"metrics/places.csv\">places.csv</a>)");
  }
  if (equalize.luminance) {
    what.emplace_back(
        "mean luminance (by exposure: <a href=\"metrics/exposure.csv\">exposure.csv</a>)");
  }
  return what.empty()
             ? ""
             : fmt::format("<p>Made alike in all stimuli: {}.</p>\n", fmt::join(what, ", "));
}

std::string titled_section(const std::string& title, const std::string& content) {
  return "<section><h2>" + title + "</h2>\n" + content + "</section>\n";
}

std::string card_grid(const std::string& cards) {
  return "<div class=\"cards\">\n" + cards + "</div>";
}

std::string stimuli_section(const Manifest& manifest, Motions& motions) {
  std::string films;
  for (const Stimulus& stimulus : manifest.stimuli) films += stimulus_card(stimulus, motions);
  return titled_section("Stimuli", alike(manifest.equalize) + card_grid(films));
}

std::string foils_section(const Manifest& manifest, Motions& motions) {
  const std::string table = foil_table(manifest, motions);
  return table.empty() ? "" : titled_section("Foils", table);
}

std::string overlays_section(const Manifest& manifest) {
  std::string films;
  for (const Overlay& overlay : manifest.overlays) films += overlay_card(overlay, manifest);
  return films.empty() ? "" : titled_section("Overlays", card_grid(films));
}

/// Pages of stills, then comparisons.
std::string sheets_sections(const Manifest& manifest, Motions& motions) {
  std::string stills;
  std::string comparisons;
  for (const Sheet& sheet : manifest.sheets) {
    (sheet.stills.empty() ? comparisons : stills) += sheet_card(sheet, motions);
  }
  std::string sections;
  if (!stills.empty()) sections += titled_section("Pictures", stills);
  if (comparisons.empty()) return sections;
  return sections + titled_section("Comparisons", distance_table(manifest, motions) +
                                                      feature_agreement_table(manifest, motions) +
                                                      comparisons);
}

std::string methods_section(const Methods& methods) {
  return titled_section(
      "Methods",
      methods_html(methods.markdown) +
          "<p>The same as text, with citations: <a href=\"methods.md\">methods.md</a>, <a "
          "href=\"references.bib\">references.bib</a>.</p>\n");
}

std::string page_footer(const Manifest& manifest) {
  return fmt::format(
      "<footer><p>mien {} · seed {} · manifest {} · {}numbers in <a "
      "href=\"metrics/\">metrics/</a>, "
      "their columns in <a href=\"metrics/codebook.json\">codebook.json</a> · settings of all "
      "stimuli and hashes of all inputs and artifacts in "
      "<a href=\"provenance.json\">provenance.json</a></p></footer>\n",
      program_version(), manifest.seed, html_escaped(manifest.file.filename().string()),
      manifest.command.empty() ? ""
                               : "made by <code>" + html_escaped(manifest.command) + "</code> · ");
}

/// Of examples and of stimuli among each other; cards tell those of one stimulus.
std::vector<std::string> warnings_of_all(const Manifest& manifest, Motions& motions) {
  std::vector<std::string> warnings;
  if (blends_examples(manifest)) warnings = motions.repertoire().warnings;
  for (std::string& told : told_repetitions(manifest)) warnings.push_back(std::move(told));
  return warnings;
}

}  // namespace

std::string report(const Manifest& manifest, Motions& motions, const Methods& methods) {
  std::string body = page_header(manifest, motions) + "<main>\n";
  body += html_list("warnings", warnings_of_all(manifest, motions));
  body += stimuli_section(manifest, motions) + foils_section(manifest, motions) +
          overlays_section(manifest) + sheets_sections(manifest, motions);
  if (blends_examples(manifest)) body += ratings_section(manifest, motions.repertoire());
  body += methods_section(methods) + "</main>\n" + page_footer(manifest);
  return html_page(manifest.study + " · mien", report_style, body);
}

}  // namespace mien::pipeline

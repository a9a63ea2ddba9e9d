#include "pipeline/production/report/report_sections.h"

#include <algorithm>
#include <cstddef>
#include <optional>

#include <fmt/format.h>

#include "pipeline/base/documents/html.h"
#include "pipeline/manifest/people.h"
#include "pipeline/production/report/report_cards.h"
#include "pipeline/production/report/report_tables.h"

namespace mien::pipeline {

namespace {

/// The quantities that a study equalizes, and among which films.
std::string alike(const Equalize& equalize) {
  std::vector<std::string> in_all, by_figure;
  const auto add = [&](const std::optional<EqualizeGroup>& among, const std::string& what) {
    if (among) (*among == EqualizeGroup::figure ? by_figure : in_all).push_back(what);
  };
  if (equalize.duration) {
    in_all.emplace_back(
        "duration (to the shortest: <a href=\"metrics/durations.csv\">durations.csv</a>)");
  }
  add(equalize.size,
      "height of the standing figure in pixels (to the smallest: <a "
      "href=\"metrics/sizes.csv\">sizes.csv</a>)");
  add(equalize.place, "position in the image (<a href=\"metrics/places.csv\">places.csv</a>)");
  if (equalize.loudness) {
    in_all.push_back(fmt::format("loudness of the sounds ({:g} LUFS)", *equalize.loudness));
  }
  add(equalize.luminance,
      "mean luminance (by exposure: <a href=\"metrics/exposure.csv\">exposure.csv</a>)");
  std::string text;
  if (!in_all.empty())
    text += fmt::format("<p>Equalized across stimuli: {}.</p>\n", fmt::join(in_all, ", "));
  if (!by_figure.empty()) {
    text += fmt::format("<p>Equalized across stimuli with the same kind of figure: {}.</p>\n",
                        fmt::join(by_figure, ", "));
  }
  return text;
}

std::string card_grid(const std::string& cards) {
  return "<div class=\"cards\">\n" + cards + "</div>";
}

/// An error, else a warning of the lint, else one of how the motion was made.
std::string first_found(const Synthesis& made) {
  const auto error =
      std::ranges::find(made.findings, motion::Severity::error, &motion::Finding::severity);
  if (error != made.findings.end()) return error->sentence;
  return made.findings.empty() ? made.warnings.front() : made.findings.front().sentence;
}

/// The ids of a page's stimuli, folded away, for a reader who looks for one.
std::string linked_stimuli(const ReportPart& part, const Manifest& manifest) {
  std::string links;
  for (std::size_t i = part.first; i < part.end; ++i) {
    const Stimulus& stimulus = manifest.stimuli[i];
    links += fmt::format("<a href=\"{}\">{}</a>\n", link_to(stimulus, manifest),
                         html_escaped(stimulus.id));
  }
  return "<details><summary>stimuli on this page</summary>\n" + links + "</details>\n";
}

/// The id of a film, linked to its card if it is that of a stimulus.
std::string linked_film(const Stimulus& film, const Manifest& manifest) {
  const std::string id = html_escaped(film.id);
  const auto stimulus = std::ranges::find(manifest.stimuli, film.id, &Stimulus::id);
  return stimulus == manifest.stimuli.end()
             ? id
             : fmt::format("<a href=\"{}\">{}</a>", link_to(*stimulus, manifest), id);
}

}  // namespace

std::string titled_section(const std::string& title, const std::string& content) {
  return "<section><h2>" + title + "</h2>\n" + content + "</section>\n";
}

std::string stimuli_section(const std::string& title, std::span<const Stimulus> stimuli,
                            const Manifest& manifest, Motions& motions, const FilmWarnings& films) {
  std::string cards;
  for (const Stimulus& stimulus : stimuli)
    cards += stimulus_card(stimulus, motions, name_language(manifest), films);
  const std::string foils = foil_table(stimuli, motions);
  return titled_section(title, alike(manifest.equalize) + card_grid(cards)) +
         (foils.empty() ? "" : titled_section("Foils", foils));
}

std::string overlays_section(const std::string& title, std::span<const Overlay> overlays,
                             const Manifest& manifest, Motions& motions,
                             const FilmWarnings& films) {
  std::string cards;
  for (const Overlay& overlay : overlays) cards += overlay_card(overlay, manifest, motions, films);
  return cards.empty() ? "" : titled_section(title, card_grid(cards));
}

std::string findings_section(const Manifest& manifest, Motions& motions,
                             const FilmWarnings& films) {
  std::string rows;
  std::size_t count = 0;
  for (const Stimulus* stimulus : motion_sources(manifest)) {
    const Synthesis& made = motions.of(stimulus->id);
    if (made.findings.empty() && made.warnings.empty()) continue;
    ++count;
    const auto errors =
        std::ranges::count(made.findings, motion::Severity::error, &motion::Finding::severity);
    rows += fmt::format(
        "<tr><th scope=\"row\"><a href=\"{}\">{}</a></th><td>{}</td><td>{}</td><td>{}</td></tr>\n",
        link_to(*stimulus, manifest), html_escaped(stimulus->id), errors,
        static_cast<std::ptrdiff_t>(made.findings.size() + made.warnings.size()) - errors,
        html_escaped(first_found(made)));
  }
  for (const Stimulus* film : films_of(manifest)) {
    const auto found = films.find(film->id);
    if (found == films.end()) continue;
    ++count;
    rows += fmt::format(
        "<tr><th scope=\"row\">{} (film)</th><td>0</td><td>{}</td><td>{}</td></tr>\n",
        linked_film(*film, manifest), found->second.size(), html_escaped(found->second.front()));
  }
  if (rows.empty()) return "";
  constexpr std::size_t most_open = 12;
  const std::string table =
      html_table({"stimulus", ">errors", ">warnings", "first error, else first warning"}, rows);
  return titled_section(
      "Findings",
      count <= most_open
          ? table
          : fmt::format("<details><summary>{} stimuli</summary>\n{}</details>\n", count, table));
}

std::string stills_section(const Manifest& manifest, Motions& motions) {
  std::string stills;
  for (const Sheet& sheet : manifest.sheets) {
    if (!sheet.stills.empty()) stills += sheet_card(sheet, motions);
  }
  return stills.empty() ? "" : titled_section("Pictures", stills);
}

std::string comparisons_section(const std::string& title, std::span<const Sheet* const> sheets,
                                Motions& motions) {
  if (sheets.empty()) return "";
  std::string cards;
  for (const Sheet* sheet : sheets) cards += sheet_card(*sheet, motions);
  return titled_section(
      title, distance_table(sheets, motions) + feature_agreement_table(sheets, motions) + cards);
}

std::string parts_section(const std::vector<ReportPart>& parts, const Manifest& manifest) {
  std::string list;
  for (const ReportPart& part : parts) {
    list += fmt::format("<li><a href=\"{}\">{}</a>\n{}</li>\n", part.path(), part.title(),
                        part.kind == CardKind::stimulus ? linked_stimuli(part, manifest) : "");
  }
  return titled_section("Pages",
                        alike(manifest.equalize) + "<ul class=\"parts\">\n" + list + "</ul>\n");
}

}  // namespace mien::pipeline

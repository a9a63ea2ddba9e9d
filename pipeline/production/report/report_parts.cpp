#include "pipeline/production/report/report_parts.h"

#include <algorithm>

#include <fmt/format.h>

#include "pipeline/base/documents/html.h"
#include "pipeline/manifest/people.h"

namespace mien::pipeline {

namespace {

std::size_t count_of(CardKind kind, const Manifest& manifest) {
  switch (kind) {
    case CardKind::stimulus:
      return manifest.stimuli.size();
    case CardKind::overlay:
      return manifest.overlays.size();
    case CardKind::comparison:
      break;
  }
  return comparisons_in(manifest).size();
}

constexpr CardKind all_kinds[] = {CardKind::stimulus, CardKind::overlay, CardKind::comparison};

bool is_split(const Manifest& manifest) {
  return std::ranges::any_of(
      all_kinds, [&](CardKind kind) { return count_of(kind, manifest) > most_cards_on_a_page; });
}

}  // namespace

std::string ReportPart::path() const {
  const char* name = kind == CardKind::stimulus  ? "stimuli"
                     : kind == CardKind::overlay ? "overlays"
                                                 : "comparisons";
  return fmt::format("report/{}-{}.html", name, first / most_cards_on_a_page + 1);
}

std::string ReportPart::title() const {
  const char* name = kind == CardKind::stimulus  ? "Stimuli"
                     : kind == CardKind::overlay ? "Overlays"
                                                 : "Comparisons";
  return fmt::format("{} {}–{}", name, first + 1, end);
}

std::vector<ReportPart> report_parts(const Manifest& manifest) {
  std::vector<ReportPart> parts;
  if (!is_split(manifest)) return parts;
  for (const CardKind kind : all_kinds) {
    const std::size_t count = count_of(kind, manifest);
    for (std::size_t first = 0; first < count; first += most_cards_on_a_page)
      parts.push_back({kind, first, std::min(count, first + most_cards_on_a_page)});
  }
  return parts;
}

std::vector<const Sheet*> comparisons_in(const Manifest& manifest) {
  std::vector<const Sheet*> comparisons;
  for (const Sheet& sheet : manifest.sheets) {
    if (sheet.stills.empty()) comparisons.push_back(&sheet);
  }
  return comparisons;
}

std::string link_to(const Stimulus& stimulus, const Manifest& manifest) {
  const std::string anchor = "#" + html_escaped(stimulus.id);
  if (!is_split(manifest)) return anchor;
  const auto index =
      static_cast<std::size_t>(film_showing(manifest, stimulus.id) - manifest.stimuli.data());
  return ReportPart{CardKind::stimulus, index, index + 1}.path() + anchor;
}

}  // namespace mien::pipeline

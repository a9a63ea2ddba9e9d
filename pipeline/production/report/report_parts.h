#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

// The report of a large study is cut into pages, as no browser shows ten thousand films on one.

/// Cards of one kind that a page holds at most; a study with no more of any kind has one page.
inline constexpr std::size_t most_cards_on_a_page = 200;

enum class CardKind { stimulus, overlay, comparison };

/// Some of a study's cards of one kind, on a page of their own.
struct ReportPart {
  CardKind kind = CardKind::stimulus;
  std::size_t first = 0;  ///< among all of that kind
  std::size_t end = 0;    ///< after the last

  std::string path() const;   ///< "report/stimuli-1.html"
  std::string title() const;  ///< "Stimuli 1–200"
};

/// Pages beside report.html; none of a study that fits on it.
std::vector<ReportPart> report_parts(const Manifest& manifest);

/// Sheets that compare motions, and are no mere pictures.
std::vector<const Sheet*> comparisons_in(const Manifest& manifest);

/// Where the report has the card of one of the manifest's stimuli: "#a", "report/stimuli-1.html#a".
std::string link_to(const Stimulus& stimulus, const Manifest& manifest);

}  // namespace mien::pipeline

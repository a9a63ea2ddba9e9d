#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

// The report of a large study is split into pages, because no browser shows ten thousand films on
// one page.

/// Maximum number of cards of one kind on a page. A study that has at most this number of each kind
/// fits on a single page.
inline constexpr std::size_t most_cards_on_a_page = 200;

enum class CardKind { stimulus, overlay, comparison };

/// A range of a study's cards of one kind, on a page of its own.
struct ReportPart {
  CardKind kind = CardKind::stimulus;
  std::size_t first = 0;  ///< index among all cards of that kind
  std::size_t end = 0;    ///< one past the last index

  std::string path() const;   ///< "report/stimuli-1.html"
  std::string title() const;  ///< "Stimuli 1–200"
};

/// Returns the pages in addition to report.html; empty for a study that fits on one page.
std::vector<ReportPart> report_parts(const Manifest& manifest);

/// Returns the comparison sheets and galleries, that is, all sheets except those of stills.
std::vector<const Sheet*> comparisons_in(const Manifest& manifest);

/// Returns the link to a stimulus's card in the report: "#a", "report/stimuli-1.html#a". `stimulus`
/// must be an element of `manifest.stimuli`.
std::string link_to(const Stimulus& stimulus, const Manifest& manifest);

}  // namespace mien::pipeline

#pragma once

#include <cstddef>
#include <vector>

namespace mien::pipeline {

/// The outcomes of comparisons of two stimuli that were shown in the same order: `first` on the
/// left, or earlier. Stimuli are numbered from 0. A pair may occur in several counts, in both
/// orders.
struct PairCount {
  std::size_t first = 0;
  std::size_t second = 0;
  double first_wins = 0.0;  ///< number of choices of `first`
  double second_wins = 0.0;
  double ties = 0.0;

  double total() const { return first_wins + second_wins + ties; }
};

/// What the comparisons of a stimulus say about its worth.
enum class WinRecord {
  estimated,     ///< its worth can be compared with that of at least one other stimulus
  always_won,    ///< it won all of its comparisons: its worth has no upper bound
  always_lost,   ///< it lost all of its comparisons: its worth has no lower bound
  separated,     ///< it won all comparisons with some stimuli and lost all with the others
  not_compared,  ///< it was not compared with any other stimulus
};

/// Groups of stimuli whose worths can be compared.
struct WinGroups {
  /// Group of each stimulus, numbered from 0 in the order of their first stimuli.
  std::vector<std::size_t> group;
  std::vector<std::size_t> sizes;  ///< number of stimuli of each group
  std::vector<WinRecord> records;  ///< of each stimulus
  int compared = 0;                ///< number of stimuli with comparisons
  /// Number of parts into which the compared stimuli fall if those with any comparison, direct or
  /// through others, form a part.
  int parts = 0;
};

/// Divides stimuli into groups within which all worths are finite: the strongly connected
/// components of the graph with an edge from winner to loser, and edges in both directions for
/// ties. Within a group, no set of stimuli wins all comparisons with the rest of the group (Ford
/// 1957). Differences in worth between groups are infinite or unknown.
WinGroups win_groups(const std::vector<PairCount>& counts, std::size_t stimuli);

}  // namespace mien::pipeline

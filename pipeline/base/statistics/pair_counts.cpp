#include "pipeline/base/statistics/pair_counts.h"

#include <algorithm>
#include <limits>

namespace mien::pipeline {

namespace {

constexpr std::size_t no_group = std::numeric_limits<std::size_t>::max();

using Edges = std::vector<std::vector<std::size_t>>;

struct WinGraph {
  Edges losers;   ///< of each stimulus: those that it won against or tied with
  Edges winners;  ///< of each stimulus: those that won against it or tied with it
};

WinGraph graph_of(const std::vector<PairCount>& counts, std::size_t stimuli) {
  WinGraph graph{Edges(stimuli), Edges(stimuli)};
  const auto add = [&](std::size_t winner, std::size_t loser) {
    graph.losers[winner].push_back(loser);
    graph.winners[loser].push_back(winner);
  };
  for (const PairCount& count : counts) {
    if (count.first == count.second) continue;
    if (count.first_wins + count.ties > 0.0) add(count.first, count.second);
    if (count.second_wins + count.ties > 0.0) add(count.second, count.first);
  }
  return graph;
}

/// Gives `group` to all that can be reached from `from` through those without a group, and appends
/// them to `finished`, each after all that are reached through it.
void visit(std::size_t from, const Edges& edges, std::size_t group,
           std::vector<std::size_t>& groups, std::vector<std::size_t>& finished) {
  groups[from] = group;
  for (const std::size_t next : edges[from])
    if (groups[next] == no_group) visit(next, edges, group, groups, finished);
  finished.push_back(from);
}

/// Strongly connected components (Kosaraju 1978, Sharir 1981), as any numbers.
std::vector<std::size_t> components_of(const WinGraph& graph) {
  const std::size_t stimuli = graph.losers.size();
  std::vector<std::size_t> visited(stimuli, no_group);
  std::vector<std::size_t> finished;
  for (std::size_t i = 0; i < stimuli; ++i)
    if (visited[i] == no_group) visit(i, graph.losers, 0, visited, finished);
  std::vector<std::size_t> groups(stimuli, no_group);
  std::vector<std::size_t> ignored;
  for (std::size_t k = stimuli; k-- > 0;)
    if (groups[finished[k]] == no_group)
      visit(finished[k], graph.winners, finished[k], groups, ignored);
  return groups;
}

/// Renumbers groups from 0 in the order in which they occur.
void number_in_order(std::vector<std::size_t>& groups, std::vector<std::size_t>& sizes) {
  std::vector<std::size_t> known;
  for (std::size_t& group : groups) {
    const auto found = std::ranges::find(known, group);
    const auto number = static_cast<std::size_t>(found - known.begin());
    if (found == known.end()) {
      known.push_back(group);
      sizes.push_back(0);
    }
    group = number;
    ++sizes[number];
  }
}

int parts_of(const WinGraph& graph) {
  Edges both = graph.losers;
  for (std::size_t i = 0; i < both.size(); ++i)
    both[i].insert(both[i].end(), graph.winners[i].begin(), graph.winners[i].end());
  std::vector<std::size_t> parts(both.size(), no_group);
  std::vector<std::size_t> ignored;
  int count = 0;
  for (std::size_t i = 0; i < both.size(); ++i) {
    if (both[i].empty() || parts[i] != no_group) continue;
    visit(i, both, 0, parts, ignored);
    ++count;
  }
  return count;
}

WinRecord record_of(std::size_t stimulus, const WinGraph& graph, std::size_t group_size) {
  if (group_size > 1) return WinRecord::estimated;
  const bool won = !graph.losers[stimulus].empty();
  const bool lost = !graph.winners[stimulus].empty();
  if (won) return lost ? WinRecord::separated : WinRecord::always_won;
  return lost ? WinRecord::always_lost : WinRecord::not_compared;
}

}  // namespace

WinGroups win_groups(const std::vector<PairCount>& counts, std::size_t stimuli) {
  const WinGraph graph = graph_of(counts, stimuli);
  WinGroups result;
  result.group = components_of(graph);
  number_in_order(result.group, result.sizes);
  for (std::size_t i = 0; i < stimuli; ++i) {
    result.records.push_back(record_of(i, graph, result.sizes[result.group[i]]));
    result.compared += result.records.back() == WinRecord::not_compared ? 0 : 1;
  }
  result.parts = parts_of(graph);
  return result;
}

}  // namespace mien::pipeline

#include "motion/motion_graph/strong_components.h"

#include <algorithm>

namespace mien::motion {

namespace {

constexpr int unseen = -1;

/// The state of Tarjan's search.
struct Search {
  std::vector<int> order;
  std::vector<int> lowest;
  std::vector<int> component;
  std::vector<int> open;  ///< nodes without a component yet
  int seen = 0;
  int components = 0;
};

void enter(Search& search, int node) {
  const auto n = static_cast<std::size_t>(node);
  search.order[n] = search.lowest[n] = search.seen++;
  search.open.push_back(node);
}

void close(Search& search, int node) {
  const auto n = static_cast<std::size_t>(node);
  if (search.lowest[n] != search.order[n]) return;
  for (int other = -1; other != node;) {
    other = search.open.back();
    search.open.pop_back();
    search.component[static_cast<std::size_t>(other)] = search.components;
  }
  ++search.components;
}

}  // namespace

std::vector<int> strong_components(std::span<const std::vector<int>> leaving) {
  const std::size_t count = leaving.size();
  Search search{std::vector<int>(count, unseen),
                std::vector<int>(count, 0),
                std::vector<int>(count, unseen),
                {}};
  struct Visit {
    int node;
    std::size_t next = 0;
  };
  for (std::size_t root = 0; root < count; ++root) {
    if (search.order[root] != unseen) continue;
    std::vector<Visit> visits = {{static_cast<int>(root)}};
    enter(search, static_cast<int>(root));
    while (!visits.empty()) {
      Visit& visit = visits.back();
      const auto n = static_cast<std::size_t>(visit.node);
      if (visit.next < leaving[n].size()) {
        const int to = leaving[n][visit.next++];
        const auto t = static_cast<std::size_t>(to);
        if (search.order[t] == unseen) {
          enter(search, to);
          visits.push_back({to});
        } else if (search.component[t] == unseen) {
          search.lowest[n] = std::min(search.lowest[n], search.order[t]);
        }
        continue;
      }
      close(search, visit.node);
      visits.pop_back();
      if (!visits.empty()) {
        const auto above = static_cast<std::size_t>(visits.back().node);
        search.lowest[above] = std::min(search.lowest[above], search.lowest[n]);
      }
    }
  }
  return search.component;
}

}  // namespace mien::motion

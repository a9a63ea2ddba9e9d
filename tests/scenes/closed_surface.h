#pragma once

#include <array>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace mien::test {

/// What a list of triangles is as a surface.
struct Topology {
  int bad_edges = 0;  ///< directed edges that do not have exactly one partner the other way round
  int euler = 0;      ///< vertices used − edges + triangles; 2 for one ball
};

inline Topology topology_of(const std::vector<std::array<int, 3>>& triangles) {
  std::map<std::pair<int, int>, int> edges;
  std::set<int> vertices;
  for (const auto& t : triangles) {
    for (size_t i = 0; i < 3; ++i) {
      ++edges[{t[i], t[(i + 1) % 3]}];
      vertices.insert(t[i]);
    }
  }
  Topology topology;
  for (const auto& [edge, count] : edges) {
    const auto partner = edges.find({edge.second, edge.first});
    if (count != 1 || partner == edges.end() || partner->second != 1) ++topology.bad_edges;
  }
  topology.euler = static_cast<int>(vertices.size()) - static_cast<int>(edges.size() / 2) +
                   static_cast<int>(triangles.size());
  return topology;
}

}  // namespace mien::test

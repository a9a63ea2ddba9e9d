#pragma once

#include <span>
#include <vector>

namespace mien::motion {

/// Number of the strongly connected component of each node of a directed graph, from 0; nodes of
/// one component reach each other (Tarjan 1972, without recursion). `leaving[n]` are the nodes to
/// which an edge leads from n.
std::vector<int> strong_components(std::span<const std::vector<int>> leaving);

}  // namespace mien::motion

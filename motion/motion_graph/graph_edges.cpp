#include "motion/motion_graph/graph_edges.h"

#include <algorithm>
#include <map>
#include <utility>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/strong_components.hpp>

namespace mien::motion {

namespace {

void add_transition(MotionGraph& graph, int from_clip, int from_frame, int to_clip, int to_frame,
                    double metres) {
  // What is entered has to go on after the blend.
  const Clip& to = graph.clips[static_cast<std::size_t>(to_clip)];
  if (to_frame + graph.window >= to.frame_count()) return;
  graph.transitions.push_back({from_clip, from_frame, to_clip, to_frame, metres});
}

/// Numbers of the nodes by clip and frame, ordered.
using NodeNumbers = std::map<std::pair<int, int>, int>;

NodeNumbers node_numbers(const MotionGraph& graph) {
  NodeNumbers numbers;
  for (const GraphTransition& t : graph.transitions) {
    numbers[{t.from_clip, t.from_frame}] = 0;
    numbers[{t.to_clip, t.to_frame + graph.window}] = 0;
  }
  int number = 0;
  for (auto& [place, node] : numbers) node = number++;
  return numbers;
}

void add_nodes_and_edges(MotionGraph& graph) {
  const NodeNumbers numbers = node_numbers(graph);
  for (const auto& [place, node] : numbers) graph.nodes.push_back({place.first, place.second});
  for (std::size_t n = 0; n + 1 < graph.nodes.size(); ++n) {
    const GraphNode& here = graph.nodes[n];
    const GraphNode& next = graph.nodes[n + 1];
    if (here.clip != next.clip) continue;
    graph.edges.push_back(
        {static_cast<int>(n), static_cast<int>(n) + 1, -1, next.frame - here.frame});
  }
  for (std::size_t t = 0; t < graph.transitions.size(); ++t) {
    const GraphTransition& way = graph.transitions[t];
    graph.edges.push_back({numbers.at({way.from_clip, way.from_frame}),
                           numbers.at({way.to_clip, way.to_frame + graph.window}),
                           static_cast<int>(t), graph.window});
  }
}

/// Number of the strongly connected component of each node: nodes of one reach each other.
std::vector<int> strong_components(const MotionGraph& graph) {
  using Ways = boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS>;
  Ways ways(graph.nodes.size());
  for (const GraphEdge& edge : graph.edges) {
    add_edge(static_cast<std::size_t>(edge.from), static_cast<std::size_t>(edge.to), ways);
  }
  std::vector<int> component(graph.nodes.size());
  boost::strong_components(
      ways, boost::make_iterator_property_map(component.begin(), get(boost::vertex_index, ways)));
  return component;
}

/// The component with the most frames on edges within it, and how many they are.
std::pair<int, int> largest_component(const MotionGraph& graph, const std::vector<int>& component) {
  std::map<int, int> frames;
  for (const GraphEdge& edge : graph.edges) {
    const int from = component[static_cast<std::size_t>(edge.from)];
    if (from == component[static_cast<std::size_t>(edge.to)]) frames[from] += edge.frames;
  }
  std::pair<int, int> largest = {-1, 0};
  for (const auto& [number, count] : frames) {
    if (count > largest.second) largest = {number, count};
  }
  return largest;
}

/// Removes all nodes except those marked, their edges and unused transitions. A node with only one
/// way to go on is kept, which is harmless.
void keep(MotionGraph& graph, const std::vector<bool>& kept) {
  std::vector<int> number(graph.nodes.size(), -1);
  std::vector<GraphNode> nodes;
  for (std::size_t n = 0; n < graph.nodes.size(); ++n) {
    if (!kept[n]) continue;
    number[n] = static_cast<int>(nodes.size());
    nodes.push_back(graph.nodes[n]);
  }
  std::vector<GraphEdge> edges;
  std::vector<GraphTransition> transitions;
  for (GraphEdge edge : graph.edges) {
    edge.from = number[static_cast<std::size_t>(edge.from)];
    edge.to = number[static_cast<std::size_t>(edge.to)];
    if (edge.from < 0 || edge.to < 0) continue;
    if (edge.transition >= 0) {
      transitions.push_back(graph.transitions[static_cast<std::size_t>(edge.transition)]);
      edge.transition = static_cast<int>(transitions.size()) - 1;
    }
    edges.push_back(edge);
  }
  graph.nodes = std::move(nodes);
  graph.edges = std::move(edges);
  graph.transitions = std::move(transitions);
}

}  // namespace

int connect(MotionGraph& graph, std::span<const DistanceMinimum> minima, double threshold_m) {
  graph.transitions.clear();
  graph.nodes.clear();
  graph.edges.clear();
  graph.leaving.clear();
  for (const DistanceMinimum& m : minima) {
    if (m.metres > threshold_m) continue;
    add_transition(graph, m.clip_a, m.frame_a, m.clip_b, m.frame_b, m.metres);
    add_transition(graph, m.clip_b, m.frame_b, m.clip_a, m.frame_a, m.metres);
  }
  add_nodes_and_edges(graph);
  const std::vector<int> component = strong_components(graph);
  const auto [number, frames] = largest_component(graph, component);
  std::vector<bool> kept;
  for (const int of_node : component) kept.push_back(of_node == number);
  keep(graph, kept);
  graph.leaving.resize(graph.nodes.size());
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    graph.leaving[static_cast<std::size_t>(graph.edges[e].from)].push_back(static_cast<int>(e));
  }
  return frames;
}

}  // namespace mien::motion

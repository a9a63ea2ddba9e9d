#include "motion/formats/gltf/gltf_nodes.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace mien::motion {

namespace {

std::string title(int node) { return "node " + std::to_string(node); }

/// The numbers when there are `count`, all usable; false when there are none.
bool parse_numbers(const GltfFile& file, int node, const std::vector<double>& numbers,
                   size_t count) {
  if (numbers.empty()) return false;
  const bool usable = std::all_of(numbers.begin(), numbers.end(),
                                  [](double n) { return std::isfinite(n) && std::abs(n) <= 1e12; });
  if (numbers.size() != count || !usable) {
    refuse(file, title(node) + " has a faulty transform", get_it_again);
  }
  return true;
}

NodeTransform split(const std::vector<double>& matrix) {
  const Eigen::Map<const Eigen::Matrix4d> m(matrix.data());
  NodeTransform transform;
  transform.translation = m.topRightCorner<3, 1>();
  Mat3 axes = m.topLeftCorner<3, 3>();
  transform.scale = axes.colwise().norm();
  if (axes.determinant() < 0.0) transform.scale.x() = -transform.scale.x();
  if ((transform.scale.array().abs() < 1e-12).any()) return transform;
  axes = axes * transform.scale.cwiseInverse().asDiagonal();
  transform.rotation = Quat(axes).normalized();
  return transform;
}

NodeTransform transform_of(const GltfFile& file, int index) {
  const tinygltf::Node& node = file.model.nodes[static_cast<size_t>(index)];
  NodeTransform transform;
  if (parse_numbers(file, index, node.matrix, 16)) return split(node.matrix);
  if (parse_numbers(file, index, node.translation, 3)) {
    transform.translation = Vec3(node.translation.data());
  }
  if (parse_numbers(file, index, node.scale, 3)) transform.scale = Vec3(node.scale.data());
  if (parse_numbers(file, index, node.rotation, 4)) {
    transform.rotation = Quat(node.rotation.data());
    if (!(transform.rotation.norm() > 1e-6)) {
      refuse(file, title(index) + " has a rotation of length zero", get_it_again);
    }
    transform.rotation.normalize();
  }
  return transform;
}

void link(const GltfFile& file, int parent, GltfNodes& nodes) {
  for (const int child : file.model.nodes[static_cast<size_t>(parent)].children) {
    if (child < 0 || child >= nodes.size()) {
      refuse(file, title(parent) + " has a child that does not exist", get_it_again);
    }
    if (nodes.parents[static_cast<size_t>(child)] != -1) {
      refuse(file, title(child) + " has two parents", get_it_again);
    }
    nodes.parents[static_cast<size_t>(child)] = parent;
    nodes.children[static_cast<size_t>(parent)].push_back(child);
  }
}

std::vector<int> depth_first(const GltfNodes& nodes, std::vector<int> roots) {
  std::vector<int> order;
  std::reverse(roots.begin(), roots.end());
  for (std::vector<int> waiting = std::move(roots); !waiting.empty();) {
    const int node = waiting.back();
    waiting.pop_back();
    order.push_back(node);
    const std::vector<int>& children = nodes.children[static_cast<size_t>(node)];
    waiting.insert(waiting.end(), children.rbegin(), children.rend());
  }
  return order;
}

/// How many of `wanted` are at or below each node.
std::vector<int> counts_below(const GltfNodes& nodes, const std::vector<int>& wanted) {
  std::vector<int> counts(nodes.parents.size(), 0);
  for (const int node : wanted) counts[static_cast<size_t>(node)] = 1;
  for (auto node = nodes.parents_first.rbegin(); node != nodes.parents_first.rend(); ++node) {
    const int parent = nodes.parents[static_cast<size_t>(*node)];
    if (parent >= 0) counts[static_cast<size_t>(parent)] += counts[static_cast<size_t>(*node)];
  }
  return counts;
}

}  // namespace

GltfNodes parse_nodes(const GltfFile& file) {
  GltfNodes nodes;
  const size_t count = file.model.nodes.size();
  nodes.parents.assign(count, -1);
  nodes.children.resize(count);
  std::vector<int> roots;
  for (int node = 0; node < nodes.size(); ++node) {
    nodes.at_rest.push_back(transform_of(file, node));
    link(file, node, nodes);
  }
  for (int node = 0; node < nodes.size(); ++node) {
    if (nodes.parents[static_cast<size_t>(node)] == -1) roots.push_back(node);
  }
  nodes.parents_first = depth_first(nodes, std::move(roots));
  if (nodes.parents_first.size() != count) {
    refuse(file, "nodes are their own descendants", get_it_again);
  }
  return nodes;
}

int common_root(const GltfFile& file, const GltfNodes& nodes, const std::vector<int>& wanted) {
  const std::vector<int> counts = counts_below(nodes, wanted);
  const int all = static_cast<int>(wanted.size());
  // Of the nodes above all, each is below the one before.
  int root = -1;
  for (const int node : nodes.parents_first) {
    if (counts[static_cast<size_t>(node)] == all) root = node;
  }
  if (root == -1) {
    refuse(file, "the joints are not connected", "join them under one root node");
  }
  return root;
}

std::vector<int> nodes_between(const GltfNodes& nodes, int root, const std::vector<int>& wanted) {
  const std::vector<int> counts = counts_below(nodes, wanted);
  std::vector<int> between = depth_first(nodes, {root});
  std::erase_if(between, [&](int node) { return counts[static_cast<size_t>(node)] == 0; });
  return between;
}

}  // namespace mien::motion

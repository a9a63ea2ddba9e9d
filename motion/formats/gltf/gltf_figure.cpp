#include "motion/formats/gltf/gltf_figure.h"

#include <algorithm>
#include <cctype>
#include <set>
#include <string_view>

#include "motion/formats/reading/chosen_figure.h"

namespace mien::motion {

namespace {

std::string title_of(const GltfFile& file, int node) {
  const std::string& name = file.model.nodes[static_cast<size_t>(node)].name;
  return name.empty() ? "node " + std::to_string(node) : name;
}

void sort_unique(std::vector<int>& nodes) {
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
}

bool is_at_or_below(const GltfNodes& nodes, int node, int top) {
  while (node >= 0 && node != top) node = nodes.parents[static_cast<size_t>(node)];
  return node == top;
}

/// A node and all that hangs on it, parents first.
std::vector<int> below(const GltfNodes& nodes, int top) {
  std::vector<int> found;
  std::vector<bool> inside(nodes.parents.size(), false);
  for (const int node : nodes.parents_first) {
    const int parent = nodes.parents[static_cast<size_t>(node)];
    if (node != top && (parent < 0 || !inside[static_cast<size_t>(parent)])) continue;
    inside[static_cast<size_t>(node)] = true;
    found.push_back(node);
  }
  return found;
}

/// Joints that belong together, and the root that they hang on.
struct JointSet {
  int root = -1;
  std::vector<int> joints;
};

JointSet joints_of_skin(const GltfFile& file, const GltfNodes& nodes, const tinygltf::Skin& skin) {
  JointSet set{-1, skin.joints};
  for (const int joint : set.joints) {
    if (joint < 0 || joint >= nodes.size()) {
      refuse(file, "the skin has a joint that does not exist", "export the file again");
    }
  }
  sort_unique(set.joints);
  set.root = common_root(file, nodes, set.joints);
  return set;
}

bool belong_together(const GltfNodes& nodes, const JointSet& a, const JointSet& b) {
  return is_at_or_below(nodes, a.root, b.root) || is_at_or_below(nodes, b.root, a.root);
}

/// The skins' joints, figure by figure.
std::vector<JointSet> skinned_figures(const GltfFile& file, const GltfNodes& nodes) {
  constexpr size_t most_skins = 256;
  std::vector<JointSet> figures;
  for (size_t s = 0; s < std::min(most_skins, file.model.skins.size()); ++s) {
    const tinygltf::Skin& skin = file.model.skins[s];
    if (skin.joints.empty()) continue;
    JointSet set = joints_of_skin(file, nodes, skin);
    for (auto known = figures.begin(); known != figures.end();) {
      if (!belong_together(nodes, *known, set)) {
        ++known;
        continue;
      }
      set.joints.insert(set.joints.end(), known->joints.begin(), known->joints.end());
      sort_unique(set.joints);
      set.root = common_root(file, nodes, set.joints);
      known = figures.erase(known);
    }
    figures.push_back(std::move(set));
  }
  return figures;
}

/// The bones of a VRM file, without the joints of hair and clothes. Empty if it is no such file.
std::vector<JointSet> human_figure(const GltfFile& file, const GltfNodes& nodes,
                                   std::vector<std::string>& notes) {
  if (file.human_nodes.empty()) return {};
  JointSet figure{-1, file.human_nodes};
  sort_unique(figure.joints);
  figure.root = common_root(file, nodes, figure.joints);
  std::vector<int> others;
  for (const tinygltf::Skin& skin : file.model.skins)
    others.insert(others.end(), skin.joints.begin(), skin.joints.end());
  sort_unique(others);
  const std::vector<int> kept = nodes_between(nodes, figure.root, figure.joints);
  const std::set<int> inside(kept.begin(), kept.end());
  const auto left_out =
      std::ranges::count_if(others, [&](int joint) { return !inside.contains(joint); });
  if (left_out > 0)
    notes.push_back("The bones of the body are read, without " + std::to_string(left_out) +
                    (left_out == 1 ? " other joint" : " other joints") +
                    ", such as those of hair and clothes.");
  return {std::move(figure)};
}

/// An end as exporters of bones write it: "Head_end", "ToeNub".
bool is_called_end(std::string_view name) {
  std::string lower;
  for (const char c : name) lower += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return lower.ends_with("end") || lower.ends_with("nub") || lower.ends_with("tip");
}

/// Without what is no joint: cameras, and ends of bones, which are tips.
std::vector<int> joints_of_tree(const GltfFile& file, const GltfNodes& nodes,
                                const std::vector<bool>& moved, int root) {
  std::vector<int> joints;
  for (const int node : below(nodes, root)) {
    const tinygltf::Node& given = file.model.nodes[static_cast<size_t>(node)];
    const bool is_still_leaf =
        !moved[static_cast<size_t>(node)] && nodes.children[static_cast<size_t>(node)].empty();
    const int parent = nodes.parents[static_cast<size_t>(node)];
    const bool is_tip = is_still_leaf && parent >= 0 && is_called_end(given.name) &&
                        tip_node(file, nodes, moved, parent) == node;
    if (is_tip || (is_still_leaf && given.camera >= 0)) continue;
    joints.push_back(node);
  }
  return joints;
}

/// Down to the first node that moves or forks: what lies above is no joint.
int first_joint(const GltfNodes& nodes, const std::vector<bool>& moved,
                const std::vector<int>& joints) {
  std::vector<std::vector<int>> children(nodes.parents.size());
  for (const int node : joints) {
    const int parent = nodes.parents[static_cast<size_t>(node)];
    if (node != joints.front()) children[static_cast<size_t>(parent)].push_back(node);
  }
  int first = joints.front();
  while (!moved[static_cast<size_t>(first)] && children[static_cast<size_t>(first)].size() == 1) {
    first = children[static_cast<size_t>(first)].front();
  }
  return first;
}

/// The trees of nodes that tracks move.
std::vector<JointSet> moving_trees(const GltfFile& file, const GltfNodes& nodes,
                                   const std::vector<GltfTrack>& tracks) {
  const std::vector<bool> moved = moved_nodes(nodes, tracks);
  std::vector<int> tops;
  for (const GltfTrack& track : tracks) {
    int top = track.node;
    while (nodes.parents[static_cast<size_t>(top)] >= 0) {
      top = nodes.parents[static_cast<size_t>(top)];
    }
    if (std::ranges::find(tops, top) == tops.end()) tops.push_back(top);
  }
  std::sort(tops.begin(), tops.end());
  std::vector<JointSet> trees;
  for (const int top : tops) {
    JointSet tree{top, joints_of_tree(file, nodes, moved, top)};
    tree.root = first_joint(nodes, moved, tree.joints);
    const std::vector<int> kept = below(nodes, tree.root);
    const std::set<int> inside(kept.begin(), kept.end());
    std::erase_if(tree.joints, [&](int node) { return !inside.contains(node); });
    trees.push_back(std::move(tree));
  }
  return trees;
}

/// The figure that is asked for, else the one with the most joints.
JointSet chosen(const GltfFile& file, std::vector<JointSet> figures,
                const std::optional<std::string>& wanted, Recording& recording) {
  const auto by_size = [](const JointSet& a, const JointSet& b) {
    return a.joints.size() < b.joints.size();
  };
  const int largest = std::ranges::max_element(figures, by_size)->root;
  // A prop that moves is no figure.
  std::erase_if(figures,
                [&](const JointSet& set) { return set.joints.size() < 2 && set.root != largest; });
  std::vector<std::string> names;
  for (const JointSet& figure : figures) names.push_back(title_of(file, figure.root));
  const auto usual = std::ranges::find(figures, largest, &JointSet::root) - figures.begin();
  return std::move(
      figures[chosen_figure({file.name}, names, static_cast<size_t>(usual), wanted, recording)]);
}

}  // namespace

std::vector<bool> moved_nodes(const GltfNodes& nodes, const std::vector<GltfTrack>& tracks) {
  std::vector<bool> moved(nodes.parents.size(), false);
  for (const GltfTrack& track : tracks) moved[static_cast<size_t>(track.node)] = true;
  return moved;
}

int tip_node(const GltfFile& file, const GltfNodes& nodes, const std::vector<bool>& moved,
             int joint) {
  const std::vector<int>& children = nodes.children[static_cast<size_t>(joint)];
  const std::string named = file.model.nodes[static_cast<size_t>(joint)].name + "_end";
  for (const int child : children) {
    const auto index = static_cast<size_t>(child);
    const tinygltf::Node& node = file.model.nodes[index];
    const bool is_end = nodes.children[index].empty() && node.mesh < 0 && node.camera < 0;
    if (is_end && !moved[index] && (children.size() == 1 || node.name == named)) return child;
  }
  return -1;
}

GltfFigure gltf_figure(const GltfFile& file, const GltfNodes& nodes,
                       const std::vector<GltfTrack>& tracks,
                       const std::optional<std::string>& wanted, Recording& recording) {
  std::vector<JointSet> figures = human_figure(file, nodes, recording.notes);
  if (figures.empty()) figures = skinned_figures(file, nodes);
  if (figures.empty()) figures = moving_trees(file, nodes, tracks);
  if (figures.empty()) {
    refuse(file, "there is neither a skin nor an animation", "export the armature with its motion");
  }
  const JointSet set = chosen(file, std::move(figures), wanted, recording);
  GltfFigure figure;
  figure.joints = nodes_between(nodes, set.root, set.joints);
  for (int node = nodes.parents[static_cast<size_t>(set.root)]; node >= 0;
       node = nodes.parents[static_cast<size_t>(node)]) {
    figure.above.push_back(node);
  }
  std::reverse(figure.above.begin(), figure.above.end());
  std::vector<int> joint_of_node(nodes.parents.size(), -1);
  for (const int node : figure.joints) {
    const int parent = nodes.parents[static_cast<size_t>(node)];
    figure.parents.push_back(parent < 0 ? -1 : joint_of_node[static_cast<size_t>(parent)]);
    joint_of_node[static_cast<size_t>(node)] = static_cast<int>(figure.parents.size()) - 1;
  }
  return figure;
}

}  // namespace mien::motion

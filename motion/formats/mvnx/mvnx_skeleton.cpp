#include "motion/formats/mvnx/mvnx_skeleton.h"

#include <map>
#include <set>
#include <string_view>

#include "motion/formats/mvnx/mvnx_hands.h"

namespace mien::motion {

namespace {

/// A segment of MVN's body and the one that it hangs on.
struct StandardSegment {
  std::string_view label;
  std::string_view parent;
};

/// In the order of the numbers of a frame (MVN User Manual).
constexpr StandardSegment standard_segments[] = {
    {"Pelvis", ""},
    {"L5", "Pelvis"},
    {"L3", "L5"},
    {"T12", "L3"},
    {"T8", "T12"},
    {"Neck", "T8"},
    {"Head", "Neck"},
    {"RightShoulder", "T8"},
    {"RightUpperArm", "RightShoulder"},
    {"RightForeArm", "RightUpperArm"},
    {"RightHand", "RightForeArm"},
    {"LeftShoulder", "T8"},
    {"LeftUpperArm", "LeftShoulder"},
    {"LeftForeArm", "LeftUpperArm"},
    {"LeftHand", "LeftForeArm"},
    {"RightUpperLeg", "Pelvis"},
    {"RightLowerLeg", "RightUpperLeg"},
    {"RightFoot", "RightLowerLeg"},
    {"RightToe", "RightFoot"},
    {"LeftUpperLeg", "Pelvis"},
    {"LeftLowerLeg", "LeftUpperLeg"},
    {"LeftFoot", "LeftLowerLeg"},
    {"LeftToe", "LeftFoot"},
};

using Children = std::vector<std::vector<std::size_t>>;

std::map<std::string_view, std::size_t> indices_of(const MvnxSubject& subject) {
  std::map<std::string_view, std::size_t> indices;
  for (std::size_t s = 0; s < subject.segments.size(); ++s)
    indices.emplace(subject.segments[s].label, s);
  return indices;
}

/// Links between segments that both exist, as {parent, child}.
std::vector<std::pair<std::size_t, std::size_t>> links_of(const MvnxSubject& subject) {
  const auto indices = indices_of(subject);
  std::vector<std::pair<std::size_t, std::size_t>> links;
  const auto add = [&](std::string_view parent, std::string_view child) {
    const auto above = indices.find(parent);
    const auto below = indices.find(child);
    if (above != indices.end() && below != indices.end())
      links.emplace_back(above->second, below->second);
  };
  for (const MvnxJoint& joint : subject.joints) add(joint.parent, joint.child);
  if (links.empty()) {
    for (const StandardSegment& segment : standard_segments) add(segment.parent, segment.label);
  }
  std::set<std::size_t> linked;
  for (const auto& [parent, child] : links) linked.insert(child);
  for (const auto& [label, child] : indices)
    if (!linked.contains(child)) add(parent_in_mvn_hand(label), label);
  return links;
}

/// A segment and all that hangs on it, parents first.
std::vector<std::size_t> below(const Children& children, std::size_t root) {
  std::vector<std::size_t> found;
  std::vector<std::size_t> waiting = {root};
  while (!waiting.empty()) {
    const std::size_t segment = waiting.back();
    waiting.pop_back();
    found.push_back(segment);
    const std::vector<std::size_t>& own = children[segment];
    waiting.insert(waiting.end(), own.rbegin(), own.rend());
  }
  return found;
}

}  // namespace

void name_segments(const TextCursor& cursor, std::size_t count, MvnxSubject& subject) {
  if (!subject.segments.empty()) return;
  if (count != std::size(standard_segments))
    fail(cursor, subject.place,
         "the segments are not named, and there are " + std::to_string(count) +
             " of them instead of the usual 23",
         "export the list of segments too");
  for (const StandardSegment& segment : standard_segments)
    subject.segments.push_back({std::string(segment.label), std::nullopt});
}

MvnxTree mvnx_tree(const TextCursor& cursor, const MvnxSubject& subject) {
  const std::size_t count = subject.segments.size();
  Children children(count);
  std::vector<bool> hangs(count, false);
  for (const auto& [parent, child] : links_of(subject)) {
    if (hangs[child])
      fail(cursor, subject.place,
           "segment " + in_quotes(subject.segments[child].label) + " has two parents",
           "export the file again");
    hangs[child] = true;
    children[parent].push_back(child);
  }
  MvnxTree tree;
  // Those in a circle all hang, so each that is walked through is a tree.
  for (std::size_t s = 0; s < count; ++s) {
    if (hangs[s]) continue;
    std::vector<std::size_t> hanging = below(children, s);
    if (hanging.size() > tree.segments.size()) tree.segments = std::move(hanging);
  }
  if (tree.segments.size() < 2)
    fail(cursor, subject.place, "the segments are not connected by joints",
         "export the list of joints too");
  std::vector<int> place_in_tree(count, -1);
  tree.parents.assign(tree.segments.size(), -1);
  for (std::size_t t = 0; t < tree.segments.size(); ++t)
    place_in_tree[tree.segments[t]] = static_cast<int>(t);
  for (std::size_t s = 0; s < count; ++s) {
    if (place_in_tree[s] < 0) tree.left_out.push_back(subject.segments[s].label);
    for (const std::size_t child : children[s]) {
      if (place_in_tree[child] > 0)
        tree.parents[static_cast<std::size_t>(place_in_tree[child])] = place_in_tree[s];
    }
  }
  return tree;
}

}  // namespace mien::motion

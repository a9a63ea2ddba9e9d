#include "motion/formats/c3d/c3d_segments.h"

#include <algorithm>
#include <optional>

#include "motion/error.h"
#include "motion/text/excerpt.h"
#include "motion/text/text_cursor.h"

namespace mien::motion {

namespace {

/// A segment of Theia's model and its parent; where that is not in the file, the parent's parent.
struct ModelSegment {
  std::string_view name;
  std::string_view parent;
};

constexpr ModelSegment model[] = {
    {"abdomen", "pelvis"}, {"torso", "abdomen"},    {"thorax", "abdomen"},    {"neck", "torso"},
    {"head", "neck"},      {"l_clavicle", "torso"}, {"l_uarm", "l_clavicle"}, {"l_larm", "l_uarm"},
    {"l_hand", "l_larm"},  {"r_clavicle", "torso"}, {"r_uarm", "r_clavicle"}, {"r_larm", "r_uarm"},
    {"r_hand", "r_larm"},  {"l_thigh", "pelvis"},   {"l_shank", "l_thigh"},   {"l_foot", "l_shank"},
    {"l_toes", "l_foot"},  {"r_thigh", "pelvis"},   {"r_shank", "r_thigh"},   {"r_foot", "r_shank"},
    {"r_toes", "r_foot"},
};

int index_of(const std::vector<SegmentMotion>& segments, std::string_view name) {
  for (std::size_t i = 0; i < segments.size(); ++i) {
    if (same_word(segments[i].name, name)) return static_cast<int>(i);
  }
  return -1;
}

std::optional<std::string_view> parent_in_model(std::string_view name) {
  for (const ModelSegment& segment : model) {
    if (same_word(segment.name, name)) return segment.parent;
  }
  return std::nullopt;
}

/// The nearest ancestor in the model that is in the file, else the root, which is segment 0.
int parent_of(const std::vector<SegmentMotion>& segments, const std::string& name) {
  for (auto parent = parent_in_model(name); parent; parent = parent_in_model(*parent)) {
    const int found = index_of(segments, *parent);
    if (found >= 0) return found;
  }
  return 0;
}

/// Parents first: by the number of ancestors, otherwise in the order of the file.
std::vector<SegmentMotion> parents_first(std::vector<SegmentMotion> segments) {
  const int pelvis = index_of(segments, "pelvis");
  if (pelvis > 0)
    std::rotate(segments.begin(), segments.begin() + pelvis, segments.begin() + pelvis + 1);
  const auto depth = [](const SegmentMotion& segment) {
    int ancestors = 0;
    for (auto parent = parent_in_model(segment.name); parent; parent = parent_in_model(*parent))
      ++ancestors;
    return ancestors;
  };
  std::stable_sort(
      segments.begin() + 1, segments.end(),
      [&](const SegmentMotion& a, const SegmentMotion& b) { return depth(a) < depth(b); });
  return segments;
}

std::vector<SegmentMotion> found_segments(const C3dFile& file, std::vector<SegmentMotion> segments,
                                          std::vector<std::string>& notes) {
  std::vector<std::string> filled;
  std::vector<std::string> absent;
  for (const SegmentMotion& segment : segments) {
    if (segment.transforms.empty()) {
      absent.push_back(segment.name);
    } else if (segment.missing > 0) {
      filled.push_back(segment.name + " (" + std::to_string(segment.missing) + ")");
    }
  }
  std::erase_if(segments, [](const SegmentMotion& s) { return s.transforms.empty(); });
  if (segments.empty())
    throw Error({file.name}, "no segment is found in any frame", "export the file again");
  if (!absent.empty()) {
    notes.push_back("Left out, since they are found in no frame: " + listed(absent) + ".");
  }
  if (!filled.empty()) {
    notes.push_back("Segments are missing in some frames, where they are interpolated or held: " +
                    listed(filled) + ".");
  }
  return segments;
}

}  // namespace

std::string segment_name(std::string_view label) {
  constexpr std::string_view ending = "_4X4";
  if (label.size() > ending.size() &&
      same_word(label.substr(label.size() - ending.size()), ending)) {
    label.remove_suffix(ending.size());
  }
  return std::string(label);
}

bool is_no_segment(std::string_view name) {
  return same_word(name, "worldbody") || same_word(name, "pelvis_shifted");
}

void set_segments(const C3dFile& file, std::vector<SegmentMotion> given, Recording& recording) {
  const std::vector<SegmentMotion> segments =
      parents_first(found_segments(file, std::move(given), recording.notes));
  std::vector<Joint>& joints = recording.skeleton.joints;
  for (const SegmentMotion& segment : segments) {
    joints.push_back({segment.name, joints.empty() ? -1 : parent_of(segments, segment.name),
                      Vec3::Zero(), std::nullopt});
  }
  recording.poses.resize(segments.front().transforms.size());
  for (std::size_t frame = 0; frame < recording.poses.size(); ++frame) {
    Pose& pose = recording.poses[frame];
    pose.root_position = segments.front().transforms[frame].position;
    pose.offsets.assign(joints.size(), Vec3::Zero());
    for (std::size_t j = 0; j < joints.size(); ++j) {
      const JointTransform& own = segments[j].transforms[frame];
      if (j == 0) {
        pose.rotations.push_back(own.rotation);
        continue;
      }
      const JointTransform& parent =
          segments[static_cast<std::size_t>(joints[j].parent)].transforms[frame];
      pose.rotations.push_back((parent.rotation.conjugate() * own.rotation).normalized());
      pose.offsets[j] = parent.rotation.conjugate() * (own.position - parent.position);
    }
  }
  for (std::size_t j = 1; j < joints.size(); ++j) joints[j].offset = recording.poses[0].offsets[j];
}

}  // namespace mien::motion

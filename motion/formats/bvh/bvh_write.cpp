#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>

#include "motion/formats/bvh/bvh.h"
#include "motion/formats/bvh/bvh_rotation.h"
#include "motion/formats/bvh/bvh_text.h"

namespace mien::motion {

namespace {

/// A number as it is written: with so many decimals at most.
std::string bvh_number(double value, int decimals) {
  std::array<char, 400> digits;
  const std::to_chars_result result = std::to_chars(digits.data(), digits.data() + digits.size(),
                                                    value, std::chars_format::fixed, decimals);
  std::string_view number(digits.data(), static_cast<size_t>(result.ptr - digits.data()));
  number = number.substr(0, number.find_last_not_of('0') + 1);
  if (number.ends_with('.')) number.remove_suffix(1);
  return std::string(number == "-0" ? "0" : number);
}

/// Fixed notation, rounded to `decimals`, trailing zeros left out.
void append_number(std::string& text, double value, int decimals) {
  text += bvh_number(value, decimals);
}

void append_vector(std::string& text, const Vec3& vector, int decimals) {
  for (int i = 0; i < 3; ++i) {
    if (i > 0) text += ' ';
    append_number(text, vector[i], decimals);
  }
}

std::string writable_name(const std::string& name, size_t joint) {
  std::string written = name;
  for (char& c : written) {
    if (static_cast<unsigned char>(c) < 0x20 || c == '{' || c == '}') c = '_';
  }
  const size_t first = written.find_first_not_of(' ');
  if (first == std::string::npos) return "joint_" + std::to_string(joint);
  return written.substr(first, written.find_last_not_of(' ') - first + 1);
}

/// Which joints stand elsewhere on their parent in some pose than the skeleton says.
std::vector<bool> moving_joints(const Recording& recording) {
  const std::vector<Joint>& joints = recording.skeleton.joints;
  std::vector<bool> moving(joints.size(), false);
  for (const Pose& pose : recording.poses) {
    for (size_t j = 1; j < pose.offsets.size(); ++j) {
      if (pose.offsets[j] != joints[j].offset) moving[j] = true;
    }
  }
  return moving;
}

/// A joint of the text and how many joints are open around it.
struct WrittenJoint {
  size_t joint = 0;
  size_t depth = 0;
};

/// Joints as they stand in the text: each before its children, subtrees whole.
std::vector<WrittenJoint> depth_first(const Skeleton& skeleton) {
  const std::vector<std::vector<int>> children = children_of(skeleton);
  std::vector<WrittenJoint> order;
  std::vector<WrittenJoint> waiting = {{0, 0}};
  while (!waiting.empty()) {
    const WrittenJoint next = waiting.back();
    waiting.pop_back();
    order.push_back(next);
    const std::vector<int>& own = children[next.joint];
    for (auto child = own.rbegin(); child != own.rend(); ++child) {
      waiting.push_back({static_cast<size_t>(*child), next.depth + 1});
    }
  }
  return order;
}

void append_line(std::string& text, size_t depth, std::string_view line) {
  text.append(depth, '\t').append(line) += '\n';
}

void append_offset(std::string& text, size_t depth, const Vec3& offset) {
  text.append(depth, '\t') += "OFFSET ";
  append_vector(text, offset, bvh_position_decimals);
  text += '\n';
}

void append_joint(std::string& text, const Joint& joint, const WrittenJoint& written,
                  bool with_position) {
  const size_t depth = written.depth;
  append_line(text, depth,
              (depth == 0 ? "ROOT " : "JOINT ") + writable_name(joint.name, written.joint));
  append_line(text, depth, "{");
  append_offset(text, depth + 1, joint.offset);
  append_line(text, depth + 1,
              with_position
                  ? "CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation"
                  : "CHANNELS 3 Zrotation Xrotation Yrotation");
  if (!joint.tip) return;
  append_line(text, depth + 1, "End Site");
  append_line(text, depth + 1, "{");
  append_offset(text, depth + 2, *joint.tip);
  append_line(text, depth + 1, "}");
}

void append_hierarchy(std::string& text, const Skeleton& skeleton,
                      const std::vector<WrittenJoint>& order, const std::vector<bool>& moving) {
  text += "HIERARCHY\n";
  for (size_t i = 0; i < order.size(); ++i) {
    const size_t j = order[i].joint;
    append_joint(text, skeleton.joints[j], order[i], j == 0 || moving[j]);
    const size_t depth_after = i + 1 < order.size() ? order[i + 1].depth : 0;
    for (size_t depth = order[i].depth + 1; depth > depth_after; --depth) {
      append_line(text, depth - 1, "}");
    }
  }
}

}  // namespace

BvhText::BvhText(Skeleton skeleton, std::vector<bool> moving)
    : skeleton_(std::move(skeleton)),
      moving_(std::move(moving)),
      angles_(skeleton_.joints.size(), Vec3::Zero()) {
  assert(is_well_formed(skeleton_));
  moving_.resize(skeleton_.joints.size(), false);
  for (const WrittenJoint& written : depth_first(skeleton_)) order_.push_back(written.joint);
}

std::string BvhText::head(std::string_view frames, double frames_per_second) const {
  std::string text;
  append_hierarchy(text, skeleton_, depth_first(skeleton_), moving_);
  text.append("MOTION\nFrames: ").append(frames) += "\nFrame Time: ";
  append_number(text, 1.0 / frames_per_second, bvh_time_decimals);
  return text += '\n';
}

void BvhText::append_frame(std::string& text, const Pose& pose) {
  for (const size_t j : order_) {
    if (j == 0) {
      append_vector(text, pose.root_position, bvh_position_decimals);
    } else if (moving_[j]) {
      const Vec3& offset = pose.offsets.empty() ? skeleton_.joints[j].offset : pose.offsets[j];
      append_vector(text += ' ', offset, bvh_position_decimals);
    }
    angles_[j] = bvh_angles(pose.rotations[j], angles_[j]);
    append_vector(text += ' ', angles_[j] / radians_per_degree, bvh_angle_decimals);
  }
  text += '\n';
}

std::string to_bvh(const Recording& recording) {
  assert(!recording.poses.empty());
  BvhText bvh(recording.skeleton, moving_joints(recording));
  std::string text = bvh.head(std::to_string(recording.poses.size()), recording.frames_per_second);
  for (const Pose& pose : recording.poses) bvh.append_frame(text, pose);
  return text;
}

}  // namespace mien::motion

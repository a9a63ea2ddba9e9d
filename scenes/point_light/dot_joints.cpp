#include "scenes/point_light/dot_joints.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <optional>

#include "motion/error.h"
#include "motion/skeleton/body.h"
#include "motion/skeleton/hand.h"
#include "motion/text/nearest_word.h"

namespace mien::scenes {

namespace {

constexpr std::array standard_joints = {
    motion::Head,          motion::LeftShoulder, motion::LeftElbow,  motion::LeftWrist,
    motion::RightShoulder, motion::RightElbow,   motion::RightWrist, motion::LeftHip,
    motion::LeftKnee,      motion::LeftAnkle,    motion::RightHip,   motion::RightKnee,
    motion::RightAnkle};

const std::string head_top = "HeadTop";

/// "LeftThumbTip", of a finger's last joint.
std::string tip_name(int joint) {
  std::string name = motion::finger_joint_name(joint);
  name.pop_back();
  return name + "Tip";
}

bool is_last_of_finger(int joint) {
  return motion::segment_of(joint) == motion::joints_per_finger - 1;
}

std::vector<std::string> fingertip_names() {
  std::vector<std::string> names;
  for (int joint = 0; joint < motion::finger_joint_count; ++joint) {
    if (is_last_of_finger(joint)) names.push_back(tip_name(joint));
  }
  return names;
}

std::vector<std::string> names_on_fingers() {
  std::vector<std::string> names;
  for (int joint = 0; joint < motion::finger_joint_count; ++joint) {
    names.push_back(motion::finger_joint_name(joint));
    if (is_last_of_finger(joint)) names.push_back(tip_name(joint));
  }
  return names;
}

/// The dot on a joint or tip of a finger, of the body with fingers.
std::optional<DotJoint> dot_on_finger(const std::string& name) {
  for (int joint = 0; joint < motion::finger_joint_count; ++joint) {
    const int at = motion::body_joint_count + joint;
    if (name == motion::finger_joint_name(joint)) return DotJoint{name, at};
    if (is_last_of_finger(joint) && name == tip_name(joint)) return DotJoint{name, at, 1.0};
  }
  return std::nullopt;
}

std::vector<std::string> wanted_names(const motion::Skeleton& skeleton,
                                      const PointLightOptions& options) {
  if (options.joint_set.empty()) return options.joints;
  std::vector<std::string> names;
  const bool has_hands = options.joint_set == "hands";
  if ((has_hands || options.joint_set == "standard") && motion::is_body(skeleton)) {
    for (const motion::BodyJoint joint : standard_joints) names.emplace_back(name_of(joint));
    if (has_hands) std::ranges::copy(fingertip_names(), std::back_inserter(names));
    return names;
  }
  for (const motion::Joint& joint : skeleton.joints) names.push_back(joint.name);
  return names;
}

[[noreturn]] void refuse_fingers(const std::string& name, const PointLightOptions& options) {
  if (options.joint_set == "hands")
    throw Error("the motion has no fingers for the fingertips of joints: hands",
                "add hands: drawn to the look (--hands drawn) for relaxed hands, or use joints: "
                "standard");
  throw Error("the motion has no fingers for a dot on \"" + name + "\"",
              "add hands: drawn to the look (--hands drawn) for relaxed hands, or omit the fingers "
              "from joints");
}

DotJoint dot_joint(const motion::Skeleton& skeleton, bool has_fingers, const std::string& name,
                   const PointLightOptions& options) {
  const bool is_body = motion::is_body(skeleton);
  if (is_body && name == head_top) return {name, motion::Head, 1.0};
  if (const auto on_finger = dot_on_finger(name); is_body && on_finger) {
    if (has_fingers) return *on_finger;
    refuse_fingers(name, options);
  }
  for (std::size_t j = 0; j < skeleton.joints.size(); ++j) {
    if (skeleton.joints[j].name != name) continue;
    const bool is_head = is_body && j == motion::Head;
    return {name, static_cast<int>(j), is_head ? 0.5 : 0.0};
  }
  throw Error("there is no joint \"" + name + "\"",
              motion::did_you_mean(name, dot_joint_names(skeleton)));
}

}  // namespace

std::vector<DotJoint> dot_joints(const motion::Skeleton& skeleton, bool has_fingers,
                                 const PointLightOptions& options) {
  std::vector<DotJoint> joints;
  std::map<int, int> dot_of;
  for (const std::string& name : wanted_names(skeleton, options)) {
    joints.push_back(dot_joint(skeleton, has_fingers, name, options));
    dot_of.emplace(joints.back().joint, static_cast<int>(joints.size()) - 1);
  }
  const motion::Skeleton whole = has_fingers ? motion::with_fingers(skeleton) : skeleton;
  for (DotJoint& dot : joints) {
    int up = dot.joint;
    do {
      up = whole.joints[static_cast<std::size_t>(up)].parent;
    } while (up >= 0 && !dot_of.contains(up));
    if (up >= 0) dot.limb = dot_of[up];
  }
  return joints;
}

std::vector<std::string> dot_joint_names(const motion::Skeleton& skeleton) {
  std::vector<std::string> names;
  for (const motion::Joint& joint : skeleton.joints) names.push_back(joint.name);
  if (!motion::is_body(skeleton)) return names;
  names.push_back(head_top);
  std::ranges::copy(names_on_fingers(), std::back_inserter(names));
  return names;
}

bool has_dots_on_fingers(const PointLightOptions& options) {
  return options.joint_set == "hands" ||
         std::ranges::any_of(options.joints, [](const std::string& name) {
           return dot_on_finger(name).has_value();
         });
}

}  // namespace mien::scenes

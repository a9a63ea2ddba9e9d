#include "scenes/point_light/dot_joints.h"

#include <array>
#include <map>

#include "motion/error.h"
#include "motion/skeleton/body.h"
#include "motion/text/nearest_word.h"

namespace mien::scenes {

namespace {

constexpr std::array standard_joints = {
    motion::Head,          motion::LeftShoulder, motion::LeftElbow,  motion::LeftWrist,
    motion::RightShoulder, motion::RightElbow,   motion::RightWrist, motion::LeftHip,
    motion::LeftKnee,      motion::LeftAnkle,    motion::RightHip,   motion::RightKnee,
    motion::RightAnkle};

const std::string head_top = "HeadTop";

std::vector<std::string> wanted_names(const motion::Skeleton& skeleton,
                                      const PointLightOptions& options) {
  if (options.joint_set.empty()) return options.joints;
  std::vector<std::string> names;
  if (options.joint_set == "standard" && motion::is_body(skeleton)) {
    for (const motion::BodyJoint joint : standard_joints) names.emplace_back(name_of(joint));
    return names;
  }
  for (const motion::Joint& joint : skeleton.joints) names.push_back(joint.name);
  return names;
}

DotJoint dot_joint(const motion::Skeleton& skeleton, const std::string& name) {
  const bool is_body = motion::is_body(skeleton);
  if (is_body && name == head_top) return {name, motion::Head, 1.0};
  for (std::size_t j = 0; j < skeleton.joints.size(); ++j) {
    if (skeleton.joints[j].name != name) continue;
    const bool is_head = is_body && j == motion::Head;
    return {name, static_cast<int>(j), is_head ? 0.5 : 0.0};
  }
  throw Error("there is no joint \"" + name + "\"",
              motion::did_you_mean(name, dot_joint_names(skeleton)));
}

}  // namespace

std::vector<DotJoint> dot_joints(const motion::Skeleton& skeleton,
                                 const PointLightOptions& options) {
  std::vector<DotJoint> joints;
  std::map<int, int> dot_of;
  for (const std::string& name : wanted_names(skeleton, options)) {
    joints.push_back(dot_joint(skeleton, name));
    dot_of.emplace(joints.back().joint, static_cast<int>(joints.size()) - 1);
  }
  for (DotJoint& dot : joints) {
    int up = dot.joint;
    do {
      up = skeleton.joints[static_cast<std::size_t>(up)].parent;
    } while (up >= 0 && !dot_of.contains(up));
    if (up >= 0) dot.limb = dot_of[up];
  }
  return joints;
}

std::vector<std::string> dot_joint_names(const motion::Skeleton& skeleton) {
  std::vector<std::string> names;
  for (const motion::Joint& joint : skeleton.joints) names.push_back(joint.name);
  if (motion::is_body(skeleton)) names.push_back(head_top);
  return names;
}

}  // namespace mien::scenes

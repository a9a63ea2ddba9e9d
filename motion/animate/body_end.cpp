#include "motion/animate/body_end.h"

#include "motion/math/rotation.h"
#include "motion/skeleton/sole.h"

namespace mien::motion {

namespace {

struct EndTraits {
  std::string_view name;
  BodyJoint joint;
};

constexpr std::array<EndTraits, body_ends.size()> end_traits = {{{"left hand", LeftWrist},
                                                                 {"right hand", RightWrist},
                                                                 {"left foot", LeftAnkle},
                                                                 {"right foot", RightAnkle},
                                                                 {"head", Head},
                                                                 {"pelvis", Pelvis}}};

const EndTraits& end_traits_of(BodyEnd end) { return end_traits[static_cast<std::size_t>(end)]; }

}  // namespace

std::string_view name_of(BodyEnd end) { return end_traits_of(end).name; }

BodyJoint joint_of(BodyEnd end) { return end_traits_of(end).joint; }

Vec3 point_of(const Skeleton& body, BodyEnd end) {
  if (end == BodyEnd::pelvis) return Vec3::Zero();
  if (end == BodyEnd::left_foot || end == BodyEnd::right_foot) {
    const SoleShape sole = sole_shape(body, end == BodyEnd::left_foot);
    return 0.5 * (sole.heel + sole.ball);
  }
  const Joint& joint = body.joints[static_cast<std::size_t>(joint_of(end))];
  return joint.tip ? Vec3(0.5 * *joint.tip) : Vec3::Zero();
}

Vec3 place_of(const Skeleton& body, const JointTransforms& world, BodyEnd end) {
  const auto joint = static_cast<std::size_t>(joint_of(end));
  return world.positions[joint] + world.rotations[joint] * point_of(body, end);
}

BodyFrame body_frame(const Pose& pose) {
  return {horizontal(pose.root_position), heading(pose.rotations[Pelvis] * Vec3::UnitZ())};
}

}  // namespace mien::motion

#include "motion/biomechanics/body_mass.h"

#include <cassert>

#include "motion/skeleton/body.h"

namespace mien::motion {

namespace {

/// Share of the body's mass, and where the centre lies from the proximal end (0) to the distal (1).
struct Inertia {
  double share;
  double centre;
};

struct MassTable {
  Inertia head, trunk, upper_arm, forearm, hand, thigh, shank;
  double foot_share;
  double hand_length;  ///< wrist to third knuckle, share of stature
};

// Hand lengths: 86.2 mm at 1.741 m and 78.0 mm at 1.735 m (de Leva 1996).
constexpr MassTable de_leva_men = {{0.0694, 0.4998}, {0.4346, 0.5138}, {0.0271, 0.5772},
                                   {0.0162, 0.4574}, {0.0061, 0.79},   {0.1416, 0.4095},
                                   {0.0433, 0.4395}, 0.0137,           0.0862 / 1.741};
constexpr MassTable de_leva_women = {{0.0668, 0.5159}, {0.4257, 0.4964}, {0.0255, 0.5754},
                                     {0.0138, 0.4559}, {0.0056, 0.7474}, {0.1478, 0.3612},
                                     {0.0481, 0.4352}, 0.0129,           0.0780 / 1.735};
constexpr MassTable winter_adults = {{0.081, 0.5},    {0.497, 0.5},   {0.028, 0.436},
                                     {0.016, 0.430},  {0.006, 0.506}, {0.100, 0.433},
                                     {0.0465, 0.433}, 0.0145,         0.0862 / 1.741};

const MassTable& table_of(MassModel model) {
  switch (model) {
    case MassModel::de_leva_male:
      return de_leva_men;
    case MassModel::de_leva_female:
      return de_leva_women;
    case MassModel::winter:
      break;
  }
  return winter_adults;
}

struct SideNames {
  std::string_view upper_arm, forearm, hand, thigh, shank, foot;
};

constexpr SideNames left_names = {"left upper arm", "left forearm", "left hand",
                                  "left thigh",     "left shank",   "left foot"};
constexpr SideNames right_names = {"right upper arm", "right forearm", "right hand",
                                   "right thigh",     "right shank",   "right foot"};

SegmentMass between(std::string_view name, Inertia inertia, const Vec3& proximal,
                    const Vec3& distal) {
  return {name, inertia.share, proximal + inertia.centre * (distal - proximal)};
}

/// End of the last bone in world space; a body without one goes on as far as its joint is from the
/// parent.
Vec3 tip_of(const Skeleton& body, const JointTransforms& pose, BodyJoint joint) {
  const Joint& last = body.joints[joint];
  const Vec3 beyond = last.tip ? *last.tip : last.offset;
  return pose.positions[joint] + pose.rotations[joint] * beyond;
}

Vec3 knuckle_of(const Skeleton& body, const JointTransforms& pose, BodyJoint wrist,
                double hand_length_m) {
  const Vec3 direction = tip_of(body, pose, wrist) - pose.positions[wrist];
  return pose.positions[wrist] + hand_length_m * direction.normalized();
}

}  // namespace

std::vector<SegmentMass> segment_masses(const Skeleton& body, const JointTransforms& pose,
                                        MassModel model) {
  assert(is_body(body));
  const MassTable& table = table_of(model);
  const auto& at = pose.positions;
  const double hand_length_m = table.hand_length * standing_height(body);
  std::vector<SegmentMass> segments = {
      between("head", table.head, at[Neck], tip_of(body, pose, Head)),
      between("trunk", table.trunk, at[Neck], 0.5 * (at[LeftHip] + at[RightHip]))};
  for (const bool left : {true, false}) {
    const auto on_side = [left](BodyJoint joint) { return left ? joint : mirrored(joint); };
    const SideNames& names = left ? left_names : right_names;
    const Vec3& shoulder = at[on_side(LeftShoulder)];
    const Vec3& elbow = at[on_side(LeftElbow)];
    const Vec3& wrist = at[on_side(LeftWrist)];
    const Vec3& hip = at[on_side(LeftHip)];
    const Vec3& knee = at[on_side(LeftKnee)];
    const Vec3& ankle = at[on_side(LeftAnkle)];
    const Vec3& toe = at[on_side(LeftToe)];
    segments.push_back(between(names.upper_arm, table.upper_arm, shoulder, elbow));
    segments.push_back(between(names.forearm, table.forearm, elbow, wrist));
    segments.push_back(between(names.hand, table.hand, wrist,
                               knuckle_of(body, pose, on_side(LeftWrist), hand_length_m)));
    segments.push_back(between(names.thigh, table.thigh, hip, knee));
    segments.push_back(between(names.shank, table.shank, knee, ankle));
    segments.push_back(between(names.foot, {table.foot_share, 0.5}, ankle, toe));
  }
  return segments;
}

Vec3 centre_of_mass(const Skeleton& body, const JointTransforms& pose, MassModel model) {
  Vec3 sum = Vec3::Zero();
  double mass = 0.0;
  for (const SegmentMass& segment : segment_masses(body, pose, model)) {
    sum += segment.share * segment.centre;
    mass += segment.share;
  }
  return sum / mass;
}

}  // namespace mien::motion

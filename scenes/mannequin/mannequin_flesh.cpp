#include "scenes/mannequin/mannequin_flesh.h"

#include <algorithm>
#include <cmath>

#include "motion/math/rotation.h"
#include "motion/skeleton/sole.h"
#include "scenes/mannequin/mannequin_hand.h"
#include "scenes/mannequin/mannequin_landmarks.h"

namespace mien::scenes {

namespace {

using motion::BodyJoint;
using motion::Quat;
using motion::Vec3;

constexpr double arm_drop = 50.0 * motion::radians_per_degree;
constexpr double leg_spread = 8.0 * motion::radians_per_degree;
constexpr double limb_blend = 0.05;

double mixed(double low, double high, double t) { return low + (high - low) * t; }

/// Adds primitives to the parts of one body.
struct FleshBuilder {
  const motion::Skeleton& body;
  const motion::JointTransforms& pose;
  const Trunk trunk;
  const HeadShape head;
  double scale;  ///< relative stature: all sizes below are of a body of 1.75 m
  double girth;  ///< of limbs
  double belly;  ///< depth of the belly
  double male;   ///< 0 … 1
  std::vector<SdfPrimitive>* part = nullptr;

  Vec3 offset(BodyJoint joint) const { return body.joints[joint].offset; }

  /// World position of a point given in the joint's frame at 1.75 m.
  Vec3 at(BodyJoint joint, const Vec3& local) const {
    return pose.positions[joint] + pose.rotations[joint] * (scale * local);
  }

  void ellipsoid(BodyJoint joint, const Vec3& centre, const Vec3& radii, double blend,
                 const Quat& turn = Quat::Identity()) const {
    SdfPrimitive primitive;
    primitive.start = at(joint, centre);
    primitive.axes = (pose.rotations[joint] * turn).toRotationMatrix();
    primitive.radii = scale * radii;
    primitive.blend = scale * blend;
    part->push_back(primitive);
  }

  /// At (left, level, forward); its height stretches with the trunk.
  void trunk_ellipsoid(const Vec3& place, const Vec3& radii, double blend) const {
    SdfPrimitive primitive;
    primitive.start = trunk.at(place);
    primitive.radii = scale * Vec3(radii.x(), radii.y() * trunk.stretch(), radii.z());
    primitive.blend = scale * blend;
    part->push_back(primitive);
  }

  /// World position of a point of the standard head, in the frame of its joint.
  Vec3 in_head(const Vec3& local) const {
    return at(motion::Head, head.raise / scale + head.size * local);
  }

  void cone(const Vec3& start, const Vec3& end, double start_radius, double end_radius,
            double blend) const {
    SdfPrimitive primitive;
    primitive.shape = SdfPrimitive::Shape::round_cone;
    primitive.start = start;
    primitive.end = end;
    primitive.start_radius = scale * start_radius;
    primitive.end_radius = scale * end_radius;
    primitive.blend = scale * blend;
    part->push_back(primitive);
  }
};

/// The other side's: mirrored at the sagittal plane.
Vec3 sided(const Vec3& left, double side) { return {side * left.x(), left.y(), left.z()}; }

void model_hips(const FleshBuilder& s) {
  const double wide = mixed(1.06, 0.97, s.male);
  s.trunk_ellipsoid({0, 0.055, -0.004},
                    {(s.trunk.half_hips + 0.068 * s.girth) * wide, 0.125, 0.100 * s.girth}, 0.04);
  for (const double side : {1.0, -1.0}) {
    s.trunk_ellipsoid({side * 0.066, -0.028, -0.046},
                      Vec3(0.078, 0.086, 0.074) * s.girth * mixed(1.06, 0.98, s.male), 0.035);
  }
}

void model_chest(const FleshBuilder& s) {
  constexpr double top = Trunk::shoulder_level;
  const double breadth = s.trunk.breadth();
  const double sturdy = mixed(0.93, 1.03, s.male) * mixed(1.0, s.girth, 0.7);
  s.trunk_ellipsoid(
      {0, 0.175, 0.006},
      {mixed(0.117, 0.134, s.male) * s.trunk.waist() * s.girth, 0.150, 0.094 * s.belly}, 0.07);
  s.trunk_ellipsoid({0, top - 0.125, -0.002}, {0.146 * breadth * sturdy, 0.190, 0.104 * sturdy},
                    0.06);
  s.trunk_ellipsoid({0, top - 0.055, -0.022}, {0.152 * breadth * sturdy, 0.115, 0.078 * sturdy},
                    0.05);
  for (const double side : {1.0, -1.0}) {
    const double bust = (1.0 - s.male) * (1.0 - s.male) * s.girth;
    s.trunk_ellipsoid({side * 0.070 * breadth, top - mixed(0.100, 0.132, bust),
                       mixed(0.056, 0.048, bust) * sturdy},
                      {0.076, mixed(0.062, 0.066, bust), mixed(0.040, 0.058, bust)}, 0.055);
    s.cone(s.trunk.at({side * 0.03, top + 0.004, -0.016}),
           s.trunk.at({side * (s.trunk.half_shoulders - 0.022), top - 0.006, -0.008}),
           0.062 * s.girth, mixed(0.046, 0.056, s.male) * s.girth, 0.05);
  }
}

/// From between the shoulders to the skull, wherever the joint of the neck lies.
void model_neck(const FleshBuilder& s) {
  const double thick = mixed(0.86, 1.06, s.male) * mixed(1.0, s.girth, 0.6);
  const Vec3 base = s.trunk.shoulders + s.scale * Vec3(0.0, 0.030, -0.016);
  s.cone(base, s.in_head({0, 0.020, 0}), 0.056 * thick, 0.051 * thick, 0.035);
  const double reach = s.offset(motion::LeftShoulder).x();
  for (const double side : {1.0, -1.0}) {
    const Vec3 shoulder = s.pose.positions[side > 0 ? motion::LeftShoulder : motion::RightShoulder];
    const Vec3 middle = base + Vec3(side * 0.022 * s.scale, 0.028 * s.scale, 0.0);
    const Vec3 end = shoulder + Vec3(-side * 0.45 * reach, 0.030 * s.scale, -0.012 * s.scale);
    s.cone(middle, end, 0.042 * thick, 0.030 * thick, 0.05);
  }
}

/// A skull, a face before it, and what tells where it looks: brow, nose and chin.
void model_head(const FleshBuilder& s) {
  const double size = s.head.size;
  const auto primitive = [&](const Vec3& centre, const Vec3& radii, double blend) {
    s.ellipsoid(motion::Head, s.head.raise / s.scale + centre * size, radii * size, blend);
  };
  const double jaw = mixed(0.92, 1.0, s.male);
  primitive({0, 0.082, -0.008}, {0.074, 0.088, 0.090}, 0.030);
  primitive({0, 0.024, 0.026}, {0.060 * jaw, 0.084, 0.062}, 0.050);
  primitive({0, 0.072, 0.060}, {0.046, 0.022, 0.026}, 0.040);
  s.cone(s.in_head({0, 0.062, 0.082}), s.in_head({0, 0.026, 0.098}), 0.008 * size, 0.012 * size,
         0.022);
  primitive({0, -0.040, 0.064}, {0.026 * jaw, 0.018, 0.020}, 0.040);
}

void model_hand(const FleshBuilder& s, BodyJoint wrist, double side) {
  const Vec3 tip = s.body.joints[wrist].tip.value_or(Vec3(0.17 * s.scale, 0, 0)) / s.scale;
  const double h = std::clamp(tip.norm() / 0.17, 0.85, 1.15) * mixed(0.94, 1.02, s.male);
  const auto place = [&](const Vec3& left) { return sided(left * h, side); };
  const Quat curl = motion::exp(Vec3(0, 0, -side * 0.24));
  s.ellipsoid(wrist, place({0.048, -0.001, 0.002}), Vec3(0.060, 0.020, 0.042) * h, 0.030);
  s.ellipsoid(wrist, place({0.112, -0.010, -0.001}), Vec3(0.060, 0.0165, 0.037) * h, 0.025, curl);
  s.cone(s.at(wrist, place({0.026, -0.006, 0.026})), s.at(wrist, place({0.062, -0.014, 0.056})),
         0.0175 * h, 0.0135 * h, 0.020);
  s.cone(s.at(wrist, place({0.062, -0.014, 0.056})), s.at(wrist, place({0.090, -0.019, 0.064})),
         0.0135 * h, 0.0115 * h, 0.010);
}

void model_fingers(const FleshBuilder& s, double side) {
  const double thickness = hand_scale(s.body) * mixed(0.94, 1.02, s.male);
  for (SdfPrimitive& part :
       hand_flesh(s.pose, fingertips_of(s.body, s.pose), side > 0.0, thickness)) {
    s.part->push_back(std::move(part));
  }
}

void model_arm(const FleshBuilder& s, BodyJoint shoulder, double side) {
  const auto elbow = BodyJoint(shoulder + 1);
  const auto wrist = BodyJoint(shoulder + 2);
  const double upper = s.offset(elbow).norm() / s.scale;
  const double lower = s.offset(wrist).norm() / s.scale;
  const double g = s.girth * mixed(0.90, 1.04, s.male);
  const auto place = [&](BodyJoint joint, const Vec3& left) {
    return s.at(joint, sided(left, side));
  };
  const auto bulge = [&](BodyJoint joint, const Vec3& left, const Vec3& radii) {
    s.ellipsoid(joint, sided(left, side), Vec3(radii.x(), radii.y() * g, radii.z() * g), 0.035);
  };
  s.cone(place(shoulder, {0.004, 0, 0}), place(elbow, {0, 0, 0}), 0.054 * g, 0.038 * g, 0.03);
  bulge(shoulder, {0.022, 0.006, 0}, {0.072, 0.054, 0.058});
  bulge(shoulder, {0.52 * upper, 0, 0.010}, {0.090, 0.042, 0.042});
  bulge(shoulder, {0.48 * upper, 0, -0.012}, {0.100, 0.042, 0.040});
  s.cone(place(elbow, {0, 0, 0}), place(wrist, {0.006, 0, 0}), 0.036 * g, 0.0245 * g, 0.03);
  bulge(elbow, {0.24 * lower, 0.002, 0.004}, {0.085, 0.042, 0.044});
  bulge(wrist, {-0.02, 0, 0}, {0.050, 0.022, 0.029});
  if (includes_fingers(s.pose)) {
    model_fingers(s, side);
  } else {
    model_hand(s, wrist, side);
  }
}

/// A shoe with a flat sole.
void model_foot(const FleshBuilder& s, BodyJoint ankle, double side) {
  const auto toe = BodyJoint(ankle + 1);
  const Vec3 ball = s.offset(toe) / s.scale;
  const double end = s.body.joints[toe].tip.value_or(Vec3(0, 0, 0.06 * s.scale)).norm() / s.scale;
  const double sole = ball.y() - 0.02;
  const double g = mixed(0.94, 1.03, s.male) * mixed(1.0, s.girth, 0.3);
  const size_t first = s.part->size();
  s.ellipsoid(ankle, {0, sole + 0.030, -0.006}, {0.034 * g, 0.046, 0.046}, 0.030);
  s.cone(s.at(ankle, {0, sole + 0.050, 0.005}),
         s.at(ankle, {0.8 * ball.x(), sole + 0.030, 0.75 * ball.z()}), 0.035 * g, 0.032 * g, 0.030);
  s.ellipsoid(ankle, {ball.x() + side * 0.004, sole + 0.022, ball.z() - 0.008},
              {0.046 * g, 0.030, 0.060}, 0.030);
  s.ellipsoid(ankle, {ball.x(), sole + 0.016, ball.z() + 0.45 * end},
              {0.042 * g, 0.026, 0.55 * end + 0.018}, 0.030);
  for (size_t i = first; i < s.part->size(); ++i) {
    (*s.part)[i].within =
        HalfSpace{s.at(ankle, {0, sole, 0}), s.pose.rotations[ankle] * Vec3::UnitY()};
  }
}

void model_leg(const FleshBuilder& s, BodyJoint hip, double side) {
  const auto knee = BodyJoint(hip + 1);
  const auto ankle = BodyJoint(hip + 2);
  const double thigh = s.offset(knee).norm() / s.scale;
  const double shank = s.offset(ankle).norm() / s.scale;
  const double g = s.girth * mixed(1.01, 1.0, s.male);
  const auto place = [&](BodyJoint joint, const Vec3& left) {
    return s.at(joint, sided(left, side));
  };
  const auto bulge = [&](BodyJoint joint, const Vec3& left, const Vec3& radii) {
    s.ellipsoid(joint, sided(left, side), Vec3(radii.x() * g, radii.y(), radii.z() * g), 0.04);
  };
  s.cone(place(hip, {-0.004, -0.02, 0}), place(knee, {0, 0.01, 0.002}), 0.079 * g, 0.050 * g, 0.03);
  bulge(hip, {0.010, -0.40 * thigh, 0.016}, {0.066, 0.19, 0.066});
  bulge(hip, {-0.010, -0.32 * thigh, -0.010}, {0.068, 0.16, 0.066});
  bulge(knee, {0, 0.004, 0.010}, {0.046, 0.060, 0.045});
  s.cone(place(knee, {0, -0.01, -0.004}), place(ankle, {0, 0, -0.006}), 0.045 * g, 0.0315 * g,
         0.03);
  bulge(knee, {0.004, -0.29 * shank, -0.021}, {0.051, 0.125, 0.046});
  bulge(knee, {0.0, -0.36 * shank, 0.002}, {0.044, 0.150, 0.042});
  model_foot(s, ankle, side);
}

/// The arm hangs by `arm_drop` whatever the collar bone does.
void hang(motion::Pose& pose, BodyJoint clavicle, double lift, double side) {
  pose.rotations[static_cast<size_t>(clavicle)] =
      Quat(Eigen::AngleAxisd(side * lift, Vec3::UnitZ()));
  pose.rotations[static_cast<size_t>(clavicle + 1)] =
      Quat(Eigen::AngleAxisd(-side * (arm_drop + lift), Vec3::UnitZ()));
}

/// Tips of the toes and heels are flat on the floor: the foot is turned back by what the leg
/// spread.
void spread(motion::Pose& pose, BodyJoint hip, double angle) {
  const Quat turn(Eigen::AngleAxisd(angle, Vec3::UnitZ()));
  pose.rotations[static_cast<size_t>(hip)] = turn;
  pose.rotations[static_cast<size_t>(hip + 2)] = turn.conjugate();
}

}  // namespace

LimbDistances limb_distances(const Flesh& flesh, const Vec3& point) {
  return {signed_distance(flesh.trunk, point), signed_distance(flesh.left_arm, point),
          signed_distance(flesh.right_arm, point), signed_distance(flesh.left_leg, point),
          signed_distance(flesh.right_leg, point)};
}

double signed_distance(const Flesh& flesh, const Vec3& point) {
  return united(flesh, limb_distances(flesh, point));
}

double united(const Flesh& flesh, const LimbDistances& distances) {
  const auto [trunk, left_arm, right_arm, left_leg, right_leg] = distances;
  const double scale = flesh.trunk.empty() ? 1.0 : flesh.trunk.front().blend / 0.04;
  const double legs = smooth_minimum(left_leg, right_leg, 0.01 * scale);
  const double with_legs = smooth_minimum(trunk, legs, limb_blend * scale);
  return smooth_minimum(with_legs, std::min(left_arm, right_arm), limb_blend * scale);
}

motion::Pose modelling_pose(const motion::Skeleton& body) {
  motion::Pose pose;
  pose.rotations.assign(body.joints.size(), Quat::Identity());
  hang(pose, motion::LeftClavicle, collar_lift(body), 1.0);
  hang(pose, motion::RightClavicle, collar_lift(body), -1.0);
  spread(pose, motion::LeftHip, leg_spread);
  spread(pose, motion::RightHip, -leg_spread);
  const std::vector<Vec3> positions = motion::world_positions(body, pose);
  pose.root_position.y() = motion::sole_depth(body) - std::min(positions[motion::LeftToe].y(),
                                                               positions[motion::RightToe].y());
  return pose;
}

Flesh flesh_of(const motion::Skeleton& body, const motion::JointTransforms& pose,
               const MannequinOptions& options) {
  Flesh flesh;
  const double fat = options.build - 0.5;
  FleshBuilder sculptor{body,
                        pose,
                        trunk_of(body, pose),
                        head_shape(body),
                        motion::relative_stature(body),
                        1.0 + 0.42 * fat,
                        1.0 + (fat > 0 ? 1.1 : 0.45) * fat,
                        options.sex};
  sculptor.part = &flesh.trunk;
  model_hips(sculptor);
  model_chest(sculptor);
  model_neck(sculptor);
  model_head(sculptor);
  sculptor.part = &flesh.left_arm;
  model_arm(sculptor, motion::LeftShoulder, 1.0);
  sculptor.part = &flesh.right_arm;
  model_arm(sculptor, motion::RightShoulder, -1.0);
  sculptor.part = &flesh.left_leg;
  model_leg(sculptor, motion::LeftHip, 1.0);
  sculptor.part = &flesh.right_leg;
  model_leg(sculptor, motion::RightHip, -1.0);
  return flesh;
}

}  // namespace mien::scenes

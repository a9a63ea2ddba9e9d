#include "motion/procedural/foot_roll.h"

#include <algorithm>
#include <cmath>

#include "motion/skeleton/sole.h"

namespace mien::motion {

namespace {

constexpr double foot_flat_share = 0.10;  // of the cycle, at the normal heel-strike angle

}  // namespace

FootShape foot_shape(const Skeleton& body, BodyJoint ankle) {
  const bool left = ankle == LeftAnkle;
  const SoleShape sole = sole_shape(body, left);
  FootShape shape;
  shape.ankle_height = -sole.ball.y();
  shape.heel = sole.heel;
  shape.ball = body.joints[left ? LeftToe : RightToe].offset;
  shape.ball_height = sole.depth;
  shape.toe_length = sole.toes.norm();
  return shape;
}

Quat foot_rotation(const FootPose& foot) {
  return Quat(Eigen::AngleAxisd(foot.yaw, Vec3::UnitY()) *
              Eigen::AngleAxisd(-foot.pitch, Vec3::UnitX()));
}

double stance_pitch(const WalkStyle& style, double phase) {
  const double flat = foot_flat_share * std::clamp(style.heel_strike_deg / 20.0, 0.5, 1.5);
  const double rise = style.heel_rise_share;
  if (phase < flat) {
    const double left = 1.0 - phase / flat;
    return radians_per_degree * style.heel_strike_deg * left * left;
  }
  if (phase <= rise) return 0.0;
  const double risen = (phase - rise) / (style.stance_share - rise);
  return -radians_per_degree * style.toe_off_deg * std::pow(risen, 5.0) * (2.5 - 1.5 * risen);
}

FootRoll foot_roll(const FootShape& shape, double yaw, double pitch) {
  const Vec3& pivot = pitch > 0.0 ? shape.heel : shape.ball;
  const Quat flat(Eigen::AngleAxisd(yaw, Vec3::UnitY()));
  return {flat * pivot, foot_rotation({.yaw = yaw, .pitch = pitch}) * pivot};
}

Vec3 rolled_ankle(const FootShape& shape, const Vec3& print, const FootRoll& roll) {
  return print + Vec3(0, shape.ankle_height, 0) + roll.flat_pivot - roll.pivot;
}

FootPose rolled_foot(const FootShape& shape, const Vec3& print, double yaw, double pitch) {
  FootPose foot;
  foot.yaw = yaw;
  foot.pitch = pitch;
  foot.toe_extension = std::max(0.0, -foot.pitch);
  foot.ankle = rolled_ankle(shape, print, foot_roll(shape, yaw, pitch));
  return foot;
}

FootPose stance_foot(const FootShape& shape, const WalkStyle& style, const Vec3& print, double yaw,
                     double phase) {
  return rolled_foot(shape, print, yaw, stance_pitch(style, phase));
}

double toe_clearance(const FootShape& shape, const FootPose& foot) {
  const double ball = (foot.ankle + foot_rotation(foot) * shape.ball).y() - shape.ball_height;
  const double tip = ball + shape.toe_length * std::sin(foot.pitch + foot.toe_extension);
  return std::min(ball, tip);
}

double heel_clearance(const FootShape& shape, const FootPose& foot) {
  return (foot.ankle + foot_rotation(foot) * shape.heel).y();
}

}  // namespace mien::motion

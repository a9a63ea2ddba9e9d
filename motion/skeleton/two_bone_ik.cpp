#include "motion/skeleton/two_bone_ik.h"

#include <algorithm>
#include <cmath>

#include "motion/math/rotation.h"

namespace mien::motion {

namespace {

/// A limb whose middle joint lies off the line by more than this share of the upper bone (10° of
/// bend) shows by itself which way it bends.
constexpr double clear_bend = 0.09;

/// Unit vector off the line root–end in which the limb bends. Of a nearly straight limb noise
/// decides where the middle joint lies, so there the hint takes over, smoothly.
Vec3 bend_direction(const TwoBoneLimb& limb, const Vec3& line, const Vec3& hint) {
  const Vec3 upper = (limb.middle - limb.root).normalized();
  const Vec3 off = upper - upper.dot(line) * line;
  const Vec3 hinted = hint - hint.dot(line) * line;
  const double share = clear_bend * (1.0 - smooth_step(off.norm() / clear_bend));
  Vec3 bend = off;
  if (hinted.norm() > 1e-9) bend += share * hinted.normalized();
  return bend.norm() > 1e-9 ? Vec3(bend.normalized()) : Vec3(line.unitOrthogonal());
}

Quat turn(const Vec3& from, const Vec3& to, const Vec3& normal_before, const Vec3& normal_after) {
  return (frame_from(to, normal_after) * frame_from(from, normal_before).conjugate()).normalized();
}

}  // namespace

TwoBoneSolution solve_two_bone(const TwoBoneLimb& limb, const Vec3& target, const Vec3& bend_hint,
                               double max_extension) {
  const Vec3 upper = limb.middle - limb.root;
  const Vec3 lower = limb.end - limb.middle;
  const double a = upper.norm();
  const double b = lower.norm();
  const Vec3 reach = target - limb.root;
  const Vec3 before = limb.end - limb.root;
  const Vec3 line_before = before.norm() > 1e-9 ? Vec3(before.normalized()) : Vec3(-Vec3::UnitY());
  const Vec3 line = reach.norm() > 1e-9 ? Vec3(reach.normalized()) : line_before;
  const double shortest = std::abs(a - b) + 1e-6 * (a + b);
  const double distance =
      std::min(std::max(reach.norm(), shortest), std::max(shortest, (a + b) * max_extension));

  const Vec3 bend_before = bend_direction(limb, line_before, bend_hint);
  const Vec3 turned = turn_between(line_before, line) * bend_before;
  const Vec3 bend = (turned - turned.dot(line) * line).normalized();

  const double along = (distance * distance + a * a - b * b) / (2.0 * distance);
  const double off = std::sqrt(std::max(0.0, a * a - along * along));

  TwoBoneSolution solution;
  solution.middle = limb.root + along * line + off * bend;
  solution.end = limb.root + distance * line;
  const Vec3 normal_before = line_before.cross(bend_before);
  const Vec3 normal = line.cross(bend);
  solution.upper_turn = turn(upper, solution.middle - limb.root, normal_before, normal);
  solution.lower_turn = turn(lower, solution.end - solution.middle, normal_before, normal);
  return solution;
}

}  // namespace mien::motion

#include "motion/fitting/hinge_axis.h"

#include <algorithm>

#include "motion/math/rotation.h"

namespace mien::motion {

namespace {

/// What one frame tells about the axis.
struct Bend {
  Vec3 bone = Vec3::Zero();      ///< unit, along the upper bone
  Vec3 expected = Vec3::Zero();  ///< unit, perpendicular to the bone
  Vec3 measured = Vec3::Zero();  ///< likewise; zero if straight
  double away = 0.0;             ///< of the middle joint from the line between the ends, metres
};

/// The angle by which the plane of bend is turned from that of the hinge in a limb whose lower bone
/// also leans by `valgus`: y of the lower bone is sin(valgus), whatever the flexion.
double turn_by_valgus(const Vec3& upper, const Vec3& lower, double valgus) {
  const double along = upper.dot(lower) / std::cos(valgus);
  const double flexion = std::acos(std::clamp(along, -1.0, 1.0));
  return std::atan2(std::sin(valgus), std::cos(valgus) * std::sin(flexion));
}

std::optional<Bend> bend_of(const Vec3& root, const Vec3& middle, const std::optional<Vec3>& end,
                            const Vec3& expected, const Hinge& hinge) {
  Bend bend;
  const Vec3 upper = middle - root;
  if (upper.norm() < 1e-6) return std::nullopt;
  bend.bone = upper.normalized();
  const Vec3 across = expected - bend.bone * bend.bone.dot(expected);
  bend.expected = across.norm() > 1e-3 ? across.normalized() : bend.bone.unitOrthogonal();
  if (!end) return bend;
  const Vec3 normal = hinge.sign * upper.cross(*end - middle);
  const double length = (*end - root).norm();
  if (normal.norm() < 1e-12 || length < 1e-6) return bend;
  bend.away = normal.norm() / length;
  bend.measured = normal.normalized();
  if (hinge.valgus != 0.0) {
    const double turn = turn_by_valgus(bend.bone, (*end - middle).normalized(), hinge.valgus);
    bend.measured = exp(Vec3(-hinge.sign * turn * bend.bone)) * bend.measured;
  }
  return bend;
}

/// Weight of the measured axis, 0 to 1, where the other axis to choose is `usual`. An axis across
/// or against that one is that of a limb bent sideways or backwards: unless far bent, an error of
/// the joint.
double weight_of(const Bend& bend, const Vec3& usual, double noise_metres) {
  const double backward_metres = std::max(0.06, noise_metres);
  const double forward = smooth_step(2.0 * bend.measured.dot(usual));
  const double noise = backward_metres + forward * (noise_metres - backward_metres);
  return bend.away * bend.away / (bend.away * bend.away + noise * noise);
}

/// In the mean turn of the axis, of a frame in which the joint is `away` from the line between the
/// ends. Joints that are some centimetres beside their places bend a straight limb this much: such
/// frames do not count.
double weight_in_mean(double away) {
  constexpr double straight = 0.03;  // metres
  constexpr double bent = 0.09;      // metres
  return away * away * smooth_step((away - straight) / (bent - straight));
}
constexpr double straight_limb = 0.01 * 0.01;  // weight of the expected axis in each frame

}  // namespace

Track hinge_axis(const Track& root, const Track& middle, const Track& end, const Track& expected,
                 const Hinge& hinge) {
  std::vector<std::optional<Bend>> bends(root.size());
  double cosine = 0.0;
  double sine = 0.0;
  for (std::size_t frame = 0; frame < root.size(); ++frame) {
    if (!root[frame] || !middle[frame] || !expected[frame]) continue;
    bends[frame] = bend_of(*root[frame], *middle[frame], end[frame], *expected[frame], hinge);
    if (!bends[frame]) continue;
    const Bend& bend = *bends[frame];
    cosine += straight_limb;
    const double weight = weight_in_mean(bend.away);
    cosine += weight * bend.expected.dot(bend.measured);
    sine += weight * bend.bone.dot(bend.expected.cross(bend.measured));
  }
  constexpr double most = 60.0 * radians_per_degree;
  const double mean = std::hypot(cosine, sine) > 1e-12 ? std::atan2(sine, cosine) : 0.0;
  const double turn = std::clamp(mean, -most, most);
  Track axis(root.size());
  for (std::size_t frame = 0; frame < root.size(); ++frame) {
    if (!bends[frame]) continue;
    const Bend& bend = *bends[frame];
    const Vec3 usual =
        std::cos(turn) * bend.expected + std::sin(turn) * bend.bone.cross(bend.expected);
    const double weight = weight_of(bend, usual, hinge.noise_metres);
    const Vec3 mixed = weight * bend.measured + (1.0 - weight) * usual;
    axis[frame] = mixed.norm() > 1e-6 ? Vec3(mixed.normalized()) : usual;
  }
  return axis;
}

Track joint_beside(const Track& root, const Track& outer, const Limb& limb, double inward,
                   const Hinge& hinge) {
  constexpr int rounds = 5;
  Track axis = limb.expected;
  Track middle;
  for (int round = 0; round < rounds; ++round) {
    middle = shifted(outer, axis, inward);
    const Track end = limb.end_is_outer ? shifted(limb.end, axis, limb.end_inward) : limb.end;
    axis = hinge_axis(root, middle, end, limb.expected, hinge);
  }
  return shifted(outer, axis, inward);
}

}  // namespace mien::motion

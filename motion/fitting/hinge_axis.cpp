#include "motion/fitting/hinge_axis.h"

namespace mien::motion {

namespace {

/// What one frame tells about the axis.
struct Bend {
  Vec3 bone = Vec3::Zero();      ///< unit, along the upper bone
  Vec3 expected = Vec3::Zero();  ///< unit, perpendicular to the bone
  Vec3 measured = Vec3::Zero();  ///< likewise; zero if straight
  double weight = 0.0;           ///< of the measured axis, 0 to 1
};

std::optional<Bend> bend_of(const Vec3& root, const Vec3& middle, const std::optional<Vec3>& end,
                            const Vec3& expected, double sign) {
  constexpr double noise_metres = 0.015;
  Bend bend;
  const Vec3 upper = middle - root;
  if (upper.norm() < 1e-6) return std::nullopt;
  bend.bone = upper.normalized();
  const Vec3 across = expected - bend.bone * bend.bone.dot(expected);
  bend.expected = across.norm() > 1e-3 ? across.normalized() : bend.bone.unitOrthogonal();
  if (!end) return bend;
  const Vec3 normal = sign * upper.cross(*end - middle);
  const double length = (*end - root).norm();
  if (normal.norm() < 1e-12 || length < 1e-6) return bend;
  const double away = normal.norm() / length;  // of the middle joint from the line of the ends
  bend.measured = normal.normalized();
  bend.weight = away * away / (away * away + noise_metres * noise_metres);
  return bend;
}

}  // namespace

Track hinge_axis(const Track& root, const Track& middle, const Track& end, const Track& expected,
                 double sign) {
  std::vector<std::optional<Bend>> bends(root.size());
  double cosine = 0.0;
  double sine = 0.0;
  for (std::size_t frame = 0; frame < root.size(); ++frame) {
    if (!root[frame] || !middle[frame] || !expected[frame]) continue;
    bends[frame] = bend_of(*root[frame], *middle[frame], end[frame], *expected[frame], sign);
    if (!bends[frame]) continue;
    const Bend& bend = *bends[frame];
    cosine += bend.weight * bend.expected.dot(bend.measured);
    sine += bend.weight * bend.bone.dot(bend.expected.cross(bend.measured));
  }
  const double turn = std::hypot(cosine, sine) > 1e-9 ? std::atan2(sine, cosine) : 0.0;
  Track axis(root.size());
  for (std::size_t frame = 0; frame < root.size(); ++frame) {
    if (!bends[frame]) continue;
    const Bend& bend = *bends[frame];
    const Vec3 usual =
        std::cos(turn) * bend.expected + std::sin(turn) * bend.bone.cross(bend.expected);
    const Vec3 mixed = bend.weight * bend.measured + (1.0 - bend.weight) * usual;
    axis[frame] = mixed.norm() > 1e-6 ? Vec3(mixed.normalized()) : usual;
  }
  return axis;
}

}  // namespace mien::motion

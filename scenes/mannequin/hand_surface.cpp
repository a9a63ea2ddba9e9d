#include "scenes/mannequin/hand_surface.h"

#include <algorithm>
#include <array>
#include <utility>

#include "scenes/mannequin/mannequin_hand.h"

namespace mien::scenes {

namespace {

using motion::Vec3;

// Metres beyond the wrist along the hand, at a hand of 0.189 m. Body and hand overlap between the
// two ends, so that there is never a gap; each gives way to the other over a zone around the seam.
constexpr double hand_begins = -0.060;
constexpr double body_ends = 0.006;
constexpr double seam = -0.040;
constexpr double seam_width = 0.018;
constexpr double sunk = 0.0012;  // by which the one lies below the other

/// The frame of a hand at rest: its joints' axes, mirrored for the right hand so that x points from
/// the wrist to the fingers.
struct HandFrame {
  Vec3 wrist;
  Eigen::Matrix3d axes;  ///< columns; a reflection for the right hand

  Vec3 local(const Vec3& point) const { return axes.transpose() * (point - wrist); }
  Vec3 world(const Vec3& local_point) const { return wrist + axes * local_point; }
};

HandFrame frame_of_hand(const motion::JointTransforms& pose, bool left) {
  const auto wrist = static_cast<std::size_t>(left ? motion::LeftWrist : motion::RightWrist);
  HandFrame frame{pose.positions[wrist], pose.rotations[wrist].toRotationMatrix()};
  if (!left) frame.axes.col(0) *= -1.0;
  return frame;
}

/// 0 before the seam, 1 beyond it.
double beyond_seam(double along, double scale) {
  return motion::smooth_step(0.5 + (along / scale - seam) / seam_width);
}

std::vector<double> even_planes(double low, double high, double step) {
  std::vector<double> planes = {low};
  while (planes.back() < high) planes.push_back(planes.back() + step);
  return planes;
}

/// The box of a hand's flesh in its frame.
Eigen::AlignedBox3d hand_box(const std::vector<SdfPrimitive>& arm, const HandFrame& frame,
                             double scale) {
  Eigen::AlignedBox3d box;
  for (const SdfPrimitive& primitive : arm) {
    const bool is_cone = primitive.shape == SdfPrimitive::Shape::round_cone;
    const double radius = is_cone ? std::max(primitive.start_radius, primitive.end_radius)
                                  : primitive.radii.maxCoeff();
    for (const Vec3& centre : {primitive.start, is_cone ? primitive.end : primitive.start}) {
      const Vec3 local = frame.local(centre);
      if (local.x() < hand_begins * scale) continue;
      box.extend(local + Vec3::Constant(radius));
      box.extend(local - Vec3::Constant(radius));
    }
  }
  box.min().x() = std::max(box.min().x(), hand_begins * scale);
  return box;
}

}  // namespace

Surface hand_surface(const Flesh& flesh, const motion::JointTransforms& pose, bool left,
                     double scale, const HandCells& cells) {
  const std::vector<SdfPrimitive>& arm = left ? flesh.left_arm : flesh.right_arm;
  const HandFrame frame = frame_of_hand(pose, left);
  const Eigen::AlignedBox3d box = hand_box(arm, frame, scale);
  const double air = 0.012 * scale;
  Grid grid;
  grid.x = even_planes(box.min().x() - air, box.max().x() + air, cells.along * scale);
  grid.y = even_planes(box.min().y() - air, box.max().y() + air, cells.through * scale);
  grid.z = even_planes(box.min().z() - air, box.max().z() + air, cells.across * scale);
  const auto field = [&](const Vec3& local) {
    const double surface = signed_distance(arm, frame.world(local));
    const double below = sunk * scale * (1.0 - beyond_seam(local.x(), scale));
    return std::max(surface + below, hand_begins * scale - local.x());
  };
  Surface hand = surface_nets(field, grid);
  for (Vec3& position : hand.positions) position = frame.world(position);
  for (Vec3& normal : hand.normals) normal = frame.axes * normal;
  if (!left)
    for (auto& triangle : hand.triangles) std::swap(triangle[1], triangle[2]);
  return hand;
}

SignedDistance without_hands(const Flesh& flesh, const motion::JointTransforms& pose,
                             double scale) {
  const std::array<HandFrame, 2> hands = {frame_of_hand(pose, true), frame_of_hand(pose, false)};
  return [&flesh, hands, scale](const Vec3& point) {
    auto [trunk, left_arm, right_arm, left_leg, right_leg] = limb_distances(flesh, point);
    const auto forearm = [&](double arm, const HandFrame& hand) {
      const double along = hand.local(point).x();
      return std::max(arm + sunk * scale * beyond_seam(along, scale), along - body_ends * scale);
    };
    left_arm = forearm(left_arm, hands[0]);
    right_arm = forearm(right_arm, hands[1]);
    return united(flesh, {trunk, left_arm, right_arm, left_leg, right_leg});
  };
}

void smooth_seams(Surface& surface, const Flesh& flesh, const motion::JointTransforms& pose,
                  double scale) {
  constexpr double near_wrist = 0.10;  // metres at a hand of 0.189 m
  constexpr double step = 5e-4;
  const std::array<std::size_t, 2> wrists = {motion::LeftWrist, motion::RightWrist};
  for (const std::size_t wrist : wrists) {
    for (std::size_t v = 0; v < surface.positions.size(); ++v) {
      const Vec3& point = surface.positions[v];
      if ((point - pose.positions[wrist]).norm() > near_wrist * scale) continue;
      surface.normals[v] = field_normal(
          [&](const Vec3& place) { return signed_distance(flesh, place); }, point, step);
    }
  }
}

}  // namespace mien::scenes

#include "scenes/mannequin/mannequin_hand.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "motion/math/rotation.h"
#include "motion/skeleton/hand_tip.h"

namespace mien::scenes {

namespace {

using motion::Finger;
using motion::Quat;
using motion::Vec3;

constexpr auto hand_joints = static_cast<std::size_t>(motion::joints_per_hand);
constexpr auto finger_count = static_cast<std::size_t>(motion::fingers_per_hand);

/// Degrees by which a straight finger is turned towards the thumb's side.
constexpr std::array<double, finger_count> spread_degrees = {0.0, 6.0, 0.5, -5.0, -11.0};

/// Radii of a hand of 0.189 m in metres: at the three joints and at the tip.
using FingerRadii = std::array<double, motion::joints_per_finger + 1>;
constexpr std::array<FingerRadii, finger_count> finger_radii = {{
    {0.0170, 0.0122, 0.0108, 0.0084},
    {0.0100, 0.0093, 0.0084, 0.0072},
    {0.0102, 0.0095, 0.0086, 0.0074},
    {0.0096, 0.0090, 0.0081, 0.0070},
    {0.0084, 0.0078, 0.0070, 0.0061},
}};

SdfPrimitive cone(const Vec3& start, const Vec3& end, double start_radius, double end_radius,
                  double blend) {
  SdfPrimitive primitive;
  primitive.shape = SdfPrimitive::Shape::round_cone;
  primitive.start = start;
  primitive.end = end;
  primitive.start_radius = start_radius;
  primitive.end_radius = end_radius;
  primitive.blend = blend;
  return primitive;
}

/// The joints of one finger and its tip, from the wrist outwards; world space.
struct FingerLine {
  std::array<Vec3, motion::joints_per_finger + 1> points;

  Vec3 direction(std::size_t segment) const {
    return (points[segment + 1] - points[segment]).normalized();
  }
};

FingerLine line_of(const motion::JointTransforms& pose, const std::vector<Vec3>& fingertips,
                   bool left, Finger finger) {
  FingerLine line;
  for (int s = 0; s < motion::joints_per_finger; ++s) {
    line.points[static_cast<std::size_t>(s)] =
        pose.positions[static_cast<std::size_t>(with_body(finger_joint(left, finger, s)))];
  }
  const int tip = (left ? 0 : motion::fingers_per_hand) + static_cast<int>(finger);
  line.points.back() = fingertips[static_cast<std::size_t>(tip)];
  return line;
}

/// Adds primitives of one hand.
struct HandBuilder {
  const motion::JointTransforms& pose;
  const std::vector<Vec3>& fingertips;
  bool left;
  double size;  ///< relative to a hand of 0.189 m
  std::vector<SdfPrimitive> parts = {};

  std::size_t wrist() const {
    return static_cast<std::size_t>(left ? motion::LeftWrist : motion::RightWrist);
  }

  /// World position of a point of the left hand of 0.189 m, or of its mirror image.
  Vec3 at(const Vec3& of_left) const {
    const Vec3 local(left ? of_left.x() : -of_left.x(), of_left.y(), of_left.z());
    return pose.positions[wrist()] + pose.rotations[wrist()] * (size * local);
  }

  void pad(const Vec3& centre, const Vec3& radii, double blend) {
    SdfPrimitive primitive;
    primitive.start = at(centre);
    primitive.axes = pose.rotations[wrist()].toRotationMatrix();
    primitive.radii = size * radii;
    primitive.blend = size * blend;
    parts.push_back(primitive);
  }

  /// From the carpus to each knuckle, and the soft parts on the palm's side.
  void add_palm() {
    for (const Finger finger : {Finger::index, Finger::middle, Finger::ring, Finger::little}) {
      const Vec3 knuckle = line_of(pose, fingertips, left, finger).points.front();
      const Vec3 local =
          pose.rotations[wrist()].conjugate() * (knuckle - pose.positions[wrist()]) / size;
      const Vec3 carpus = at({0.014, -0.002, 0.42 * local.z() - 0.001});
      const double thick = finger == Finger::little ? 0.0100 : 0.0112;
      parts.push_back(cone(carpus, knuckle, 0.0150 * size, thick * size, 0.016 * size));
    }
    pad({0.046, -0.007, -0.031}, {0.040, 0.0150, 0.0165}, 0.014);
    pad({0.087, -0.005, -0.008}, {0.020, 0.0120, 0.038}, 0.012);
  }

  void add_finger(Finger finger) {
    const FingerLine line = line_of(pose, fingertips, left, finger);
    const FingerRadii& radii = finger_radii[static_cast<std::size_t>(finger)];
    const bool is_thumb = finger == Finger::thumb;
    for (std::size_t s = 0; s < static_cast<std::size_t>(motion::joints_per_finger); ++s) {
      const bool is_last = s + 1 == static_cast<std::size_t>(motion::joints_per_finger);
      const double end_radius = size * radii[s + 1];
      // The flesh ends at the tip.
      const Vec3 end =
          is_last ? Vec3(line.points[s + 1] - end_radius * line.direction(s)) : line.points[s + 1];
      // Segments of a finger share the ball of their joint.
      const double blend = s > 0 ? 0.0 : (is_thumb ? 0.018 : 0.006);
      parts.push_back(cone(line.points[s], end, size * radii[s], end_radius, size * blend));
    }
  }
};

/// Distance to a segment.
double from_segment(const Vec3& point, const Vec3& a, const Vec3& b) {
  const Vec3 along = b - a;
  const double t =
      std::clamp((point - a).dot(along) / std::max(along.squaredNorm(), 1e-12), 0.0, 1.0);
  return (point - a - t * along).norm();
}

/// How far a point is from a finger, or from its bone in the palm; metres at a hand of 0.189 m.
double from_finger(const FingerLine& line, const Vec3& wrist, Finger finger, double scale,
                   const Vec3& point) {
  constexpr double ball_of_thumb = 0.005;  // by which its flesh is thicker
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t s = 0; s + 1 < line.points.size(); ++s)
    nearest = std::min(nearest, from_segment(point, line.points[s], line.points[s + 1]));
  if (finger == Finger::thumb) return nearest / scale - ball_of_thumb;
  return std::min(nearest, from_segment(point, wrist, line.points.front())) / scale;
}

/// Half the length of the zone over which each joint takes over, metres at a hand of 0.189 m.
double reach_of(Finger finger, std::size_t segment) {
  constexpr std::array<double, motion::joints_per_finger> thumb = {0.016, 0.011, 0.008};
  constexpr std::array<double, motion::joints_per_finger> other = {0.010, 0.0075, 0.0065};
  return finger == Finger::thumb ? thumb[segment] : other[segment];
}

/// How much of a point at a finger is moved by each of the finger's joints; the rest by the wrist.
std::array<double, motion::joints_per_finger> shares_along(const FingerLine& line, Finger finger,
                                                           double scale, const Vec3& point) {
  std::array<double, motion::joints_per_finger> shares{};
  double left = 1.0;
  for (std::size_t s = 0; s < shares.size(); ++s) {
    const Vec3 across =
        s == 0 ? line.direction(0) : Vec3((line.direction(s - 1) + line.direction(s)).normalized());
    const double distance = across.dot(point - line.points[s]) / scale;
    const double beyond = motion::smooth_step(0.5 + 0.5 * distance / reach_of(finger, s));
    left *= beyond;
    shares[s] = left;
    if (s > 0) shares[s - 1] -= left;
  }
  return shares;
}

}  // namespace

double hand_scale(const motion::Skeleton& body) { return motion::hand_length(body) / 0.189; }

std::vector<Quat> modelling_fingers() {
  std::vector<Quat> fingers(static_cast<std::size_t>(motion::finger_joint_count), Quat::Identity());
  for (const bool left : {true, false}) {
    for (std::size_t f = 0; f < finger_count; ++f) {
      const double towards_thumb = spread_degrees[f] * motion::radians_per_degree;
      const auto joint = static_cast<std::size_t>(finger_joint(left, Finger(f), 0));
      fingers[joint] =
          Quat(Eigen::AngleAxisd(left ? -towards_thumb : towards_thumb, Vec3::UnitY()));
    }
  }
  return fingers;
}

bool includes_fingers(const motion::JointTransforms& pose) {
  return pose.positions.size() > static_cast<std::size_t>(motion::body_joint_count);
}

motion::BodyJoint body_joint_at(int joint) {
  if (joint < motion::body_joint_count) return motion::BodyJoint(joint);
  return motion::is_left_finger(joint - motion::body_joint_count) ? motion::LeftWrist
                                                                  : motion::RightWrist;
}

std::vector<SdfPrimitive> hand_flesh(const motion::JointTransforms& pose,
                                     const std::vector<Vec3>& fingertips, bool left,
                                     double thickness) {
  HandBuilder hand{pose, fingertips, left, thickness};
  hand.add_palm();
  for (std::size_t f = 0; f < finger_count; ++f) hand.add_finger(Finger(f));
  return std::move(hand.parts);
}

std::array<double, motion::joints_per_hand> finger_shares(const motion::JointTransforms& pose,
                                                          const std::vector<Vec3>& fingertips,
                                                          bool left, double scale,
                                                          const Vec3& point) {
  constexpr double between_fingers = 0.005;  // metres at a hand of 0.189 m
  constexpr double beside_thumb = 0.016;
  const Vec3& wrist =
      pose.positions[static_cast<std::size_t>(left ? motion::LeftWrist : motion::RightWrist)];
  std::array<FingerLine, finger_count> lines;
  std::array<double, finger_count> distances{};
  for (std::size_t f = 0; f < finger_count; ++f) {
    lines[f] = line_of(pose, fingertips, left, Finger(f));
    distances[f] = from_finger(lines[f], wrist, Finger(f), scale, point);
  }
  const auto nearest = std::ranges::min_element(distances);
  const bool is_at_thumb = nearest == distances.begin();
  std::array<double, finger_count> of_finger{};
  double sum = 0.0;
  for (std::size_t f = 0; f < finger_count; ++f) {
    const double zone = is_at_thumb || f == 0 ? beside_thumb : between_fingers;
    of_finger[f] = motion::smooth_step(1.0 - (distances[f] - *nearest) / zone);
    sum += of_finger[f];
  }
  std::array<double, motion::joints_per_hand> shares{};
  for (std::size_t f = 0; f < finger_count; ++f) {
    if (of_finger[f] == 0.0) continue;
    const auto along = shares_along(lines[f], Finger(f), scale, point);
    for (std::size_t s = 0; s < along.size(); ++s)
      shares[f * along.size() + s] = of_finger[f] / sum * along[s];
  }
  return shares;
}

std::vector<Vec3> fingertips_of(const motion::Skeleton& body, const motion::JointTransforms& pose) {
  std::vector<Vec3> tips;
  const double length = motion::hand_length(body);
  for (const bool left : {true, false}) {
    for (std::size_t f = 0; f < finger_count; ++f) {
      const auto last = static_cast<std::size_t>(
          with_body(finger_joint(left, Finger(f), motion::joints_per_finger - 1)));
      tips.push_back(pose.positions[last] +
                     pose.rotations[last] * motion::fingertip_offset(left, Finger(f), length));
    }
  }
  return tips;
}

}  // namespace mien::scenes

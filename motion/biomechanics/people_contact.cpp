#include "motion/biomechanics/people_contact.h"

#include <algorithm>
#include <array>
#include <limits>

#include "motion/biomechanics/collision_shapes.h"

namespace mien::motion {

namespace {

/// Where two bodies are deepest in each other.
struct DeepestParts {
  double depth_m = -std::numeric_limits<double>::infinity();
  std::size_t part = 0;
  std::size_t other = 0;
};

std::vector<RoundCone> shapes_in(const Clip& clip, int frame) {
  const Pose& pose = clip.poses[static_cast<std::size_t>(frame)];
  return collision_shapes(clip.body, world_transforms(clip.body, pose));
}

bool may_touch(std::string_view part) {
  return part.ends_with("hand") || part.ends_with("forearm");
}

DeepestParts deepest_parts(const std::vector<RoundCone>& one, const std::vector<RoundCone>& other) {
  const std::vector<CollisionPart>& parts = collision_parts();
  DeepestParts deepest;
  for (std::size_t i = 0; i < one.size(); ++i) {
    for (std::size_t k = 0; k < other.size(); ++k) {
      if (may_touch(parts[i].name) && may_touch(parts[k].name)) continue;
      const double depth = penetration_depth(one[i], other[k]);
      if (depth > deepest.depth_m) deepest = {depth, i, k};
    }
  }
  return deepest;
}

/// Wrists and the middles of the palms, of both sides.
std::array<Vec3, 4> hands_in(const Clip& clip, int frame) {
  const auto world = world_transforms(clip.body, clip.poses[static_cast<std::size_t>(frame)]);
  std::array<Vec3, 4> places;
  std::size_t at = 0;
  for (const BodyJoint wrist : {LeftWrist, RightWrist}) {
    const Vec3 tip = clip.body.joints[wrist].tip.value_or(Vec3::Zero());
    places[at++] = world.positions[wrist];
    places[at++] = world.positions[wrist] + 0.4 * (world.rotations[wrist] * tip);
  }
  return places;
}

}  // namespace

std::vector<PeopleOverlap> people_overlaps(const Clip& one, const Clip& other, double tolerated_m) {
  std::vector<PeopleOverlap> overlaps;
  if (!is_body(one.body) || !is_body(other.body)) return overlaps;
  const std::vector<CollisionPart>& parts = collision_parts();
  for (int frame = 0; frame < one.frame_count(); ++frame) {
    const DeepestParts deepest = deepest_parts(shapes_in(one, frame), shapes_in(other, frame));
    if (deepest.depth_m <= tolerated_m) continue;
    const bool goes_on = !overlaps.empty() && overlaps.back().last == frame - 1;
    if (!goes_on) overlaps.push_back({.first = frame});
    PeopleOverlap& overlap = overlaps.back();
    overlap.last = frame;
    if (deepest.depth_m <= overlap.depth_m) continue;
    overlap.depth_m = deepest.depth_m;
    overlap.part = parts[deepest.part].name;
    overlap.other = parts[deepest.other].name;
  }
  return overlaps;
}

NearestHands nearest_hands(const Clip& one, const Clip& other) {
  NearestHands nearest{0, std::numeric_limits<double>::infinity()};
  for (int frame = 0; frame < one.frame_count(); ++frame) {
    for (const Vec3& hand : hands_in(one, frame)) {
      for (const Vec3& reached : hands_in(other, frame)) {
        const double distance = (hand - reached).norm();
        if (distance < nearest.distance_m) nearest = {frame, distance};
      }
    }
  }
  return nearest;
}

}  // namespace mien::motion

#include "motion/animate/body_drive.h"

#include <algorithm>
#include <cmath>

#include "motion/animate/body_end.h"
#include "motion/animate/constraint.h"
#include "motion/animate/pose_change.h"

namespace mien::motion {

namespace {

constexpr double least_limb_range = 0.02;  // metres
constexpr double least_correlation = 0.5;

bool is_of_left(LimbMovement limb) { return limb <= LimbMovement::left_hand_height; }

/// The unit vector along which the movement is measured, in the frame of the body.
Vec3 direction_of(LimbMovement limb) {
  switch (limb) {
    case LimbMovement::left_hand_forward:
    case LimbMovement::right_hand_forward:
      return Vec3::UnitZ();
    case LimbMovement::left_hand_side:
      return Vec3::UnitX();
    case LimbMovement::right_hand_side:
      return -Vec3::UnitX();
    default:
      break;
  }
  return Vec3::UnitY();
}

double value_of(const Skeleton& body, const Pose& pose, LimbMovement limb) {
  const BodyEnd hand = is_of_left(limb) ? BodyEnd::left_hand : BodyEnd::right_hand;
  const Vec3 place = place_of(body, world_transforms(body, pose), hand);
  return direction_of(limb).dot(body_frame(pose).from_room(place));
}

double value_of(const Skeleton& body, const Pose& pose, BodyMovement movement) {
  const auto from_body = [&](BodyEnd end) {
    return body_frame(pose).from_room(place_of(body, world_transforms(body, pose), end));
  };
  switch (movement) {
    case BodyMovement::pelvis_height:
      return pose.root_position.y();
    case BodyMovement::pelvis_side:
      return -0.5 * (from_body(BodyEnd::left_foot) + from_body(BodyEnd::right_foot)).x();
    case BodyMovement::spine_flexion:
      return angle_of(pose, RangeAngle::spine_flexion);
    case BodyMovement::spine_lateral:
      return angle_of(pose, RangeAngle::spine_lateral);
    case BodyMovement::spine_turn:
      return angle_of(pose, RangeAngle::spine_turn);
    case BodyMovement::left_foot_forward:
      return from_body(BodyEnd::left_foot).z();
    case BodyMovement::right_foot_forward:
      break;
  }
  return from_body(BodyEnd::right_foot).z();
}

template <class Movement>
std::vector<double> values_of(const Clip& clip, Movement movement) {
  std::vector<double> values;
  values.reserve(clip.poses.size());
  for (const Pose& pose : clip.poses) values.push_back(value_of(clip.body, pose, movement));
  return values;
}

double mean_of(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(std::max<std::size_t>(1, values.size()));
}

struct Regression {
  double correlation = 0.0;
  double slope = 0.0;
};

/// Of y on x; zero if one of them does not vary.
Regression regression(const std::vector<double>& x, const std::vector<double>& y) {
  const double mean_x = mean_of(x), mean_y = mean_of(y);
  double xx = 0.0, xy = 0.0, yy = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    xx += (x[i] - mean_x) * (x[i] - mean_x);
    xy += (x[i] - mean_x) * (y[i] - mean_y);
    yy += (y[i] - mean_y) * (y[i] - mean_y);
  }
  constexpr double still = 1e-12;
  if (xx < still || yy < still) return {};
  return {xy / std::sqrt(xx * yy), xy / xx};
}

Clip with_drive(const Clip& clip, const DriveEditing& edit) {
  const std::vector<double> body = movement_of(clip, edit.body);
  const double slope = regression(body, movement_of(clip, edit.limb)).slope;
  const double mean = mean_of(body);
  const std::size_t side = is_of_left(edit.limb) ? 0 : 1;
  Clip result = clip;
  for (std::size_t f = 0; f < clip.poses.size(); ++f) {
    const Pose& pose = clip.poses[f];
    const double more = (edit.scale - 1.0) * slope * (body[f] - mean) + edit.shift;
    PoseChange change;
    change.hands[side] = more * (body_frame(pose).turn * direction_of(edit.limb));
    result.poses[f] = changed(clip.body, pose, change);
  }
  return result;
}

}  // namespace

std::vector<double> movement_of(const Clip& clip, LimbMovement limb) {
  return values_of(clip, limb);
}

std::vector<double> movement_of(const Clip& clip, BodyMovement body) {
  return values_of(clip, body);
}

std::vector<FoundDrive> drives_of(const Clip& clip) {
  std::vector<std::vector<double>> bodies;
  for (int b = 0; b < body_movement_count; ++b)
    bodies.push_back(movement_of(clip, static_cast<BodyMovement>(b)));
  std::vector<FoundDrive> found;
  for (int l = 0; l < limb_movement_count; ++l) {
    const std::vector<double> limb = movement_of(clip, static_cast<LimbMovement>(l));
    if (limb.empty()) continue;
    const auto [least, most] = std::minmax_element(limb.begin(), limb.end());
    FoundDrive best{static_cast<LimbMovement>(l), {}, 0.0, 0.0, *most - *least};
    for (int b = 0; b < body_movement_count; ++b) {
      const Regression fit = regression(bodies[static_cast<std::size_t>(b)], limb);
      if (std::abs(fit.correlation) <= std::abs(best.correlation)) continue;
      best.body = static_cast<BodyMovement>(b);
      best.correlation = fit.correlation;
      best.slope = fit.slope;
    }
    if (best.limb_range < least_limb_range || std::abs(best.correlation) < least_correlation)
      continue;
    found.push_back(best);
  }
  std::stable_sort(found.begin(), found.end(), [](const FoundDrive& a, const FoundDrive& b) {
    return std::abs(a.correlation) > std::abs(b.correlation);
  });
  return found;
}

Clip with_drives(const Clip& clip, const std::vector<DriveEditing>& edits) {
  Clip result = clip;
  for (const DriveEditing& edit : edits) {
    if (edit.scale == 1.0 && edit.shift == 0.0) continue;
    result = with_drive(result, edit);
  }
  return result;
}

}  // namespace mien::motion

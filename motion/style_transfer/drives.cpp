#include "motion/style_transfer/drives.h"

#include <array>
#include <cmath>
#include <map>
#include <numeric>

#include "motion/math/rotation.h"
#include "motion/skeleton/two_bone_ik.h"

namespace mien::motion {

namespace {

constexpr std::array<std::string_view, drive_quantity_count> names = {
    "left-hand-forward",  "left-hand-side",  "left-hand-height",  "left-hand-distance",
    "right-hand-forward", "right-hand-side", "right-hand-height", "right-hand-distance",
    "torso-bend",         "head-bend",       "pelvis-height"};

bool is_hand(DriveQuantity quantity) { return quantity < DriveQuantity::torso_bend; }

bool is_left_hand(DriveQuantity quantity) { return quantity < DriveQuantity::right_hand_forward; }

/// Which of forward, side, height and distance a hand's quantity is.
int hand_part(DriveQuantity quantity) { return static_cast<int>(quantity) % 4; }

struct HandFrame {
  Vec3 middle;  ///< between the shoulders, world
  Quat chest;   ///< chest → world
};

HandFrame hand_frame(const JointTransforms& world) {
  return {0.5 * (world.positions[LeftShoulder] + world.positions[RightShoulder]),
          world.rotations[Chest]};
}

/// From the middle between the shoulders to the wrist, frame of the chest: +X left, +Z forward.
Vec3 hand_place(const JointTransforms& world, bool left) {
  const HandFrame frame = hand_frame(world);
  return frame.chest.conjugate() * (world.positions[left ? LeftWrist : RightWrist] - frame.middle);
}

double hand_value(const Vec3& place, int part, bool left) {
  if (part == 0) return place.z();
  if (part == 1) return left ? place.x() : -place.x();
  return part == 2 ? place.y() : place.norm();
}

Vec3 hand_place_with(const Vec3& place, int part, bool left, double value) {
  Vec3 moved = place;
  if (part == 0) moved.z() = value;
  if (part == 1) moved.x() = left ? value : -value;
  if (part == 2) moved.y() = value;
  if (part == 3) moved = place.norm() > 1e-9 ? Vec3(place * (value / place.norm())) : place;
  return moved;
}

/// Forward flexion of two joints in a row: their rotation vector about the side axis.
double bend(const Pose& pose, BodyJoint lower, BodyJoint upper) {
  return log(pose.rotations[lower] * pose.rotations[upper]).x();
}

double value_in(const Skeleton& body, const Pose& pose, DriveQuantity quantity) {
  if (quantity == DriveQuantity::torso_bend) return bend(pose, Spine, Chest);
  if (quantity == DriveQuantity::head_bend) return bend(pose, Neck, Head);
  if (quantity == DriveQuantity::pelvis_height) return pose.root_position.y();
  const bool left = is_left_hand(quantity);
  return hand_value(hand_place(world_transforms(body, pose), left), hand_part(quantity), left);
}

/// Turns the limb that begins at `upper` so that its end is at `target`; the end joint keeps its
/// orientation in the world.
void reach(const Skeleton& body, Pose& pose, int upper, const Vec3& target, const Vec3& bend_hint) {
  const JointTransforms world = world_transforms(body, pose);
  const int lower = upper + 1;
  const int end = upper + 2;
  const TwoBoneSolution solution = solve_two_bone(
      {world.positions[upper], world.positions[lower], world.positions[end]}, target, bend_hint);
  const Quat upper_world = solution.upper_turn * world.rotations[upper];
  const Quat lower_world = solution.lower_turn * world.rotations[lower];
  pose.rotations[upper] =
      (world.rotations[body_parents[upper]].conjugate() * upper_world).normalized();
  pose.rotations[lower] = (upper_world.conjugate() * lower_world).normalized();
  pose.rotations[end] = (lower_world.conjugate() * world.rotations[end]).normalized();
}

void set_hand(const Skeleton& body, Pose& pose, DriveQuantity quantity, double value) {
  const bool left = is_left_hand(quantity);
  const JointTransforms world = world_transforms(body, pose);
  const HandFrame frame = hand_frame(world);
  const Vec3 place = hand_place_with(hand_place(world, left), hand_part(quantity), left, value);
  // Elbows point backward and down.
  const Vec3 hint = frame.chest * Vec3(0, -1, -1);
  reach(body, pose, left ? LeftShoulder : RightShoulder, frame.middle + frame.chest * place, hint);
}

/// Turns two joints in a row by half the change each, about the side axis of the lower one's
/// parent and repeatedly, for turns do not add up exactly.
void set_bend(Pose& pose, BodyJoint lower, BodyJoint upper, double value) {
  for (int iteration = 0; iteration < 20; ++iteration) {
    const double change = value - bend(pose, lower, upper);
    if (std::abs(change) < 1e-12) return;
    const Quat half = exp(0.5 * change * Vec3::UnitX());
    pose.rotations[lower] = (half * pose.rotations[lower]).normalized();
    pose.rotations[upper] = (half * pose.rotations[upper]).normalized();
  }
}

void set_pelvis_height(const Skeleton& body, Pose& pose, double value) {
  const JointTransforms before = world_transforms(body, pose);
  pose.root_position.y() = value;
  for (const BodyJoint hip : {LeftHip, RightHip}) {
    const Vec3 forward = before.rotations[hip] * Vec3::UnitZ();
    reach(body, pose, hip, before.positions[hip + 2], forward);
  }
}

void set_value(const Skeleton& body, Pose& pose, DriveQuantity quantity, double value) {
  if (is_hand(quantity)) return set_hand(body, pose, quantity, value);
  if (quantity == DriveQuantity::torso_bend) return set_bend(pose, Spine, Chest, value);
  if (quantity == DriveQuantity::head_bend) return set_bend(pose, Neck, Head, value);
  set_pelvis_height(body, pose, value);
}

void apply(Clip& clip, const DriveEdit& edit, double amount) {
  const std::vector<double> values = quantity_of(clip, edit.quantity);
  std::map<DriveQuantity, std::vector<double>> followers;
  std::map<DriveQuantity, double> slopes;
  for (const DriveQuantity other : edit.correlated) {
    followers[other] = quantity_of(clip, other);
    slopes[other] = drive_between(values, followers[other]).slope;
  }
  for (size_t i = 0; i < clip.poses.size(); ++i) {
    const double change = amount * ((edit.scale - 1.0) * values[i] + edit.shift);
    if (change == 0.0) continue;
    set_value(clip.body, clip.poses[i], edit.quantity, values[i] + change);
    for (const auto& [other, before] : followers) {
      set_value(clip.body, clip.poses[i], other, before[i] + slopes[other] * change);
    }
  }
}

/// A quantity at even shares of the cycle or take.
std::vector<double> at_even_shares(const Clip& clip, const std::vector<double>& values, int count) {
  std::vector<double> result;
  const auto frames = static_cast<double>(values.size());
  for (int k = 0; k < count; ++k) {
    const double frame = clip.loops ? k * frames / count : k * (frames - 1.0) / (count - 1);
    const auto whole = static_cast<size_t>(frame);
    const double next = whole + 1 < values.size() ? values[whole + 1]
                        : clip.loops              ? values.front()
                                                  : values.back();
    result.push_back(values[whole] + (frame - std::floor(frame)) * (next - values[whole]));
  }
  return result;
}

}  // namespace

std::string_view name_of(DriveQuantity quantity) { return names[static_cast<size_t>(quantity)]; }

std::vector<double> quantity_of(const Clip& clip, DriveQuantity quantity) {
  std::vector<double> values;
  for (const Pose& pose : clip.poses) values.push_back(value_in(clip.body, pose, quantity));
  return values;
}

Drive drive_between(const std::vector<double>& x, const std::vector<double>& y) {
  const auto count = static_cast<double>(x.size());
  const double mean_x = std::accumulate(x.begin(), x.end(), 0.0) / count;
  const double mean_y = std::accumulate(y.begin(), y.end(), 0.0) / count;
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;
  for (size_t i = 0; i < x.size(); ++i) {
    xx += (x[i] - mean_x) * (x[i] - mean_x);
    xy += (x[i] - mean_x) * (y[i] - mean_y);
    yy += (y[i] - mean_y) * (y[i] - mean_y);
  }
  // Quantities in metres or radians: what varies by less than a nanometre does not.
  constexpr double least_square = 1e-18;
  Drive drive;
  if (xx > least_square * count) drive.slope = xy / xx;
  drive.intercept = mean_y - drive.slope * mean_x;
  if (xx > least_square * count && yy > least_square * count) {
    drive.r_squared = xy * xy / (xx * yy);
  }
  return drive;
}

Clip driven(const Clip& motion, const std::vector<DriveEdit>& edits, const DriveOptions& options) {
  Clip result = motion;
  for (const DriveEdit& edit : edits) apply(result, edit, options.amount);
  return result;
}

std::vector<DriveEdit> drives_towards(const Clip& neutral, const Clip& styled) {
  constexpr int shares = 100;
  std::vector<DriveEdit> edits;
  // From the trunk outwards: hands hang on the chest.
  for (const DriveQuantity quantity :
       {DriveQuantity::pelvis_height, DriveQuantity::torso_bend, DriveQuantity::head_bend,
        DriveQuantity::left_hand_side, DriveQuantity::left_hand_height,
        DriveQuantity::left_hand_forward, DriveQuantity::right_hand_side,
        DriveQuantity::right_hand_height, DriveQuantity::right_hand_forward}) {
    const Drive drive =
        drive_between(at_even_shares(neutral, quantity_of(neutral, quantity), shares),
                      at_even_shares(styled, quantity_of(styled, quantity), shares));
    edits.push_back({quantity, drive.slope, drive.intercept, {}});
  }
  return edits;
}

}  // namespace mien::motion

#include "motion/gestures/acting_hand.h"

#include <algorithm>
#include <cmath>
#include <span>

#include <Eigen/Eigenvalues>

#include "motion/math/filter.h"
#include "motion/math/peaks.h"
#include "motion/math/rotation.h"
#include "motion/skeleton/hand_tip.h"
#include "motion/skeleton/pose.h"

namespace mien::motion {

namespace {

constexpr double least_rise = 0.15;         // metres
constexpr double clearly_more = 1.5;        // of one hand's path than of the other's
constexpr double raised_share = 0.5;        // of the largest distance
constexpr double held_up_share = 0.8;       // the same share, while it strokes
constexpr double least_stroke = 0.1;        // m/s
constexpr double least_stroke_share = 0.2;  // of the range of velocities
constexpr double slowest_walk = 0.25;       // m/s; a body that moves faster is walking

std::vector<Vec3> away_from_rest(const Clip& clip, bool left) {
  const BodyJoint shoulder = left ? LeftShoulder : RightShoulder;
  const BodyJoint wrist = left ? LeftWrist : RightWrist;
  const auto& joints = clip.body.joints;
  const double length =
      joints[wrist].offset.norm() + joints[left ? LeftElbow : RightElbow].offset.norm();
  std::vector<Vec3> away;
  for (const Pose& pose : clip.poses) {
    const std::vector<Vec3> places = world_positions(clip.body, pose);
    const Quat to_front = heading(pose.rotations[Pelvis] * Vec3::UnitZ()).conjugate();
    away.push_back(to_front * (places[wrist] - places[shoulder]) + length * Vec3::UnitY());
  }
  return away;
}

/// The same of the tip of the hand: a wave may be the wrist's alone.
std::vector<Vec3> tips_from_rest(const Clip& clip, bool left) {
  std::vector<Vec3> tips = away_from_rest(clip, left);
  for (size_t f = 0; f < tips.size(); ++f) {
    const Pose& pose = clip.poses[f];
    const Quat to_front = heading(pose.rotations[Pelvis] * Vec3::UnitZ()).conjugate();
    tips[f] += to_front * hand_vector(clip.body, pose, left);
  }
  return tips;
}

double path_of(const std::vector<Vec3>& places) {
  double path = 0.0;
  for (size_t i = 1; i < places.size(); ++i) path += (places[i] - places[i - 1]).norm();
  return path;
}

double highest(const std::vector<Vec3>& places) {
  double most = 0.0;
  for (const Vec3& place : places) most = std::max(most, place.y());
  return most;
}

/// Velocities along the direction in which they spread most, m/s: unlike places, they do not depend
/// on where the hand wanders while it strokes.
std::vector<double> along_strokes(std::span<const Vec3> places, double rate) {
  const std::vector<Vec3> velocities = derivative(places, rate);
  Mat3 spread = Mat3::Zero();
  for (const Vec3& velocity : velocities) spread += velocity * velocity.transpose();
  const Vec3 axis = Eigen::SelfAdjointEigenSolver<Mat3>(spread).eigenvectors().col(2);
  std::vector<double> signal;
  for (const Vec3& velocity : velocities) signal.push_back(axis.dot(velocity));
  return signal;
}

struct Frames {
  int first = 0, last = 0;
};

/// From the first frame in which the hand is farther away than `metres` to the last.
Frames farther_than(double metres, const std::vector<Vec3>& away) {
  const auto is_far = [&](const Vec3& place) { return place.norm() > metres; };
  const auto before = std::find_if(away.begin(), away.end(), is_far) - away.begin();
  const auto after = std::find_if(away.rbegin(), away.rend(), is_far) - away.rbegin();
  return {static_cast<int>(before), static_cast<int>(away.size()) - 1 - static_cast<int>(after)};
}

std::vector<double> stroke_ends(const std::vector<Vec3>& away, const Frames& held_up, double rate) {
  if (held_up.last - held_up.first < 4) return {};
  const std::vector<double> signal =
      along_strokes(std::span(away).subspan(static_cast<size_t>(held_up.first),
                                            static_cast<size_t>(held_up.last - held_up.first + 1)),
                    rate);
  const auto [least, most] = std::minmax_element(signal.begin(), signal.end());
  const double prominence = std::max(least_stroke, least_stroke_share * (*most - *least));
  std::vector<double> ends;
  for (const Peak& peak : prominent_peaks(signal, prominence, 0.0))
    ends.push_back(held_up.first + peak.place);
  return ends;
}

}  // namespace

bool is_locomotion(const Clip& clip) {
  const size_t last = clip.poses.size() - 1;
  const size_t span =
      std::min(last, static_cast<size_t>(std::lround(2.0 * clip.frames_per_second)));
  double farthest = 0.0;
  for (size_t f = span; f <= last; ++f) {
    farthest = std::max(
        farthest,
        horizontal(clip.poses[f].root_position - clip.poses[f - span].root_position).norm());
  }
  return farthest > slowest_walk * static_cast<double>(span) / clip.frames_per_second;
}

std::optional<Gesture> acting_hand(const Clip& clip) {
  if (clip.loops || clip.frame_count() < 2 || is_locomotion(clip)) return std::nullopt;
  const std::vector<Vec3> left = away_from_rest(clip, true), right = away_from_rest(clip, false);
  const double left_path = path_of(left), right_path = path_of(right);
  Gesture gesture;
  gesture.left = left_path > right_path;
  gesture.away = gesture.left ? left : right;
  if (highest(gesture.away) < least_rise) return std::nullopt;
  const bool both = highest(left) >= least_rise && highest(right) >= least_rise;
  if (both && std::max(left_path, right_path) < clearly_more * std::min(left_path, right_path))
    return std::nullopt;
  double largest = 0.0;
  for (const Vec3& place : gesture.away) largest = std::max(largest, place.norm());
  const Frames raised = farther_than(raised_share * largest, gesture.away);
  gesture.first = raised.first;
  gesture.last = raised.last;
  for (int f = gesture.first; f <= gesture.last; ++f)
    gesture.centre += gesture.away[static_cast<size_t>(f)] / (gesture.last - gesture.first + 1);
  gesture.strokes =
      stroke_ends(tips_from_rest(clip, gesture.left),
                  farther_than(held_up_share * largest, gesture.away), clip.frames_per_second);
  return gesture;
}

}  // namespace mien::motion

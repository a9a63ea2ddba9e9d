#include "motion/animate/constraint_rule.h"

#include <algorithm>
#include <cmath>

#include "motion/animate/animation_report.h"
#include "motion/animate/smooth_limit.h"
#include "motion/error.h"
#include "motion/math/rotation.h"

namespace mien::motion {

namespace {

constexpr double metre_margin = 0.05;
constexpr double angle_margin = 5.0 * radians_per_degree;

double checked_moment(const Moment& moment, const Clip& clip) {
  const double seconds = moment.seconds(clip.frames_per_second);
  const double end = clip.duration_seconds();
  if (seconds >= 0.0 && seconds <= end + 1e-9) return seconds;
  throw Error("a constraint names " + seconds_in_words(seconds) + ", but the motion lasts " +
                  seconds_in_words(end),
              "give moments of the motion");
}

CubicSpline path_through(const std::vector<PathPlace>& places, const Clip& clip) {
  std::vector<double> times;
  Eigen::MatrixXd values(static_cast<Eigen::Index>(places.size()), 3);
  for (const PathPlace& one : places) {
    values.row(static_cast<Eigen::Index>(times.size())) = one.place->transpose();
    times.push_back(checked_moment(one.at, clip));
    if (times.size() > 1 && times.back() <= times[times.size() - 2]) {
      throw Error(
          "the places of a path are not in order of time: " + seconds_in_words(times.back()) +
              " comes after " + seconds_in_words(times[times.size() - 2]),
          "give each place a later moment than the one before");
    }
  }
  return level_spline(std::move(times), values);
}

double angle_between_directions(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b)) / radians_per_degree;
}

}  // namespace

ConstraintRule::ConstraintRule(const Clip& clip, const MotionConstraint& constraint)
    : constraint_(constraint), clip_(clip), reach_(constraint.reach) {
  const double end = clip.duration_seconds();
  if (!constraint.follows.empty()) path_ = path_through(constraint.follows, clip);
  from_ = constraint.from ? checked_moment(*constraint.from, clip) : 0.0;
  to_ = constraint.to ? checked_moment(*constraint.to, clip) : end;
  is_whole_ = !constraint.from && !constraint.to && !path_;
  if (path_ && !constraint.from) from_ = path_->times.front();
  if (path_ && !constraint.to) to_ = path_->times.back();
  if (to_ < from_) {
    throw Error("a constraint ends at " + seconds_in_words(to_) + ", before it begins at " +
                    seconds_in_words(from_),
                "give from: before to:");
  }
  if (clip.loops) reach_ = std::min(reach_, 0.5 * (end - (to_ - from_)));
  const bool holds_a_place = constraint.place || constraint.stays || constraint.look_at;
  if (clip.loops && is_whole_ && holds_a_place && is_in_room() &&
      clip.cycle_displacement.norm() > 1e-6) {
    throw Error("a place in the room cannot be held throughout a loop that travels",
                "give from: and to:, or relative: body");
  }
  if (!constraint.stays) return;
  const Pose pose = pose_at(clip, from_);
  const JointTransforms world = world_transforms(clip.body, pose);
  start_place_ = place_of(clip.body, world, *constraint.part);
  start_turn_ = world.rotations[joint_of(*constraint.part)];
  if (is_in_room()) return;
  const BodyFrame body = body_frame(pose);
  start_place_ = body.from_room(start_place_);
  start_turn_ = body.turn.conjugate() * start_turn_;
}

bool ConstraintRule::is_in_room() const {
  const PlaceFrame usual = constraint_.stays ? PlaceFrame::room : PlaceFrame::body;
  return constraint_.frame.value_or(usual) == PlaceFrame::room;
}

ConstrainedFrame ConstraintRule::frame(int index) const {
  const double seconds = index / clip_.frames_per_second;
  if (is_whole_) return {1.0, seconds, Vec3::Zero()};
  const double period = clip_.duration_seconds();
  ConstrainedFrame best;
  for (const int lap : {0, -1, 1}) {
    if (lap != 0 && !clip_.loops) continue;
    const double time = seconds + lap * period;
    const double away = std::max({0.0, from_ - time, time - to_});
    const double strength =
        away == 0.0 ? 1.0 : (away >= reach_ ? 0.0 : 1.0 - smoother_step(away / reach_));
    if (strength <= best.strength) continue;
    best = {strength, time, lap * clip_.cycle_displacement};
  }
  return best;
}

bool ConstraintRule::is_of_place() const {
  return constraint_.place || path_ || constraint_.has_region() ||
         constraint_.stays == Stays::position;
}

Vec3 ConstraintRule::place_for(const Vec3& place, const BodyFrame& body,
                               const ConstrainedFrame& frame) const {
  const auto own = [&](const Vec3& room) {
    return is_in_room() ? Vec3(room + frame.lap) : body.from_room(room);
  };
  Vec3 wanted = own(place);
  if (constraint_.stays == Stays::position) wanted = start_place_;
  if (constraint_.place) wanted = *constraint_.place;
  if (path_) wanted = at_time(*path_, frame.seconds).transpose();
  for (int axis = 0; axis < 3; ++axis) {
    const RegionLimits& limits = constraint_.within[static_cast<std::size_t>(axis)];
    if (limits)
      wanted[axis] = smoothly_within(wanted[axis], (*limits)[0], (*limits)[1], metre_margin);
  }
  return is_in_room() ? Vec3(wanted - frame.lap) : body.to_room(wanted);
}

double ConstraintRule::limited(double value, double margin) const {
  const auto& least = constraint_.at_least;
  const auto& most = constraint_.at_most;
  const double unit = constraint_.angle ? radians_per_degree : 1.0;
  if (least && most) return smoothly_within(value, *least * unit, *most * unit, margin);
  if (most) return smoothly_limited(value, *most * unit, margin);
  if (least) return -smoothly_limited(-value, -*least * unit, margin);
  return value;
}

double ConstraintRule::distance_for(double metres) const {
  const double most = constraint_.at_most.value_or(metre_margin * 2.0);
  return limited(metres, std::min(metre_margin, 0.5 * most));
}

double ConstraintRule::angle_for(double radians) const { return limited(radians, angle_margin); }

Vec3 ConstraintRule::looked_at(const BodyFrame& body, const ConstrainedFrame& frame) const {
  return is_in_room() ? Vec3(*constraint_.look_at - frame.lap) : body.to_room(*constraint_.look_at);
}

Quat ConstraintRule::orientation(const BodyFrame& body) const {
  return is_in_room() ? start_turn_ : body.turn * start_turn_;
}

bool ConstraintRule::is_of_angle() const {
  return constraint_.angle || constraint_.look_at || constraint_.stays == Stays::orientation;
}

double ConstraintRule::miss(const JointTransforms& world, const Pose& pose,
                            const ConstrainedFrame& frame, const Skeleton& skeleton) const {
  const BodyFrame body = body_frame(pose);
  const auto outside = [&](double value) {
    return std::max({0.0, constraint_.at_least.value_or(value) - value,
                     value - constraint_.at_most.value_or(value)});
  };
  if (constraint_.angle) return outside(angle_of(pose, *constraint_.angle) / radians_per_degree);
  if (constraint_.look_at) {
    const Vec3 way = looked_at(body, frame) - place_of(skeleton, world, BodyEnd::head);
    return angle_between_directions(world.rotations[Head] * Vec3::UnitZ(), way);
  }
  const Vec3 place = place_of(skeleton, world, *constraint_.part);
  if (constraint_.distance_to)
    return outside((place - place_of(skeleton, world, *constraint_.distance_to)).norm());
  if (constraint_.stays == Stays::orientation) {
    return angle_between(orientation(body), world.rotations[joint_of(*constraint_.part)]) /
           radians_per_degree;
  }
  if (!constraint_.has_region()) return (place_for(place, body, frame) - place).norm();
  const Vec3 own = is_in_room() ? Vec3(place + frame.lap) : body.from_room(place);
  double most = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    const RegionLimits& limits = constraint_.within[static_cast<std::size_t>(axis)];
    if (limits) most = std::max({most, (*limits)[0] - own[axis], own[axis] - (*limits)[1]});
  }
  return most;
}

}  // namespace mien::motion

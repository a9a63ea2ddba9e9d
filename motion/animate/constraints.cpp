#include "motion/animate/constraints.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "motion/animate/constraint_rule.h"
#include "motion/animate/joint_excess.h"
#include "motion/animate/pose_change.h"
#include "motion/error.h"
#include "motion/math/filter.h"
#include "motion/math/rotation.h"

namespace mien::motion {

namespace {

constexpr int frame_passes = 8;          // of lean and gaze
constexpr int frame_halvings = 8;        // of what a joint stops
constexpr double easing_seconds = 0.15;  // around frames in which a joint stops
constexpr double short_leg = 5e-4;       // metres

std::size_t side_of(BodyEnd end) {
  return end == BodyEnd::left_hand || end == BodyEnd::left_foot ? 0 : 1;
}

bool is_hand(BodyEnd end) { return end == BodyEnd::left_hand || end == BodyEnd::right_hand; }
bool is_foot(BodyEnd end) { return end == BodyEnd::left_foot || end == BodyEnd::right_foot; }

/// A constraint that acts on a frame.
struct Acting {
  const ConstraintRule* rule;
  ConstrainedFrame frame;

  const MotionConstraint& constraint() const { return rule->constraint(); }
};

/// What the constraints change of one pose.
class FrameSolver {
 public:
  FrameSolver(const Skeleton& body, const Pose& pose, std::vector<Acting> acting)
      : body_(body), pose_(pose), acting_(std::move(acting)) {}

  /// Why a changed pose is not possible: a joint out of its range, or a leg too short for a foot
  /// that is to stay; empty if it is.
  std::string stop(const Pose& after) const {
    const std::string joint = joint_stop(pose_, after);
    if (!joint.empty()) return joint;
    const JointTransforms then = world_transforms(body_, pose_);
    const JointTransforms now = world_transforms(body_, after);
    for (const BodyEnd foot : {BodyEnd::left_foot, BodyEnd::right_foot}) {
      const Vec3 place = place_of(body_, then, foot) + change_.feet[side_of(foot)];
      if ((place_of(body_, now, foot) - place).norm() > short_leg) return "the length of the legs";
    }
    return "";
  }

  /// The changed pose, with a share of all changes.
  Pose solve(double share) {
    share_ = share;
    change_ = {};
    set_angles();
    set_frame();
    move_pelvis();
    move_feet();
    lean();
    move_hands();
    hold_distances();
    look();
    keep_orientations();
    return now();
  }

 private:
  double strength(const Acting& one) const { return share_ * one.frame.strength; }

  Pose now() const { return changed(body_, angled_, change_); }
  JointTransforms world() const { return world_transforms(body_, now()); }

  template <class Take>
  void each(const Take& take) const {
    for (const Acting& one : acting_) take(one);
  }

  void set_angles() {
    angled_ = pose_;
    each([&](const Acting& one) {
      if (!one.constraint().angle) return;
      const RangeAngle angle = *one.constraint().angle;
      const double before = angle_of(angled_, angle);
      const double after = one.rule->angle_for(before);
      if (after != before)
        angled_ = with_angle(angled_, angle, before + strength(one) * (after - before));
    });
  }

  void set_frame() { frame_ = body_frame(angled_); }

  /// The shift of a part to where its constraints of place want it.
  Vec3 wanted_shift(BodyEnd part, const Vec3& place) const {
    Vec3 shift = Vec3::Zero();
    each([&](const Acting& one) {
      if (one.constraint().part != part || !one.rule->is_of_place()) return;
      const Vec3 from = place + shift;
      shift += strength(one) * (one.rule->place_for(from, frame_, one.frame) - from);
    });
    return shift;
  }

  void move_pelvis() { change_.pelvis = wanted_shift(BodyEnd::pelvis, angled_.root_position); }

  void move_feet() {
    const JointTransforms before = world_transforms(body_, angled_);
    for (const BodyEnd foot : {BodyEnd::left_foot, BodyEnd::right_foot})
      change_.feet[side_of(foot)] = wanted_shift(foot, place_of(body_, before, foot));
  }

  void lean() {
    const JointTransforms before = world();
    std::array<Vec3, 2> targets;
    std::array<double, 2> strengths = {0.0, 0.0}, usual;
    for (const BodyEnd hand : {BodyEnd::left_hand, BodyEnd::right_hand}) {
      const Vec3 place = place_of(body_, before, hand);
      targets[side_of(hand)] = place + wanted_shift(hand, place);
      usual[side_of(hand)] = usual_reach(body_, before, hand == BodyEnd::left_hand);
      each([&](const Acting& one) {
        if (one.constraint().part == hand && one.rule->is_of_place())
          strengths[side_of(hand)] = std::max(strengths[side_of(hand)], strength(one));
      });
    }
    Vec3 leans = Vec3::Zero();
    for (int pass = 0; pass < frame_passes; ++pass) {
      const JointTransforms leant = world();
      Vec3 sum = Vec3::Zero();
      double weights = 0.0;
      for (const std::size_t side : {0U, 1U}) {
        if (strengths[side] == 0.0) continue;
        const Vec3 one =
            strengths[side] * lean_towards(body_, leant, side == 0, targets[side], usual[side]);
        sum += one.norm() * one;
        weights += one.norm();
      }
      if (weights == 0.0) return;
      leans += sum / weights;
      change_.trunk = bounded_lean(leans);
    }
  }

  void move_hands() {
    const JointTransforms leant = world();
    for (const BodyEnd hand : {BodyEnd::left_hand, BodyEnd::right_hand})
      change_.hands[side_of(hand)] = wanted_shift(hand, place_of(body_, leant, hand));
  }

  void hold_distances() {
    each([&](const Acting& one) {
      if (!one.constraint().distance_to) return;
      BodyEnd moved = *one.constraint().part, other = *one.constraint().distance_to;
      if (!is_hand(moved)) std::swap(moved, other);
      const JointTransforms at = world();
      const Vec3 way = place_of(body_, at, moved) - place_of(body_, at, other);
      const double distance = way.norm();
      if (distance < 1e-9) return;
      const double more = strength(one) * (one.rule->distance_for(distance) - distance);
      const Vec3 shift = more / distance * way;
      change_.hands[side_of(moved)] += is_hand(other) ? Vec3(0.5 * shift) : shift;
      if (is_hand(other)) change_.hands[side_of(other)] -= 0.5 * shift;
    });
  }

  void look() {
    each([&](const Acting& one) {
      if (!one.constraint().look_at) return;
      const Vec3 place = one.rule->looked_at(frame_, one.frame);
      Quat turn = Quat::Identity();
      change_.gaze.setZero();
      for (int pass = 0; pass < frame_passes; ++pass) {
        const JointTransforms at = world();
        const Vec3 way = place - place_of(body_, at, BodyEnd::head);
        turn = turn_between(at.rotations[Head] * Vec3::UnitZ(), way) * turn;
        change_.gaze = log(turn);
      }
      change_.gaze *= strength(one);
    });
  }

  void keep_orientations() {
    each([&](const Acting& one) {
      if (one.constraint().stays != Stays::orientation) return;
      const BodyEnd part = *one.constraint().part;
      const Quat own = world().rotations[joint_of(part)];
      const Vec3 turn =
          strength(one) *
          log(in_hemisphere_of(Quat::Identity(), one.rule->orientation(frame_) * own.conjugate()));
      if (is_hand(part)) change_.hand_turns[side_of(part)] = turn;
      if (is_foot(part)) change_.foot_turns[side_of(part)] = turn;
      if (part == BodyEnd::head) change_.gaze = log(exp(turn) * exp(change_.gaze));
    });
  }

  const Skeleton& body_;
  const Pose& pose_;
  std::vector<Acting> acting_;
  double share_ = 1.0;
  Pose angled_;
  BodyFrame frame_;
  PoseChange change_;
};

class ConstraintSolver {
 public:
  ConstraintSolver(const Clip& clip, const std::vector<MotionConstraint>& constraints)
      : clip_(clip) {
    rules_.reserve(constraints.size());
    for (const MotionConstraint& one : constraints) rules_.emplace_back(clip, one);
  }

  AnimatedClip solve() {
    AnimatedClip made{clip_, {}, {}};
    const std::vector<double> stopped = stopped_shares();
    for (int f = 0; f < clip_.frame_count(); ++f) {
      std::vector<Acting> acting = acting_on(f);
      if (acting.empty()) continue;
      Pose& pose = made.clip.poses[static_cast<std::size_t>(f)];
      const Pose before = pose;
      pose = FrameSolver(clip_.body, before, std::move(acting))
                 .solve(std::max(0.0, 1.0 - stopped[static_cast<std::size_t>(f)]));
    }
    report(made, stopped);
    return made;
  }

 private:
  std::vector<Acting> acting_on(int frame) const {
    std::vector<Acting> acting;
    for (const ConstraintRule& rule : rules_) {
      const ConstrainedFrame at = rule.frame(frame);
      if (at.strength > 0.0) acting.push_back({&rule, at});
    }
    return acting;
  }

  /// By what share the constraints of each frame act less, so that joints stay in their ranges.
  std::vector<double> stopped_shares() {
    std::vector<double> stopped(clip_.poses.size(), 0.0);
    reasons_.assign(clip_.poses.size(), "");
    for (int f = 0; f < clip_.frame_count(); ++f) {
      std::vector<Acting> acting = acting_on(f);
      if (acting.empty()) continue;
      const auto at = static_cast<std::size_t>(f);
      const Pose& pose = clip_.poses[at];
      FrameSolver solver(clip_.body, pose, std::move(acting));
      const auto stop = [&](double share) { return solver.stop(solver.solve(share)); };
      reasons_[at] = stop(1.0);
      if (reasons_[at].empty()) continue;
      double free = 0.0, hindered = 1.0;
      for (int i = 0; i < frame_halvings; ++i) {
        const double tried = 0.5 * (free + hindered);
        (stop(tried).empty() ? free : hindered) = tried;
      }
      stopped[at] = 1.0 - free;
    }
    const int width =
        std::max(1, static_cast<int>(std::lround(easing_seconds * clip_.frames_per_second)));
    return smooth_envelope(stopped, width, clip_.loops);
  }

  std::string reason_at(int frame, const std::vector<double>& stopped) const {
    if (stopped[static_cast<std::size_t>(frame)] < 1e-9) return "out of reach";
    const int width =
        std::max(1, static_cast<int>(std::lround(easing_seconds * clip_.frames_per_second)));
    for (int away = 0; away <= 2 * width; ++away) {
      for (const int f : {frame - away, frame + away}) {
        const int count = clip_.frame_count();
        const int own = clip_.loops ? (f % count + count) % count : std::clamp(f, 0, count - 1);
        const std::string& reason = reasons_[static_cast<std::size_t>(own)];
        if (!reason.empty()) return "stopped by " + reason;
      }
    }
    return "stopped by a joint";
  }

  void report(AnimatedClip& made, const std::vector<double>& stopped) const {
    for (const ConstraintRule& rule : rules_) {
      double worst = 0.0;
      int worst_frame = 0;
      for (int f = 0; f < clip_.frame_count(); ++f) {
        const ConstrainedFrame at = rule.frame(f);
        if (at.strength < 1.0) continue;
        const Pose& pose = made.clip.poses[static_cast<std::size_t>(f)];
        const double miss = rule.miss(world_transforms(clip_.body, pose), pose, at, clip_.body);
        if (miss <= worst) continue;
        worst = miss;
        worst_frame = f;
      }
      const bool is_angle = rule.is_of_angle();
      if (worst <= (is_angle ? least_miss_deg : least_miss)) continue;
      const std::string part =
          rule.constraint().angle
              ? std::string("angle")
              : std::string(name_of(rule.constraint().part.value_or(BodyEnd::head)));
      made.misses.push_back({part, worst_frame, worst_frame / clip_.frames_per_second, worst,
                             is_angle, reason_at(worst_frame, stopped)});
      made.remarks.push_back(sentence_of(made.misses.back(), "its constraint"));
    }
    const std::size_t held = rules_.size() - made.misses.size();
    made.remarks.insert(
        made.remarks.begin(),
        std::to_string(held) + " of " + std::to_string(rules_.size()) + " constraints are held");
  }

  const Clip& clip_;
  std::vector<ConstraintRule> rules_;
  std::vector<std::string> reasons_;  ///< what stops the constraints of each frame
};

}  // namespace

AnimatedClip with_constraints(const Clip& clip, const std::vector<MotionConstraint>& constraints) {
  if (!is_body(clip.body))
    throw Error("the motion is not one of the canonical body", "retarget it first");
  if (constraints.empty() || clip.poses.empty()) return {clip, {}, {}};
  return ConstraintSolver(clip, constraints).solve();
}

}  // namespace mien::motion

#include "motion/animate/keys.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "motion/animate/change_curves.h"
#include "motion/error.h"
#include "motion/gait/contact.h"
#include "motion/math/rotation.h"

namespace mien::motion {

namespace {

constexpr int key_passes = 12;                           // of lean and gaze
constexpr double free_turn = 60.0 * radians_per_degree;  // of the gaze, to each side

ChangePart part_of(BodyEnd end) {
  constexpr ChangePart parts[] = {ChangePart::left_hand, ChangePart::right_hand,
                                  ChangePart::left_foot, ChangePart::right_foot,
                                  ChangePart::gaze,      ChangePart::pelvis};
  return parts[static_cast<std::size_t>(end)];
}

/// What the body does at one moment.
struct Goal {
  double seconds = 0.0;
  double reach = 0.0;
  Pose pose;                                                 ///< of the motion
  JointTransforms world;                                     ///< of that pose
  std::array<std::optional<Vec3>, body_ends.size()> places;  ///< room
  std::optional<Vec3> look_at;                               ///< room
};

Vec3 in_room(const Vec3& place, PlaceFrame frame, const BodyFrame& body, const Vec3& own) {
  switch (frame) {
    case PlaceFrame::room:
      return place;
    case PlaceFrame::motion:
      return own + body.turn * place;
    case PlaceFrame::body:
      break;
  }
  return body.to_room(place);
}

Goal goal_of(const AnimatorKey& key, const Clip& clip) {
  const double seconds = seconds_within(key.at, clip, "a key is at");
  if (!(key.reach > 0.0)) throw Error("a key's reach is not above 0", "give seconds, such as 0.5");
  Goal goal{seconds, key.reach, pose_at(clip, seconds), {}, {}, {}};
  goal.world = world_transforms(clip.body, goal.pose);
  const BodyFrame body = body_frame(goal.pose);
  for (const BodyEnd end : body_ends) {
    const auto& place = key.places[static_cast<std::size_t>(end)];
    if (!place) continue;
    goal.places[static_cast<std::size_t>(end)] =
        in_room(*place, key.frame, body, place_of(clip.body, goal.world, end));
  }
  if (key.look_at) {
    goal.look_at =
        in_room(*key.look_at, key.frame, body, place_of(clip.body, goal.world, BodyEnd::head));
  }
  return goal;
}

void check_twice(const Goal& a, const Goal& b) {
  if (std::abs(a.seconds - b.seconds) > moment_tolerance) return;
  for (const BodyEnd end : body_ends) {
    const auto at = static_cast<std::size_t>(end);
    const bool both = a.places[at] && b.places[at];
    const bool look = end == BodyEnd::head && a.look_at && b.look_at;
    if (!both && !look) continue;
    throw Error(
        "two keys place the " + std::string(name_of(end)) + " at " + seconds_in_words(a.seconds),
        "omit one of them");
  }
}

/// How a foot's key acts without moving its other contacts.
CurveKey planted_key(const Clip& clip, const std::vector<FootPlant>& plants, bool left,
                     CurveKey key) {
  const double rate = clip.frames_per_second;
  const double period = clip.loops ? clip.duration_seconds() : 0.0;
  const double moment = key.from;
  const std::vector<double> laps =
      clip.loops ? std::vector<double>{-period, 0.0, period} : std::vector<double>{0.0};
  for (const FootPlant& plant : plants) {
    for (const double lap : laps) {
      const double first = plant.first / rate + lap, last = plant.last / rate + lap;
      if (plant.left != left || moment < first || moment > last) continue;
      key.from = first;
      key.to = last;
    }
  }
  const double frame = 1.0 / rate;
  for (const FootPlant& plant : plants) {
    for (const double lap : laps) {
      const double first = plant.first / rate + lap, last = plant.last / rate + lap;
      if (plant.left != left || (first <= key.from && last >= key.to && key.to > key.from))
        continue;
      if (last < key.from) key.before = std::min(key.before, std::max(frame, key.from - last));
      if (first > key.to) key.after = std::min(key.after, std::max(frame, first - key.to));
    }
  }
  return key;
}

class KeySolver {
 public:
  KeySolver(const Clip& clip, const std::vector<AnimatorKey>& keys) : clip_(clip), curves_(clip) {
    for (const AnimatorKey& key : keys) goals_.push_back(goal_of(key, clip));
    std::sort(goals_.begin(), goals_.end(),
              [](const Goal& a, const Goal& b) { return a.seconds < b.seconds; });
    for (std::size_t i = 0; i < goals_.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) check_twice(goals_[i], goals_[j]);
    }
  }

  AnimatedClip solve() {
    place_pelvis();
    place_feet();
    for (const ChangePart part :
         {ChangePart::pelvis, ChangePart::left_foot, ChangePart::right_foot})
      stop(part);
    lean();
    stop(ChangePart::trunk);
    place_hands();
    stop(ChangePart::left_hand);
    stop(ChangePart::right_hand);
    direct_gaze();
    stop(ChangePart::gaze);
    return result();
  }

 private:
  static const std::optional<Vec3>& place(const Goal& goal, BodyEnd end) {
    return goal.places[static_cast<std::size_t>(end)];
  }

  static CurveKey key_at(const Goal& goal, const Vec3& value) {
    return {goal.seconds, goal.seconds, value, goal.reach, goal.reach};
  }

  JointTransforms world_at(const Goal& goal) const {
    return world_transforms(clip_.body, changed(clip_.body, goal.pose, curves_.at(goal.seconds)));
  }

  Vec3 from_motion(const Goal& goal, BodyEnd end) const {
    return *place(goal, end) - place_of(clip_.body, goal.world, end);
  }

  void place_pelvis() {
    for (const Goal& goal : goals_) {
      if (place(goal, BodyEnd::pelvis))
        curves_.put_key(ChangePart::pelvis, key_at(goal, from_motion(goal, BodyEnd::pelvis)));
    }
  }

  /// Moves the pelvis along with a foot that would be out of reach in a frame of its key.
  void follow_foot(BodyEnd foot, const CurveKey& key) {
    for (const CurveKey& other : curves_.keys(ChangePart::pelvis))
      if (other.to >= key.from && other.from <= key.to) return;
    CurveKey shift = key;
    shift.value = curves_.at(ChangePart::pelvis, key.from);
    for (int pass = 0; pass < key_passes; ++pass) {
      const Vec3 more = missing_shift(foot, key);
      if (more.norm() < 1e-6) return;
      shift.value += more;
      curves_.put_key(ChangePart::pelvis, shift);
    }
  }

  /// How far the pelvis has to move for the foot, in the frame of the key where that is farthest.
  Vec3 missing_shift(BodyEnd foot, const CurveKey& key) const {
    const bool left = foot == BodyEnd::left_foot;
    const double rate = clip_.frames_per_second;
    Vec3 most = Vec3::Zero();
    const auto last = static_cast<int>(std::floor((key.to + key.after) * rate));
    for (auto f = static_cast<int>(std::ceil((key.from - key.before) * rate)); f <= last; ++f) {
      if (!clip_.loops && (f < 0 || f >= clip_.frame_count())) continue;
      Pose pose = pose_at(clip_, f / rate);
      const JointTransforms before = world_transforms(clip_.body, pose);
      pose.root_position += curves_.at(ChangePart::pelvis, f / rate);
      const Vec3 there = place_of(clip_.body, before, foot) + curves_.at(part_of(foot), f / rate);
      const Vec3 more = shift_towards(clip_.body, world_transforms(clip_.body, pose), left, there,
                                      usual_extension(before, left));
      if (more.norm() > most.norm()) most = more;
    }
    return most;
  }

  void place_feet() {
    ContactOptions contact;
    contact.floor_velocity = floor_velocity(clip_);
    std::vector<FootPlant> plants;
    for (const BodyEnd foot : {BodyEnd::left_foot, BodyEnd::right_foot}) {
      for (const Goal& goal : goals_) {
        if (!place(goal, foot)) continue;
        if (plants.empty()) plants = foot_plants(clip_, contact);
        const CurveKey key = planted_key(clip_, plants, foot == BodyEnd::left_foot,
                                         key_at(goal, from_motion(goal, foot)));
        for (const CurveKey& known : curves_.keys(part_of(foot))) {
          if (known.from != key.from) continue;
          throw Error("two keys move the " + std::string(name_of(foot)) + " in its contact from " +
                          seconds_in_words(key.from) + " to " + seconds_in_words(key.to),
                      "give one key for each contact");
        }
        curves_.put_key(part_of(foot), key);
        follow_foot(foot, key);
      }
    }
  }

  /// How far the trunk has to turn farther for the hands and the gaze of a goal.
  Vec3 missing_lean(const Goal& goal) const {
    const JointTransforms world = world_at(goal);
    Vec3 sum = Vec3::Zero();
    double weights = 0.0;
    for (const BodyEnd hand : {BodyEnd::left_hand, BodyEnd::right_hand}) {
      if (!place(goal, hand)) continue;
      const bool left = hand == BodyEnd::left_hand;
      const Vec3 lean = lean_towards(clip_.body, world, left, *place(goal, hand),
                                     usual_reach(clip_.body, goal.world, left));
      sum += lean.norm() * lean;
      weights += lean.norm();
    }
    if (weights > 0.0) sum /= weights;
    if (goal.look_at) {
      const Vec3 way = world.rotations[Chest].conjugate() *
                       (*goal.look_at - place_of(clip_.body, world, BodyEnd::head));
      const double side = std::atan2(way.x(), way.z());
      const double more = std::max(0.0, std::abs(side) - free_turn);
      sum += world.rotations[Chest] * Vec3(0.0, std::copysign(more, side), 0.0);
    }
    return sum;
  }

  void lean() {
    std::vector<Vec3> leans;
    for (const Goal& goal : goals_) leans.push_back(curves_.at(ChangePart::trunk, goal.seconds));
    for (int pass = 0; pass < key_passes; ++pass) {
      for (std::size_t g = 0; g < goals_.size(); ++g) {
        const Vec3 more = missing_lean(goals_[g]);
        if (more.isZero(0.0)) continue;
        leans[g] += more;
        curves_.put_key(ChangePart::trunk, key_at(goals_[g], bounded_lean(leans[g])));
      }
    }
  }

  void place_hands() {
    for (const BodyEnd hand : {BodyEnd::left_hand, BodyEnd::right_hand}) {
      for (const Goal& goal : goals_) {
        if (!place(goal, hand)) continue;
        const bool left = hand == BodyEnd::left_hand;
        const JointTransforms carried = world_without(goal, part_of(hand));
        const auto swing_arm = [&](const Vec3& there) {
          const ArmSwing swing = swing_to(clip_.body, carried, left, there);
          curves_.put_key(part_of(hand), key_at(goal, swing.swing));
          curves_.put_key(*stretch_of(part_of(hand)), key_at(goal, Vec3(swing.stretch, 0, 0)));
        };
        swing_arm(*place(goal, hand));
        const Vec3 reached = place_of(clip_.body, world_at(goal), hand);
        if ((reached - *place(goal, hand)).norm() > 1e-9) swing_arm(reached);
      }
    }
  }

  JointTransforms world_without(const Goal& goal, ChangePart hand) const {
    PoseChange change = curves_.at(goal.seconds);
    const std::size_t side = hand == ChangePart::left_hand ? 0 : 1;
    change.swings[side].setZero();
    change.stretches[side] = 0.0;
    return world_transforms(clip_.body, changed(clip_.body, goal.pose, change));
  }

  void direct_gaze() {
    for (const Goal& goal : goals_) {
      if (!goal.look_at) continue;
      Quat turn = Quat::Identity();
      for (int pass = 0; pass < key_passes; ++pass) {
        const JointTransforms world = world_at(goal);
        const Vec3 way = *goal.look_at - place_of(clip_.body, world, BodyEnd::head);
        const Vec3 face = world.rotations[Head] * Vec3::UnitZ();
        turn = turn_between(face, way) * (pass == 0 ? Quat::Identity() : turn);
        curves_.put_key(ChangePart::gaze, key_at(goal, log(turn)));
      }
    }
  }

  void stop(ChangePart part) {
    for (StoppedKey& key : stop_at_joint_limits(clip_, curves_, part))
      stopped_.push_back({part, std::move(key)});
  }

  std::string reason_for(const Goal& goal, ChangePart part) const {
    for (const auto& [stopped, key] : stopped_) {
      if (stopped == part && std::abs(key.seconds - goal.seconds) <= goal.reach)
        return "stopped by " + key.reason;
    }
    return "out of reach";
  }

  void add_miss(const Goal& goal, BodyEnd end, double amount, bool is_angle,
                AnimatedClip& made) const {
    if (amount <= (is_angle ? least_miss_deg : least_miss)) return;
    const int frame = static_cast<int>(std::lround(goal.seconds * clip_.frames_per_second));
    made.misses.push_back({std::string(name_of(end)), frame, goal.seconds, amount, is_angle,
                           reason_for(goal, part_of(end))});
    made.remarks.push_back(sentence_of(made.misses.back(), "its key"));
  }

  AnimatedClip result() const {
    AnimatedClip made{clip_, {}, {}};
    for (int f = 0; f < clip_.frame_count(); ++f) {
      Pose& pose = made.clip.poses[static_cast<std::size_t>(f)];
      pose = changed(clip_.body, pose, curves_.at(f / clip_.frames_per_second));
    }
    int count = 0;
    for (const Goal& goal : goals_) {
      const JointTransforms world = world_at(goal);
      for (const BodyEnd end : body_ends) {
        if (!place(goal, end)) continue;
        add_miss(goal, end, (place_of(clip_.body, world, end) - *place(goal, end)).norm(), false,
                 made);
        ++count;
      }
      if (!goal.look_at) continue;
      const Vec3 way = *goal.look_at - place_of(clip_.body, world, BodyEnd::head);
      const Vec3 face = world.rotations[Head] * Vec3::UnitZ();
      const double angle = std::atan2(face.cross(way).norm(), face.dot(way));
      add_miss(goal, BodyEnd::head, angle / radians_per_degree, true, made);
      ++count;
    }
    const int held = count - static_cast<int>(made.misses.size());
    made.remarks.insert(made.remarks.begin(),
                        "keys held: " + std::to_string(held) + " of " + std::to_string(count));
    return made;
  }

  const Clip& clip_;
  ChangeCurves curves_;
  std::vector<Goal> goals_;
  std::vector<std::pair<ChangePart, StoppedKey>> stopped_;
};

}  // namespace

AnimatedClip with_keys(const Clip& clip, const std::vector<AnimatorKey>& keys) {
  if (!is_body(clip.body))
    throw Error("the motion is not one of the canonical body", "retarget it first");
  if (keys.empty() || clip.poses.empty()) return {clip, {}, {}};
  return KeySolver(clip, keys).solve();
}

}  // namespace mien::motion

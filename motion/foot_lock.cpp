#include "motion/foot_lock.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "motion/foot_path.h"
#include "motion/rotation.h"
#include "motion/two_bone_ik.h"

namespace mien::motion {

namespace {

/// A foot that is just leaving the floor may move: drift is measured a little below the height at
/// which the lock lets go.
constexpr double standing_share = 0.7;

/// A foot's corrected place at one frame of a plant.
struct FootPlace {
  Vec3 ankle;
  Quat rotation;
};

/// What is added to the foot at one frame: translation, and rotation vector from the left.
struct Correction {
  Vec3 translation = Vec3::Zero();
  Vec3 turn = Vec3::Zero();
};

/// 1 at 0, 0 at and beyond 1, level at both.
double fade(double x) {
  if (x <= 0.0) return 1.0;
  if (x >= 1.0) return 0.0;
  return 2.0 * x * x * x - 3.0 * x * x + 1.0;
}

Quat mean_rotation(const FootPath& path, int first, int last) {
  Quat mean = path.rotation_at((first + last) / 2);
  for (int iteration = 0; iteration < 3; ++iteration) {
    Vec3 step = Vec3::Zero();
    for (int f = first; f <= last; ++f) step += log(mean.conjugate() * path.rotation_at(f));
    mean = (mean * exp(step / (last - first + 1))).normalized();
  }
  return mean;
}

/// The rotation of a foot that stands, without the lift of the toes that a badly calibrated capture
/// gives it: nobody stands on his heels.
Quat without_toe_lift(const Quat& sole, const FootPath& path) {
  const Vec3 along = sole * (path.ball_in_foot - path.heel_in_foot);
  if (along.y() <= 0.0) return sole;
  return (Quat::FromTwoVectors(along, Vec3(along.x(), 0.0, along.z())) * sole).normalized();
}

/// Where the foot stands at each frame of its stance, in unrolled coordinates. Over the floor the
/// pivot stays where it is; its height is the input's, so that a foot may roll on over its toes.
std::vector<FootPlace> standing(const FootPath& path, const Stance& stance, double turn_frames) {
  const Quat sole =
      without_toe_lift(mean_rotation(path, stance.flat_first, stance.flat_last), path);
  Vec3 ball = Vec3::Zero();
  for (int f = stance.flat_first; f <= stance.flat_last; ++f) ball += path.ball_at(f);
  ball /= stance.flat_last - stance.flat_first + 1;
  const Vec3 heel = ball + sole * (path.heel_in_foot - path.ball_in_foot);
  const double ball_lift = ball.y() - path.ball_at(stance.flat_last).y();
  const double heel_lift = heel.y() - path.heel_at(stance.flat_first).y();

  std::vector<FootPlace> places;
  for (int f = stance.first; f <= stance.last; ++f) {
    const int edge = std::clamp(f, stance.flat_first, stance.flat_last);
    const Vec3 flatten = log(sole * path.rotation_at(edge).conjugate());
    const double share = fade(std::abs(f - edge) / turn_frames);
    const Quat turned = f == edge ? sole : exp(share * flatten) * path.rotation_at(f);
    const bool on_heel = f < stance.flat_first;
    Vec3 pivot = on_heel ? heel : ball;
    if (on_heel) pivot.y() = std::max(heel.y(), path.heel_at(f).y() + share * heel_lift);
    if (f > stance.flat_last)
      pivot.y() = std::max(ball.y(), path.ball_at(f).y() + share * ball_lift);
    places.push_back({pivot - turned * (on_heel ? path.heel_in_foot : path.ball_in_foot), turned});
  }
  return places;
}

/// Corrections of one foot for every frame: exact in the plants, fading over the swings.
std::vector<Correction> corrections(const FootPath& path, std::vector<FootPlant> plants,
                                    double frames_per_second, const FootLockOptions& options) {
  const int count = path.frame_count();
  std::vector<Correction> result(static_cast<size_t>(count));
  std::vector<bool> planted(static_cast<size_t>(count), false);
  const double turn_frames = std::max(1.0, 0.1 * frames_per_second);
  struct Edge {
    int frame;
    Correction correction;
  };
  std::vector<Edge> starts, ends;
  for (const FootPlant& plant : plants) {
    const Stance stance = stance_of(path, plant, options.flat_metres, options.lifted_metres);
    const auto places = standing(path, stance, turn_frames);
    for (int f = stance.first; f <= stance.last; ++f) {
      const FootPlace& place = places[static_cast<size_t>(f - stance.first)];
      const auto at = static_cast<size_t>(path.wrapped(f));
      result[at] = {place.ankle - path.ankle_at(f),
                    log(place.rotation * path.rotation_at(f).conjugate())};
      planted[at] = true;
    }
    starts.push_back({stance.first, result[static_cast<size_t>(path.wrapped(stance.first))]});
    ends.push_back({stance.last, result[static_cast<size_t>(path.wrapped(stance.last))]});
  }
  const double reach = options.blend_seconds * frames_per_second;
  const auto frames_after = [&](int from, int to) {
    return path.loops ? ((to - from) % count + count) % count : to - from;
  };
  for (int f = 0; f < count; ++f) {
    if (planted[static_cast<size_t>(f)]) continue;
    const Edge* before = nullptr;
    const Edge* after = nullptr;
    for (const Edge& end : ends) {
      const int since = frames_after(end.frame, f);
      if (since > 0 && (!before || since < frames_after(before->frame, f))) before = &end;
    }
    for (const Edge& start : starts) {
      const int until = frames_after(f, start.frame);
      if (until > 0 && (!after || until < frames_after(f, after->frame))) after = &start;
    }
    double fade_out = reach;
    if (before && after) {
      fade_out =
          std::min(reach, 0.5 * (frames_after(before->frame, f) + frames_after(f, after->frame)));
    }
    Correction& correction = result[static_cast<size_t>(f)];
    if (before) {
      const double share = fade(frames_after(before->frame, f) / fade_out);
      correction.translation += share * before->correction.translation;
      correction.turn += share * before->correction.turn;
    }
    if (after) {
      const double share = fade(frames_after(f, after->frame) / fade_out);
      correction.translation += share * after->correction.translation;
      correction.turn += share * after->correction.turn;
    }
  }
  return result;
}

std::vector<FootPlant> plants_of(const std::vector<FootPlant>& plants, bool left) {
  std::vector<FootPlant> own;
  std::copy_if(plants.begin(), plants.end(), std::back_inserter(own),
               [&](const FootPlant& plant) { return plant.left == left; });
  return own;
}

/// How far a foot hangs above the floor (y = 0), or is below it, while it stands flat. Mean over
/// its plants; nothing without any.
std::optional<double> hang(const Clip& clip, const std::vector<FootPlant>& plants, bool left,
                           const FootLockOptions& options) {
  const FootPath path = foot_path(clip, left);
  const std::vector<FootPlant> own = plants_of(plants, left);
  if (own.empty()) return std::nullopt;
  double sum = 0.0;
  for (const FootPlant& plant : own) {
    const Stance stance = stance_of(path, plant, options.flat_metres, options.lifted_metres);
    double height = 0.0;
    for (int f = stance.flat_first; f <= stance.flat_last; ++f) {
      height += path.ball_at(f).y();  // on which it comes to stand
    }
    sum += height / (stance.flat_last - stance.flat_first + 1) - path.sole_depth;
  }
  return sum / static_cast<double>(own.size());
}

/// The clip moved up or down until its feet, on the average, stand on the floor.
Clip grounded(const Clip& clip, const std::vector<FootPlant>& plants,
              const FootLockOptions& options) {
  const auto left = hang(clip, plants, true, options);
  const auto right = hang(clip, plants, false, options);
  if (!left && !right) return clip;
  const double height = ((left ? *left : *right) + (right ? *right : *left)) / 2.0;
  Clip result = clip;
  for (Pose& pose : result.poses) pose.root_position.y() -= height;
  return result;
}

/// One leg's targets and how far it may stretch, by frame.
struct LegTargets {
  LegJoints joints;
  std::vector<FootPlace> places;
};

LegTargets leg_targets(const Clip& clip, const std::vector<FootPlant>& plants, bool left,
                       const FootLockOptions& options) {
  const FootPath path = foot_path(clip, left);
  const auto added = corrections(path, plants_of(plants, left), clip.frames_per_second, options);
  const Vec3 down(0.0, -hang(clip, plants, left, options).value_or(0.0), 0.0);
  LegTargets targets{leg_joints(left), {}};
  for (size_t f = 0; f < added.size(); ++f) {
    targets.places.push_back({path.ankle[f] + added[f].translation + down,
                              (exp(added[f].turn) * path.rotation[f]).normalized()});
  }
  return targets;
}

/// How far the hip must sink so that the leg reaches its target.
double needed_drop(const TwoBoneLimb& limb, const Vec3& target, double extension) {
  const double length = (limb.middle - limb.root).norm() + (limb.end - limb.middle).norm();
  const double before = (limb.end - limb.root).norm() / length;
  const double longest = length * std::min(0.9995, std::max(extension, before));
  const Vec3 reach = target - limb.root;
  if (reach.norm() <= longest) return 0.0;
  const double across = std::hypot(reach.x(), reach.z());
  if (across >= longest) return 0.0;
  return std::max(0.0, -reach.y() - std::sqrt(longest * longest - across * across));
}

/// A smooth curve that is nowhere below `needed`: the largest need within `half_width` frames, then
/// averaged over as many.
std::vector<double> smooth_envelope(const std::vector<double>& needed, int half_width, bool loops) {
  const int count = static_cast<int>(needed.size());
  const auto at = [&](int f) {
    return static_cast<size_t>(loops ? ((f % count) + count) % count : std::clamp(f, 0, count - 1));
  };
  std::vector<double> widened(needed.size());
  for (int f = 0; f < count; ++f) {
    for (int k = -half_width; k <= half_width; ++k) {
      widened[at(f)] = std::max(widened[at(f)], needed[at(f + k)]);
    }
  }
  std::vector<double> smooth(needed.size());
  for (int f = 0; f < count; ++f) {
    double sum = 0.0;
    double weight = 0.0;
    for (int k = -half_width; k <= half_width; ++k) {
      const double w = 1.0 + std::cos(pi * k / (half_width + 1));
      sum += w * widened[at(f + k)];
      weight += w;
    }
    smooth[at(f)] = sum / weight;
  }
  return smooth;
}

TwoBoneLimb limb_of(const JointTransforms& world, const LegJoints& leg) {
  return {world.positions[static_cast<size_t>(leg.hip)],
          world.positions[static_cast<size_t>(leg.knee)],
          world.positions[static_cast<size_t>(leg.ankle)]};
}

void place_leg(Pose& pose, const JointTransforms& world, const LegJoints& leg,
               const FootPlace& place, double drop) {
  TwoBoneLimb limb = limb_of(world, leg);
  const Vec3 down(0.0, -drop, 0.0);
  limb = {limb.root + down, limb.middle + down, limb.end + down};
  const Vec3 forward = world.rotations[static_cast<size_t>(leg.hip)] * Vec3::UnitZ();
  const TwoBoneSolution solution = solve_two_bone(limb, place.ankle, forward);
  const Quat thigh = solution.upper_turn * world.rotations[static_cast<size_t>(leg.hip)];
  const Quat shank = solution.lower_turn * world.rotations[static_cast<size_t>(leg.knee)];
  pose.rotations[static_cast<size_t>(leg.hip)] =
      (world.rotations[Pelvis].conjugate() * thigh).normalized();
  pose.rotations[static_cast<size_t>(leg.knee)] = (thigh.conjugate() * shank).normalized();
  pose.rotations[static_cast<size_t>(leg.ankle)] =
      (shank.conjugate() * place.rotation).normalized();
}

}  // namespace

Clip foot_locked(const Clip& free, const std::vector<FootPlant>& plants,
                 const FootLockOptions& options) {
  const Clip clip = grounded(free, plants, options);
  const std::array legs = {leg_targets(clip, plants, true, options),
                           leg_targets(clip, plants, false, options)};
  std::vector<double> needed(clip.poses.size(), 0.0);
  std::vector<JointTransforms> worlds;
  for (size_t f = 0; f < clip.poses.size(); ++f) {
    worlds.push_back(world_transforms(clip.body, clip.poses[f]));
    for (const LegTargets& leg : legs) {
      needed[f] = std::max(needed[f], needed_drop(limb_of(worlds[f], leg.joints),
                                                  leg.places[f].ankle, options.extension));
    }
  }
  const int half_width = static_cast<int>(std::lround(0.125 * clip.frames_per_second));
  const std::vector<double> drop = smooth_envelope(needed, half_width, clip.loops);

  Clip locked = clip;
  for (size_t f = 0; f < clip.poses.size(); ++f) {
    for (const LegTargets& leg : legs) {
      place_leg(locked.poses[f], worlds[f], leg.joints, leg.places[f], drop[f]);
    }
    locked.poses[f].root_position.y() -= drop[f];
  }
  return locked;
}

double planted_drift(const Clip& clip, const std::vector<FootPlant>& plants,
                     const FootLockOptions& options) {
  double largest = 0.0;
  const auto across = [](const Vec3& v) { return std::hypot(v.x(), v.z()); };
  for (const FootPlant& plant : plants) {
    const FootPath path = foot_path(clip, plant.left);
    const Stance stance =
        stance_of(path, plant, options.flat_metres, standing_share * options.lifted_metres);
    for (int f = stance.first; f <= stance.last; ++f) {
      const double drift = f < stance.flat_first
                               ? across(path.heel_at(f) - path.heel_at(stance.flat_first))
                               : across(path.ball_at(f) - path.ball_at(stance.flat_first));
      largest = std::max(largest, drift);
    }
  }
  return largest;
}

}  // namespace mien::motion

#include "motion/gait/foot_placement.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "motion/gait/foot_path.h"
#include "motion/math/filter.h"
#include "motion/math/rotation.h"
#include "motion/skeleton/two_bone_ik.h"

namespace mien::motion {

namespace {

constexpr double straightest = 0.9995;   // of the leg's length, from hip to ankle
constexpr double still_bent = 0.9985;    // as above; the knee is bent by 6°
constexpr double easing_metres = 0.003;  // between the two

/// Correction of the foot in one frame: translation, and rotation vector applied from the left.
struct Correction {
  Vec3 translation = Vec3::Zero();
  Vec3 turn = Vec3::Zero();
};

/// A correction at the end of a stretch.
struct Edge {
  int frame;
  Correction correction;
  Correction outwards;  ///< its change from one frame to the next, away from the stretch

  Correction at(int frames_away) const {
    return {correction.translation + frames_away * outwards.translation,
            correction.turn + frames_away * outwards.turn};
  }
};

Correction operator-(const Correction& a, const Correction& b) {
  return {a.translation - b.translation, a.turn - b.turn};
}

/// Corrections of one foot for every frame: exact in its stretches, fading between them.
std::vector<Correction> corrections(const FootPath& path,
                                    const std::vector<FootTrajectory>& stretches, bool left,
                                    double reach, bool keep_velocity) {
  const int count = path.frame_count();
  std::vector<Correction> result(static_cast<size_t>(count));
  std::vector<bool> placed(static_cast<size_t>(count), false);
  std::vector<Edge> starts, ends;
  for (const FootTrajectory& stretch : stretches) {
    if (stretch.left != left || stretch.places.empty()) continue;
    const int last = stretch.first + static_cast<int>(stretch.places.size()) - 1;
    for (int f = stretch.first; f <= last; ++f) {
      const FootPlace& place = stretch.places[static_cast<size_t>(f - stretch.first)];
      const auto at = static_cast<size_t>(path.wrapped(f));
      result[at] = {place.ankle - path.ankle_at(f),
                    log(place.rotation * path.rotation_at(f).conjugate())};
      placed[at] = true;
    }
    const auto added = [&](int f) { return result[static_cast<size_t>(path.wrapped(f))]; };
    starts.push_back({stretch.first, added(stretch.first), {}});
    ends.push_back({last, added(last), {}});
    if (keep_velocity && last > stretch.first) {
      starts.back().outwards = added(stretch.first) - added(stretch.first + 1);
      ends.back().outwards = added(last) - added(last - 1);
    }
  }
  const auto frames_after = [&](int from, int to) {
    return path.loops ? ((to - from) % count + count) % count : to - from;
  };
  for (int f = 0; f < count; ++f) {
    if (placed[static_cast<size_t>(f)]) continue;
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
      const int away = frames_after(before->frame, f);
      const double share = fade(away / fade_out);
      correction.translation += share * before->at(away).translation;
      correction.turn += share * before->at(away).turn;
    }
    if (after) {
      const int away = frames_after(f, after->frame);
      const double share = fade(away / fade_out);
      correction.translation += share * after->at(away).translation;
      correction.turn += share * after->at(away).turn;
    }
  }
  return result;
}

/// One leg's targets, by frame.
struct LegTargets {
  LegJoints joints;
  std::vector<FootPlace> places;
};

LegTargets leg_targets(const Clip& clip, const std::vector<FootTrajectory>& stretches, bool left,
                       double lowered, const FootLockOptions& options) {
  const FootPath path = foot_path(clip, left);
  const auto added = corrections(
      path, stretches, left, options.blend_seconds * clip.frames_per_second, options.keep_velocity);
  const Vec3 down(0.0, -lowered, 0.0);
  LegTargets targets{leg_joints(left), {}};
  for (size_t f = 0; f < added.size(); ++f) {
    targets.places.push_back({path.ankle[f] + added[f].translation + down,
                              (exp(added[f].turn) * path.rotation[f]).normalized()});
  }
  return targets;
}

/// How far the hip must sink so that the leg reaches its target. Legs may be as straight as they
/// were; one that would have to be straighter ends a little bent, for a knee that gets straight for
/// a moment swings through it abruptly.
double needed_drop(const TwoBoneLimb& limb, const Vec3& target, double extension) {
  const double length = (limb.middle - limb.root).norm() + (limb.end - limb.middle).norm();
  const double before = (limb.end - limb.root).norm() / length;
  const double allowed = length * std::min(straightest, std::max(extension, before));
  const Vec3 reach = target - limb.root;
  const double excess = reach.norm() - allowed;
  if (excess <= 0.0) return 0.0;
  const double bent = std::min(allowed, length * still_bent);
  const double longest = allowed + smooth_step(excess / easing_metres) * (bent - allowed);
  const double across = std::hypot(reach.x(), reach.z());
  if (across >= longest) return 0.0;
  return std::max(0.0, -reach.y() - std::sqrt(longest * longest - across * across));
}

TwoBoneLimb limb_of(const JointTransforms& world, const LegJoints& leg) {
  return {world.positions[static_cast<size_t>(leg.hip)],
          world.positions[static_cast<size_t>(leg.knee)],
          world.positions[static_cast<size_t>(leg.ankle)]};
}

/// How a knee lies off the line from hip to ankle.
struct KneeBend {
  Vec3 off;                   ///< from the line to the knee, metres
  Vec3 front = Vec3::Zero();  ///< unit, across the line: where knees bend to; zero of no leg

  double forward() const { return off.dot(front); }
};

KneeBend knee_bend(const JointTransforms& world, const LegJoints& leg) {
  const TwoBoneLimb limb = limb_of(world, leg);
  const Vec3 line = (limb.end - limb.root).normalized();
  const Vec3 knee = limb.middle - limb.root;
  const Vec3 forward = world.rotations[static_cast<size_t>(leg.hip)] * Vec3::UnitZ();
  const Vec3 across = forward - line.dot(forward) * line;
  const double width = across.norm();
  return {knee - line.dot(knee) * line, width > 1e-9 ? Vec3(across / width) : Vec3(Vec3::Zero())};
}

/// How far forward the bend of a knee has to be moved in each frame, metres, for none to be bent
/// backwards: of one that is, the part that points backwards is turned to the front, and what that
/// takes comes and goes smoothly. Its part to the side stays: a knee that bows sideways must not
/// change sides whenever the little that it bends forward changes its sign.
std::vector<double> knees_forward(const std::vector<JointTransforms>& worlds, const LegJoints& leg,
                                  double frames_per_second, bool loops) {
  std::vector<double> needed;
  for (const JointTransforms& world : worlds) {
    needed.push_back(std::max(0.0, -2.0 * knee_bend(world, leg).forward()));
  }
  const int half_width = std::max(1, static_cast<int>(std::lround(0.1 * frames_per_second)));
  return smooth_envelope(needed, half_width, loops);
}

/// Turns the bend of a knee to the front by that distance; it stays as far off the line from hip to
/// ankle. The turns of the two bones, from the left.
std::pair<Quat, Quat> turn_knee(TwoBoneLimb& limb, const KneeBend& bend, double forward) {
  const Vec3 moved = bend.off + forward * bend.front;
  if (forward <= 0.0 || moved.norm() < 1e-9) return {Quat::Identity(), Quat::Identity()};
  const Vec3 front = limb.middle - bend.off + bend.off.norm() / moved.norm() * moved;
  const std::pair turns = {turn_between(limb.middle - limb.root, front - limb.root),
                           turn_between(limb.end - limb.middle, limb.end - front)};
  limb.middle = front;
  return turns;
}

void place_leg(Pose& pose, const JointTransforms& world, const LegJoints& leg,
               const FootPlace& place, double drop, double knee_forward) {
  TwoBoneLimb limb = limb_of(world, leg);
  const Vec3 down(0.0, -drop, 0.0);
  limb = {limb.root + down, limb.middle + down, limb.end + down};
  const auto [upper, lower] = turn_knee(limb, knee_bend(world, leg), knee_forward);
  const Vec3 forward = world.rotations[static_cast<size_t>(leg.hip)] * Vec3::UnitZ();
  const TwoBoneSolution solution = solve_two_bone(limb, place.ankle, forward);
  const Quat thigh = solution.upper_turn * upper * world.rotations[static_cast<size_t>(leg.hip)];
  const Quat shank = solution.lower_turn * lower * world.rotations[static_cast<size_t>(leg.knee)];
  pose.rotations[static_cast<size_t>(leg.hip)] =
      (world.rotations[Pelvis].conjugate() * thigh).normalized();
  pose.rotations[static_cast<size_t>(leg.knee)] = (thigh.conjugate() * shank).normalized();
  pose.rotations[static_cast<size_t>(leg.ankle)] =
      (shank.conjugate() * place.rotation).normalized();
}

}  // namespace

Clip with_feet_placed(const Clip& clip, const std::vector<FootTrajectory>& stretches,
                      const FootLockOptions& options, const std::array<double, 2>& lowered) {
  const std::array legs = {leg_targets(clip, stretches, true, lowered[0], options),
                           leg_targets(clip, stretches, false, lowered[1], options)};
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
  for (const LegTargets& leg : legs) {
    const std::vector<double> forward =
        knees_forward(worlds, leg.joints, clip.frames_per_second, clip.loops);
    for (size_t f = 0; f < clip.poses.size(); ++f) {
      place_leg(locked.poses[f], worlds[f], leg.joints, leg.places[f], drop[f], forward[f]);
    }
  }
  for (size_t f = 0; f < clip.poses.size(); ++f) {
    locked.poses[f].root_position.y() -= drop[f];
  }
  return locked;
}

}  // namespace mien::motion

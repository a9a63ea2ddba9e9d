#include "motion/modify/foot_repair.h"

#include <algorithm>
#include <cmath>

#include "motion/gait/foot_path.h"
#include "motion/gait/foot_placement.h"
#include "motion/math/filter.h"
#include "motion/math/rotation.h"
#include "motion/modify/hip_shift.h"
#include "motion/skeleton/sole_height.h"
#include "motion/skeleton/two_bone_ik.h"

namespace mien::motion {

namespace {

constexpr double clearance = 0.015;     // metres; a foot that swings higher is clear
constexpr double lift_seconds = 0.05;   // over which the lift of a foot comes and goes
constexpr double onset_seconds = 0.06;  // after and before a plant without full lift
constexpr int most_locks = 6;           // of the original
constexpr double sinks = 0.005;         // metres; a foot that sinks less is on the floor
constexpr double still = 5e-4;          // metres; a foot that drifts less stands

/// How far each frame lies from the foot's nearest plant, frames; 0 within.
std::vector<int> frames_from_plant(const std::vector<FootPlant>& plants, bool left, int count,
                                   bool loops) {
  std::vector<int> away(static_cast<size_t>(count), count);
  for (const FootPlant& plant : plants) {
    if (plant.left != left) continue;
    for (int f = plant.first; f <= plant.last; ++f) {
      away[static_cast<size_t>(loops ? f % count : std::min(f, count - 1))] = 0;
    }
  }
  // Twice round, so that distances also run over a seam.
  const int rounds = loops ? 2 * count : count;
  for (int f = 1; f < rounds; ++f) {
    auto& here = away[static_cast<size_t>(f % count)];
    here = std::min(here, away[static_cast<size_t>((f - 1) % count)] + 1);
  }
  for (int f = rounds - 2; f >= 0; --f) {
    auto& here = away[static_cast<size_t>(f % count)];
    here = std::min(here, away[static_cast<size_t>((f + 1) % count)] + 1);
  }
  return away;
}

std::vector<double> smooth_lift(const std::vector<double>& needed, const Clip& clip) {
  const int half_width =
      std::max(1, static_cast<int>(std::lround(lift_seconds * clip.frames_per_second)));
  return smooth_envelope(needed, half_width, clip.loops);
}

std::vector<double> lifts(const Clip& clip, const Clip& original,
                          const std::vector<FootPlant>& plants, bool left) {
  const std::vector<SolePoints> now = sole_paths(clip, left);
  const std::vector<SolePoints> before = sole_paths(original, left);
  const std::vector<int> away = frames_from_plant(plants, left, clip.frame_count(), clip.loops);
  std::vector<double> needed(now.size(), 0.0);
  for (size_t f = 0; f < now.size(); ++f) {
    if (away[f] == 0) continue;
    const double wanted = std::clamp(lowest_height(before[f]), 0.0, clearance);
    needed[f] = std::max(0.0, wanted - lowest_height(now[f]));
  }
  std::vector<double> lift = smooth_lift(needed, clip);
  for (size_t f = 0; f < lift.size(); ++f) {
    lift[f] *= smooth_step(away[f] / (onset_seconds * clip.frames_per_second + 1.0));
  }
  return lift;
}

/// How far the foot has to be raised where it sinks deeper into the floor than in the original.
std::vector<double> sunk(const Clip& clip, const Clip& original, bool left) {
  const std::vector<SolePoints> now = sole_paths(clip, left);
  const std::vector<SolePoints> before = sole_paths(original, left);
  std::vector<double> needed;
  for (size_t f = 0; f < now.size(); ++f) {
    needed.push_back(
        std::max(0.0, std::min(lowest_height(before[f]), 0.0) - lowest_height(now[f]) - sinks));
  }
  return smooth_lift(needed, clip);
}

/// Raises the ankle of one pose; the foot keeps its direction in the world.
void lift_foot(Pose& pose, const Skeleton& body, const LegJoints& leg, double height) {
  const JointTransforms world = world_transforms(body, pose);
  const auto at = [](BodyJoint joint) { return static_cast<size_t>(joint); };
  const TwoBoneLimb limb = {world.positions[at(leg.hip)], world.positions[at(leg.knee)],
                            world.positions[at(leg.ankle)]};
  const TwoBoneSolution solution = solve_two_bone(limb, limb.end + Vec3(0, height, 0),
                                                  world.rotations[at(leg.hip)] * Vec3::UnitZ());
  const Quat thigh = solution.upper_turn * world.rotations[at(leg.hip)];
  const Quat shank = solution.lower_turn * world.rotations[at(leg.knee)];
  pose.rotations[at(leg.hip)] = (world.rotations[Pelvis].conjugate() * thigh).normalized();
  pose.rotations[at(leg.knee)] = (thigh.conjugate() * shank).normalized();
  pose.rotations[at(leg.ankle)] = (shank.conjugate() * world.rotations[at(leg.ankle)]).normalized();
}

/// The clip with each foot raised by bending its leg. `lift_of(left)` gives the heights by which
/// the left or right foot is raised, metres, one per frame; none leaves the foot as it is.
template <class LiftOf>
Clip with_feet_raised(const Clip& clip, const LiftOf& lift_of) {
  Clip result = clip;
  for (const bool left : {true, false}) {
    const std::vector<double> lift = lift_of(left);
    for (size_t f = 0; f < lift.size(); ++f) {
      if (lift[f] < 1e-6) continue;
      lift_foot(result.poses[f], clip.body, leg_joints(left), lift[f]);
    }
  }
  return result;
}

/// The plant's feet as they stand in `known`, moved over the floor and turned about the vertical to
/// where they are in `path` on the average.
FootTrajectory carried_over(const FootPath& path, const FootPath& known, const FootPlant& plant) {
  const FootLockOptions lock;
  const Stance stance = stance_of(known, plant, lock.flat_metres, lock.lifted_metres);
  Vec3 from = Vec3::Zero();
  Vec3 to = Vec3::Zero();
  double yaw = 0.0;
  for (int f = stance.flat_first; f <= stance.flat_last; ++f) {
    from += known.ball_at(f);
    to += path.ball_at(f);
    const Quat turn = path.rotation_at(f) * known.rotation_at(f).conjugate();
    yaw += log(twist_about(turn, Vec3::UnitY())).y();
  }
  const double frames = stance.flat_last - stance.flat_first + 1;
  from /= frames;
  to /= frames;
  to.y() = from.y();
  const Quat turn = exp(Vec3(0.0, yaw / frames, 0.0));
  // All of the plant, not the stance alone: a foot that has left the floor is to be as high again.
  FootTrajectory stretch{plant.left, plant.first, {}};
  for (int f = plant.first; f <= plant.last; ++f) {
    stretch.places.push_back({to + turn * (known.ankle_at(f) - from), turn * known.rotation_at(f)});
  }
  return stretch;
}

/// Toes bend as they do in `settled` while their foot stands there: a foot that rolls off over
/// toes which bend otherwise goes through the floor with them. Around the plants that fades.
void carry_toes_over(Clip& clip, const Clip& settled, const std::vector<FootPlant>& plants,
                     double fade_seconds) {
  for (const bool left : {true, false}) {
    const auto toe = static_cast<size_t>(leg_joints(left).toe);
    const std::vector<int> away = frames_from_plant(plants, left, clip.frame_count(), clip.loops);
    for (size_t f = 0; f < clip.poses.size(); ++f) {
      const double x = std::min(1.0, away[f] / (fade_seconds * clip.frames_per_second + 1.0));
      if (x == 1.0) continue;
      Quat& bend = clip.poses[f].rotations[toe];
      bend = slerp(bend, settled.poses[f].rotations[toe], 1.0 - smooth_step(x));
    }
  }
}

Clip with_plants_of(const Clip& clip, const Clip& settled, const std::vector<FootPlant>& plants) {
  std::vector<FootTrajectory> stretches;
  for (const bool left : {true, false}) {
    const FootPath path = foot_path(clip, left);
    const FootPath known = foot_path(settled, left);
    for (const FootPlant& plant : plants) {
      if (plant.left == left) stretches.push_back(carried_over(path, known, plant));
    }
  }
  FootLockOptions options;
  options.keep_velocity = true;
  Clip placed = with_feet_placed(clip, stretches, options);
  carry_toes_over(placed, settled, plants, options.blend_seconds);
  return placed;
}

}  // namespace

Clip with_still_feet(const Clip& original, const std::vector<FootPlant>& plants) {
  Clip best = foot_locked(original, plants);
  double least = planted_drift(best, plants);
  Clip settled = best;
  for (int locks = 1; locks < most_locks && least >= still; ++locks) {
    settled = foot_locked(settled, plants);
    const double drift = planted_drift(settled, plants);
    if (drift >= least) continue;
    least = drift;
    best = settled;
  }
  return best;
}

Clip with_feet_above_floor(const Clip& clip, const Clip& original) {
  return with_feet_raised(clip, [&](bool left) { return sunk(clip, original, left); });
}

Clip with_toe_clearance(const Clip& clip, const Clip& original,
                        const std::vector<FootPlant>& plants) {
  return with_feet_raised(clip, [&](bool left) { return lifts(clip, original, plants, left); });
}

Clip with_plants_carried_over(const Clip& clip, const Clip& still,
                              const std::vector<FootPlant>& plants) {
  const Clip shifted = with_hip_shift(clip, still, plants, HipPath::smooth);
  return with_toe_clearance(with_plants_of(shifted, still, plants), still, plants);
}

Clip with_repaired_feet(const Clip& clip, const Clip& original,
                        const std::vector<FootPlant>& plants, FootRepair repair) {
  switch (repair) {
    case FootRepair::none:
      return clip;
    case FootRepair::hip_shift:
      return with_hip_shift(clip, original, plants, HipPath::exact);
    case FootRepair::plants:
      break;
  }
  if (plants.empty()) return clip;
  const Clip still_feet = with_feet_above_floor(with_still_feet(original, plants), original);
  return with_toe_clearance(
      with_plants_of(with_hip_shift_beyond(original, clip, still_feet, plants), still_feet, plants),
      still_feet, plants);
}

}  // namespace mien::motion

#include "motion/modify/nine_grid.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "motion/modify/hip_shift.h"
#include "motion/modify/hit_timing.h"
#include "motion/modify/limb_timing.h"
#include "motion/modify/path_length.h"
#include "motion/skeleton/joint_curve.h"

namespace mien::motion {

namespace {

/// The motion with other path lengths, and the root carried along by the feet.
Clip with_paths(const Clip& original, const std::vector<FootPlant>& plants, const PathGains& gains,
                const Modification& modification) {
  const Clip filtered = with_path_gains(original, gains, modification.signal, modification.hands);
  if (modification.repair == FootRepair::none) return filtered;
  const bool smooth = modification.repair == FootRepair::plants;
  return with_hip_shift(filtered, original, plants, smooth ? HipPath::smooth : HipPath::exact);
}

std::vector<HandHit> hits_of(Limb hand, std::vector<HandHit> hits) {
  std::erase_if(hits, [&](const HandHit& hit) { return hit.left != (hand == Limb::left_hand); });
  return hits;
}

/// Full acceleration of hands that hit something, at their hits.
Clip with_acceleration_at_hits(const Clip& clip, const std::vector<HandHit>& hits,
                               const Limbs& limbs) {
  Clip result = clip;
  for (const Limb hand : {Limb::left_hand, Limb::right_hand}) {
    const std::vector<HandHit> own = hits_of(hand, hits);
    if (own.empty() || !has(limbs, hand)) continue;
    retime(result, hand,
           hard_hit_sources(own, clip.frame_count(), clip.frames_per_second, clip.loops));
  }
  return result;
}

/// Full acceleration of hands that hit something at their hits, of other limbs where feet land.
Clip with_acceleration_at_contacts(const Clip& clip, const std::vector<FootPlant>& plants,
                                   const std::vector<HandHit>& hits, const Limbs& limbs) {
  Limbs others = limbs;
  if (!hits_of(Limb::left_hand, hits).empty()) others.left_hand = false;
  if (!hits_of(Limb::right_hand, hits).empty()) others.right_hand = false;
  return with_acceleration_at_hits(
      with_acceleration_near(clip, others, contact_frames(plants, clip.frame_count())), hits,
      limbs);
}

/// The motion with constant speed (`acceleration` < 0) or full acceleration (> 0).
Clip with_timing(const Clip& clip, const std::vector<FootPlant>& plants,
                 const std::vector<HandHit>& hits, double acceleration,
                 const Modification& modification) {
  if (acceleration == 0.0) return clip;
  if (acceleration < 0.0) return with_constant_speed(clip, modification.limbs);
  if (modification.acceleration_place == AccelerationPlace::pauses) {
    return with_acceleration(clip, modification.limbs);
  }
  if (modification.acceleration_place == AccelerationPlace::hits) {
    return with_acceleration_at_hits(clip, hits, modification.limbs);
  }
  return with_acceleration_at_contacts(clip, plants, hits, modification.limbs);
}

struct Weighted {
  std::vector<Clip> clips;
  std::vector<double> weights;

  void add(Clip clip, double weight) {
    clips.push_back(std::move(clip));
    weights.push_back(weight);
  }
};

/// The motions between whose path lengths the modification's lies.
Weighted path_neighbours(const Clip& original, const std::vector<FootPlant>& plants,
                         const Modification& modification) {
  Weighted neighbours;
  if (modification.gains) {
    neighbours.add(with_paths(original, plants, *modification.gains, modification), 1.0);
    return neighbours;
  }
  const double away = modification.paths - 1.0;
  if (std::abs(away) < 1.0) neighbours.add(original, 1.0 - std::abs(away));
  if (away != 0.0) {
    const PathGains gains = away > 0.0 ? longest_path_gains() : shortest_path_gains();
    neighbours.add(with_paths(original, plants, gains, modification), std::abs(away));
  }
  return neighbours;
}

/// Sets the rotations of joints, or of fingers, to the weighted means of those of the poses, which
/// all have the same joints. Where they do not differ, they stay as they are.
void set_mean_rotations(Pose& mean, std::vector<Quat> Pose::*joints,
                        std::span<const Pose* const> poses, std::span<const double> weights,
                        const Pose& previous) {
  for (size_t j = 0; j < (mean.*joints).size(); ++j) {
    const Quat& first = (poses.front()->*joints)[j];
    const bool same = std::all_of(poses.begin() + 1, poses.end(), [&](const Pose* pose) {
      return (pose->*joints)[j].coeffs() == first.coeffs();
    });
    if (same) continue;
    Directions sum = Directions::Zero();
    for (size_t c = 0; c < poses.size(); ++c)
      sum += weights[c] * directions_of((poses[c]->*joints)[j]);
    (mean.*joints)[j] = to_rotation(sum, (previous.*joints)[j]);
  }
}

}  // namespace

Pose mean_pose(std::span<const Pose* const> poses, std::span<const double> weights,
               const Pose& previous) {
  Pose mean = *poses.front();
  mean.root_position = Vec3::Zero();
  for (size_t c = 0; c < poses.size(); ++c) {
    mean.root_position += weights[c] * poses[c]->root_position;
  }
  set_mean_rotations(mean, &Pose::rotations, poses, weights, previous);
  set_mean_rotations(mean, &Pose::fingers, poses, weights, previous);
  return mean;
}

Clip mean_clip(std::span<const Clip> clips, std::span<const double> weights) {
  assert(!clips.empty() && clips.size() == weights.size());
  if (clips.size() == 1) return clips.front();
  Clip mean = clips.front();
  mean.cycle_displacement = Vec3::Zero();
  for (size_t c = 0; c < clips.size(); ++c) {
    mean.cycle_displacement += weights[c] * clips[c].cycle_displacement;
  }
  std::vector<const Pose*> poses(clips.size());
  for (size_t f = 0; f < mean.poses.size(); ++f) {
    for (size_t c = 0; c < clips.size(); ++c) poses[c] = &clips[c].poses[f];
    mean.poses[f] = mean_pose(poses, weights, f > 0 ? mean.poses[f - 1] : *poses.front());
  }
  return mean;
}

Clip grid_motion(const Clip& original, const std::vector<FootPlant>& plants,
                 const Modification& modification, const std::vector<HandHit>& hits) {
  const Weighted paths = path_neighbours(original, plants, modification);
  const double timed = std::abs(modification.acceleration);
  Weighted corners;
  for (size_t p = 0; p < paths.clips.size(); ++p) {
    if (timed < 1.0) corners.add(paths.clips[p], paths.weights[p] * (1.0 - timed));
    if (timed > 0.0) {
      corners.add(
          with_timing(paths.clips[p], plants, hits, modification.acceleration, modification),
          paths.weights[p] * timed);
    }
  }
  return mean_clip(corners.clips, corners.weights);
}

}  // namespace mien::motion

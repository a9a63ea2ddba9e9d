#include "motion/modify/held_hands.h"

#include <algorithm>
#include <cmath>

#include "motion/math/filter.h"
#include "motion/math/rotation.h"
#include "motion/modify/arm_reach.h"
#include "motion/skeleton/pose.h"

namespace mien::motion {

namespace {

constexpr double fading_seconds = 0.2;             // of small corrections
constexpr double more_fading_seconds_per_m = 2.0;  // of larger ones, which would hurry
constexpr double least_correction = 1e-4;          // metres

/// A hit's correction, and over how many frames it fades.
struct Correction {
  int frame;
  Vec3 shift;
  double before;
  double after;
};

/// Frames from one frame of a loop to another one after it.
double frames_between(int from, int to, int count, bool loops) {
  return to > from || !loops ? to - from : to - from + count;
}

std::vector<Correction> corrections(const Clip& clip, const Clip& reference, const Arm& arm,
                                    const std::vector<HandHit>& hits, bool travels) {
  std::vector<Correction> found;
  for (const HandHit& hit : hits) {
    const Pose& pose = clip.poses[static_cast<std::size_t>(hit.frame)];
    const Pose& meant = reference.poses[static_cast<std::size_t>(hit.frame)];
    Vec3 shift = world_transform(reference.body, meant, arm.wrist).position -
                 world_transform(clip.body, pose, arm.wrist).position;
    if (travels) shift -= meant.root_position - pose.root_position;
    const double seconds = fading_seconds + more_fading_seconds_per_m * shift.norm();
    const double frames = seconds * clip.frames_per_second;
    found.push_back({hit.frame, shift, frames, frames});
  }
  const std::size_t count = found.size();
  for (std::size_t i = 0; i < count && count > 1; ++i) {
    const std::size_t next = (i + 1) % count;
    if (next == 0 && !clip.loops) continue;
    const double gap =
        frames_between(found[i].frame, found[next].frame, clip.frame_count(), clip.loops);
    found[i].after = std::min(found[i].after, gap);
    found[next].before = std::min(found[next].before, gap);
  }
  return found;
}

Vec3 shift_at(const std::vector<Correction>& corrections, int frame, int count, bool loops) {
  Vec3 shift = Vec3::Zero();
  for (const Correction& each : corrections) {
    double away = frame - each.frame;
    if (loops && away > 0.5 * count) away -= count;
    if (loops && away < -0.5 * count) away += count;
    shift += fade(std::abs(away) / (away < 0.0 ? each.before : each.after)) * each.shift;
  }
  return shift;
}

}  // namespace

HeldHands with_held_hands(const Clip& clip, const Clip& reference, const std::vector<HandHit>& hits,
                          bool travels) {
  HeldHands result{clip, 0.0};
  for (const bool left : {true, false}) {
    const Arm arm = arm_of(left);
    std::vector<HandHit> own = hits;
    std::erase_if(own, [&](const HandHit& hit) { return hit.left != left; });
    const std::vector<Correction> made = corrections(clip, reference, arm, own, travels);
    for (const Correction& each : made)
      result.largest_correction = std::max(result.largest_correction, each.shift.norm());
    for (int f = 0; f < clip.frame_count(); ++f) {
      const Vec3 shift = shift_at(made, f, clip.frame_count(), clip.loops);
      if (shift.norm() < least_correction) continue;
      Pose& pose = result.clip.poses[static_cast<std::size_t>(f)];
      pose = with_wrist_moved(clip.body, pose, left, shift);
    }
  }
  return result;
}

}  // namespace mien::motion

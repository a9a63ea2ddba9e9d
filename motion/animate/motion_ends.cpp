#include "motion/animate/motion_ends.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "motion/error.h"
#include "motion/gait/loop.h"
#include "motion/skeleton/body.h"

namespace mien::motion {

namespace {

constexpr int fewest_frames_of_a_loop = 4;

int frames_of(double seconds, double frames_per_second) {
  if (seconds <= 0.0) return 0;
  return std::max(1, static_cast<int>(std::lround(seconds * frames_per_second)));
}

/// The largest angle of a joint between two poses, degrees; the direction of the body counts.
double largest_turn_deg(const Pose& from, const Pose& to) {
  double largest = 0.0;
  for (const auto joints : {&Pose::rotations, &Pose::fingers})
    for (std::size_t j = 0; j < (from.*joints).size(); ++j)
      largest = std::max(largest, (from.*joints)[j].angularDistance((to.*joints)[j]));
  return largest * 180.0 / std::numbers::pi;
}

AnimatedClip looping(const Clip& clip) {
  if (clip.loops) return {clip, {}, {"it loops already"}};
  const int last = clip.frame_count() - 1;
  if (last + 1 < fewest_frames_of_a_loop)
    throw Error("a motion of " + std::to_string(last + 1) + " frames is too short for a loop",
                "give it " + std::to_string(fewest_frames_of_a_loop) + " frames or more");
  const long degrees = std::lround(largest_turn_deg(clip.poses.front(), clip.poses.back()));
  return {closed_loop(clip, 0, last),
          {},
          {"its last and first pose, which differed by " + std::to_string(degrees) +
           "° in the joint that differed most, were made the same"}};
}

}  // namespace

int frames_before(const MotionEnds& ends, double frames_per_second) {
  return frames_of(ends.hold_before, frames_per_second);
}

AnimatedClip with_ends(const Clip& clip, const MotionEnds& ends) {
  if (ends.is_empty()) return {clip, {}, {}};
  if (!is_body(clip.body))
    throw Error("the ends of a motion can be changed only on the canonical body",
                "map the motion to it first");
  if (ends.loops) return looping(clip);
  if (clip.loops)
    throw Error("the first and last pose of a motion that loops cannot be held",
                "omit ends, or give a motion that does not loop");
  AnimatedClip held{clip, {}, {}};
  std::vector<Pose>& poses = held.clip.poses;
  const auto before = static_cast<std::size_t>(frames_before(ends, clip.frames_per_second));
  const auto after = static_cast<std::size_t>(frames_of(ends.hold_after, clip.frames_per_second));
  poses.insert(poses.begin(), before, clip.poses.front());
  poses.insert(poses.end(), after, clip.poses.back());
  return held;
}

}  // namespace mien::motion

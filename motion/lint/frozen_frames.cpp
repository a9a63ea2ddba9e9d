#include <algorithm>
#include <array>

#include "motion/lint/checks.h"
#include "motion/lint/threshold_findings.h"
#include "motion/math/rotation.h"

namespace mien::motion {

namespace {

/// A stretch of frames in which nothing moves.
struct FrozenFrames {
  int first;
  int last;
};

double seconds_of(const FrozenFrames& frames, const LintMotion& motion) {
  return (frames.last - frames.first) / motion.rate();
}

/// None of a motion that moves nowhere else for as long as frozen stretches last.
std::vector<FrozenFrames> frozen_frames(const LintMotion& motion) {
  std::vector<FrozenFrames> found;
  const int steps = motion.frame_count() - 1;
  for (int first = 0; first < steps; ++first) {
    if (!is_frozen(motion, first)) continue;
    int last = first + 1;
    while (last < steps && is_frozen(motion, last)) ++last;
    found.push_back({first, last});
    first = last;
  }
  int frozen_steps = 0;
  for (const FrozenFrames& frames : found) frozen_steps += frames.last - frames.first;
  const bool moves = (steps - frozen_steps) / motion.rate() >= take_limits.frozen_seconds.warning;
  return moves ? found : std::vector<FrozenFrames>();
}

double longest_frozen(const LintMotion& motion) {
  double longest = 0.0;
  for (const FrozenFrames& frames : frozen_frames(motion)) {
    longest = std::max(longest, seconds_of(frames, motion));
  }
  return longest;
}

}  // namespace

namespace {

bool turns(const std::vector<Quat>& from, const std::vector<Quat>& to, double rate) {
  for (size_t j = 0; j < to.size(); ++j) {
    const Vec3 turn = log(from[j].conjugate() * to[j]);
    if (rate * turn.norm() > take_limits.frozen_rad_s) return true;
  }
  return false;
}

}  // namespace

bool is_frozen(const LintMotion& motion, int step) {
  const Pose& from = motion.clip.poses[step];
  const Pose& to = motion.clip.poses[step + 1];
  const double rate = motion.rate();
  const Vec3 way = rate * (to.root_position - from.root_position) + motion.floor;
  if (way.norm() > take_limits.frozen_m_s * motion.scale) return false;
  return !turns(from.rotations, to.rotations, rate) && !turns(from.fingers, to.fingers, rate);
}

Findings find_frozen(const LintMotion& motion, const LintMotion* original) {
  Findings findings;
  Levels levels = take_limits.frozen_seconds;
  if (original) {
    const double by_original = longest_frozen(*original) / pace(*original, motion);
    levels = raised_levels(levels, std::array{by_original});
  }
  for (const FrozenFrames& frames : frozen_frames(motion)) {
    const double seconds = seconds_of(frames, motion);
    if (!(seconds > levels.warning)) continue;
    Finding finding = graded_finding("frozen", seconds, "s", levels);
    finding.first = frames.first;
    finding.last = frames.last;
    finding.sentence = "Nothing moves for " + rounded(seconds, 2) + " s: the recording is frozen.";
    add_finding(findings, motion, std::move(finding));
  }
  return findings;
}

}  // namespace mien::motion

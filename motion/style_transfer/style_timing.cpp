#include "motion/style_transfer/style_timing.h"

#include <algorithm>
#include <cmath>

#include "motion/interpolation/time_warp.h"

namespace mien::motion {

namespace {

constexpr double least_interval = 0.25;  // of an interval before

std::vector<double> shares_of(const Example& motion) {
  std::vector<double> shares;
  for (const double keytime : motion.keytimes) shares.push_back(keytime / motion.keytimes.back());
  return shares;
}

}  // namespace

std::vector<double> styled_keytimes(const Example& motion, const Example& neutral,
                                    const Example& styled, double amount, double duration) {
  const std::vector<double> own = shares_of(motion);
  const std::vector<double> from = shares_of(neutral);
  const std::vector<double> to = shares_of(styled);
  std::vector<double> intervals;
  double sum = 0.0;
  for (size_t k = 1; k < own.size(); ++k) {
    const double before = own[k] - own[k - 1];
    const double change = own.size() == from.size() && own.size() == to.size()
                              ? (to[k] - to[k - 1]) - (from[k] - from[k - 1])
                              : 0.0;
    intervals.push_back(std::max(before + amount * change, least_interval * before));
    sum += intervals.back();
  }
  std::vector<double> keytimes = {0.0};
  for (const double interval : intervals) {
    keytimes.push_back(keytimes.back() + interval / sum * duration);
  }
  keytimes.back() = duration;
  return keytimes;
}

std::vector<double> corresponding_frames(const Example& motion, const std::vector<double>& keytimes,
                                         int frames) {
  const TimeWarp warp =
      make_time_warp(keytimes, motion.keytimes, WarpShape::monotone, motion.clip.loops);
  const double intervals = motion.clip.loops ? frames : std::max(1, frames - 1);
  std::vector<double> source;
  for (int f = 0; f < frames; ++f) {
    source.push_back(warped(warp, f * keytimes.back() / intervals) * motion.clip.frames_per_second);
  }
  return source;
}

}  // namespace mien::motion

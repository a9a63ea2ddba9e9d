#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "motion/modify/limb_timing.h"

namespace mien::motion {

/// Stretches the pauses of limbs (acceleration above 0) or makes their speed more constant (below
/// 0), frame by frame with a delay of `look_ahead` frames.
///
/// Offline, a limb's pauses are stretched within segments of 0.9 s and the rest of each segment is
/// accelerated, so that the limb alternately leads and lags the trunk. A stream cannot show future
/// frames, so each limb here plays the received frames at its own rate, 0 to `look_ahead` frames +
/// `longest_lag_seconds` behind the newest. It falls behind in its pauses and catches up after
/// them. A pause is detected by comparing the speed of the limb's end relative to the pelvis,
/// measured over 0.1 s, with its mean over the last 0.9 s (1.5 s for constant speed). Pauses are
/// stretched by up to `max_pause_factor`; for constant speed, durations follow
/// `constant_speed_durations`. A limb whose speed does not vary is unchanged.
class TimingStream {
 public:
  static constexpr double longest_lag_seconds = 0.25;

  TimingStream(const Modification& modification, const Skeleton& body, double frames_per_second,
               int look_ahead);

  /// Takes the next frame. Once `look_ahead` frames have passed, returns the retimed frame from
  /// `look_ahead` frames before it.
  std::optional<Pose> push(const Pose& pose);

  /// Returns the remaining frames. Nothing may be pushed afterwards.
  std::vector<Pose> finish();

  /// Of the lags of all limbs behind the trunk so far, the one with the largest magnitude, frames;
  /// negative if the limb was ahead.
  double largest_lag() const { return largest_lag_; }

 private:
  struct Player {
    Limb limb;
    std::deque<Vec3> places;  ///< of the limb's end relative to the root, one per pose in `poses_`
    double source = 0.0;      ///< (fractional) input frame that is shown
    double rate = 1.0;        ///< input frames per output frame, smoothed
    double mean_duration = 1.0;  ///< over the last segment
    double mean_speed = -1.0;    ///< over the last segment, m/s; below 0 before the first
    double top_speed = 0.0;      ///< over the last segment, m/s
  };

  Pose next();
  void play_on(Player& player) const;
  double target_duration(Player& player) const;
  Pose shown_at(const Player& player, const Pose& now) const;
  void drop_past_frames();

  Skeleton body_;
  double acceleration_;
  double frames_per_second_;
  int look_ahead_;
  std::vector<Player> players_;
  std::deque<Pose> poses_;  ///< from `first_` to the newest
  long first_ = 0;
  long given_ = 0;
  double largest_lag_ = 0.0;
  std::optional<Pose> before_;
};

}  // namespace mien::motion

#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "motion/modify/limb_timing.h"

namespace mien::motion {

/// Stretches the pauses of limbs (acceleration above 0) or evens their speed (below 0), frame by
/// frame and `look_ahead` frames late.
///
/// Offline, a limb's pauses are stretched within segments of 0.9 s and the rest is accelerated, so
/// that the limb alternately leads and lags the trunk. A stream cannot show future frames: here a
/// limb plays past frames at its own speed, behind the newest frame by 0 to `look_ahead` +
/// `longest_lag_seconds`. It falls behind in its pauses and catches up after them. Speed of a
/// limb's end relative to the hips, over 0.1 s, against its mean over the last 0.9 s (1.5 s for
/// constant speed) says what a pause is; how long it lasts is `max_pause_factor` or
/// `constant_speed_durations`. Without any change of speed the motion is unchanged.
class TimingStream {
 public:
  static constexpr double longest_lag_seconds = 0.25;

  TimingStream(const Modification& modification, const Skeleton& body, double frames_per_second,
               int look_ahead);

  /// Takes the next frame and gives, once `look_ahead` have passed, the frame that many before it.
  std::optional<Pose> push(const Pose& pose);

  /// The frames that have not been given yet. Nothing may be pushed after it.
  std::vector<Pose> finish();

  /// Largest lag of a limb behind the trunk, frames; negative if it was ahead.
  double largest_lag() const { return largest_lag_; }

 private:
  struct Player {
    Limb limb;
    std::deque<Vec3> places;     ///< of the limb's end, seen from the hips; as `poses_`
    double source = 0.0;         ///< frame that is shown
    double rate = 1.0;           ///< frames of the motion a frame, smooth
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

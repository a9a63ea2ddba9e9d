#pragma once

#include <array>
#include <deque>
#include <optional>
#include <vector>

#include "motion/modify/joint_curve.h"
#include "motion/modify/path_length.h"

namespace mien::motion {

/// Change of path lengths: a mix of the motion with these gains and the unchanged motion
/// (nine_grid.h).
struct PathMix {
  PathGains gains;
  double share = 0.0;  ///< 0–1
  bool legs = true;    ///< else pelvis and legs stay as they are, and the feet where they stand
};

PathMix path_mix(const Modification& modification);

/// Look-ahead of the band filter, frames, at which a stream's paths equal those of the whole
/// motion.
int path_reach(const PathGains& gains, double frames_per_second);

/// Changes the lengths of motion paths as `with_path_gains` does (by direction vectors), a frame at
/// a time and `look_ahead` frames late: the weighting of bands is one symmetrical filter, and what
/// lies beyond the newest frame counts as a repetition of it, just as offline beyond the last. With
/// `path_reach` frames of look-ahead the result is the offline one to rounding.
class PathStream {
 public:
  PathStream(const PathMix& mix, double frames_per_second, int look_ahead);

  /// Takes the next frame and returns, from frame `look_ahead` on, the frame that many before it.
  std::optional<Pose> push(const Pose& pose);

  /// The remaining frames. Nothing may be pushed afterwards.
  std::vector<Pose> finish();

 private:
  /// The newest directions of one joint, and its signal between frames too.
  struct Signal {
    std::deque<Directions> newest;  ///< up to four frames
    std::deque<Directions> dense;   ///< `factor` samples a frame, from `first_dense_`
  };

  void extend(Signal& signal, const Quat& rotation) const;
  Directions filtered(const Signal& signal) const;
  Pose next();
  void drop_past_frames();

  BandWeights weights_;
  double share_;
  bool legs_;
  int look_ahead_;
  std::vector<double> response_;  ///< impulse response of the bands, centred
  std::array<Signal, body_joint_count> signals_;
  std::deque<Pose> waiting_;  ///< from the frame that is given next to the newest
  long first_dense_ = 0;      ///< place in the signal of the first sample that is kept
  long given_ = 0;            ///< frames given so far
  std::optional<Pose> longer_before_;
  std::optional<Pose> before_;  ///< the frame that was given last
};

}  // namespace mien::motion

#pragma once

#include <array>
#include <deque>
#include <optional>
#include <vector>

#include "motion/modify/path_length.h"
#include "motion/skeleton/joint_curve.h"

namespace mien::motion {

/// Change of path lengths: a blend of the unchanged motion and the motion filtered with `gains`
/// (nine_grid.h).
struct PathMix {
  PathGains gains;
  double share = 0.0;  ///< of the filtered motion, 0–1
  bool legs = true;    ///< false: pelvis and legs are unchanged, so that the feet do not move
};

PathMix path_mix(const Modification& modification);

/// Look-ahead of the band filter, frames, with which streamed path lengths equal the offline
/// result.
int path_reach(const PathGains& gains, double frames_per_second);

/// Changes the lengths of motion paths as `with_path_gains` does (by direction vectors), frame by
/// frame with a delay of `look_ahead` frames. The band gains form one symmetric filter; beyond the
/// newest frame the signal is extended by repeating that frame, as the offline version does after
/// the last. With a look-ahead of `path_reach` frames the result equals the offline one up to
/// rounding.
class PathStream {
 public:
  PathStream(const PathMix& mix, double frames_per_second, int look_ahead);

  /// Takes the next frame. Once `look_ahead` frames have passed, returns the modified frame from
  /// `look_ahead` frames before it.
  std::optional<Pose> push(const Pose& pose);

  /// Returns the remaining frames. Nothing may be pushed afterwards.
  std::vector<Pose> finish();

 private:
  /// The newest direction vectors of one joint, and its oversampled signal.
  struct Signal {
    std::deque<Directions> newest;  ///< up to four frames
    std::deque<Directions> dense;   ///< `factor` samples per frame, from `first_dense_` on
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
  std::deque<Pose> waiting_;           ///< the frame that is returned next, and all later ones
  long first_dense_ = 0;               ///< index in the signal of the first sample that is kept
  long given_ = 0;                     ///< number of frames returned so far
  std::optional<Pose> longer_before_;  ///< the last filtered frame, before mixing
  std::optional<Pose> before_;         ///< the last mixed frame
};

}  // namespace mien::motion

#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "motion/biomechanics/soft_limits.h"
#include "motion/modify/modification.h"
#include "motion/stream/path_stream.h"
#include "motion/stream/timing_stream.h"

namespace mien::motion {

/// Applies a posture change as `with_posture` does, frame by frame with a delay of `look_ahead`
/// frames. The limbs' strengths are smoothed over the frames received so far, as if the motion
/// ended with the newest; without look-ahead they are not smoothed. Trunk and head need no
/// look-ahead.
class PostureStream {
 public:
  PostureStream(const Modification& modification, const Skeleton& body, double frames_per_second,
                int look_ahead);

  /// Takes the next frame. Once `look_ahead` frames have passed, returns the modified frame from
  /// `look_ahead` frames before it.
  std::optional<Pose> push(Pose pose);

  /// Returns the remaining frames. Nothing may be pushed afterwards.
  std::vector<Pose> finish();

 private:
  Pose next();

  std::vector<PostureChange> changes_;
  std::optional<PoseDifference> difference_;
  LimbFade fade_;
  double frames_per_second_;
  int look_ahead_;
  std::deque<Pose> waiting_;             ///< from the next frame to be returned to the newest
  std::deque<LimbStrengths> strengths_;  ///< those of `waiting_` and of some earlier frames
};

/// The joints whose path lengths change.
enum class PathScope {
  body,
  upper_body,  ///< all except pelvis and legs, so that feet do not slide more than in the input
};

/// Look-ahead of each part of a modification, frames; their sum delays the motion. Posture and
/// acceleration also work without look-ahead.
struct StreamDelay {
  int paths = 0;    ///< useful up to `path_reach`
  int timing = 0;   ///< for acceleration: the largest lead of a limb over the trunk
  int posture = 0;  ///< useful for swinging limbs; see PostureStream

  int frames() const { return paths + timing + posture; }
};

/// Throws mien::Error for a modification that cannot be streamed with a bounded delay: a change of
/// tempo (the delay would grow indefinitely, or future frames would be needed), variation (its
/// splines span the whole motion), RotationSignal::quaternions (needs the mean rotation over the
/// whole motion), acceleration near contacts only (contacts are detected on the whole motion). Also
/// throws as `check` for numbers out of range, and for more than 12 bands, because of the memory
/// that these need.
void check_streamable(const Modification& modification);

/// Modifies a motion of the canonical body in real time: each input frame yields at most one output
/// frame, with a delay of `delay.frames()` and bounded memory. An output frame depends only on
/// input frames up to `delay.frames()` later.
///
/// Applies path lengths, acceleration and posture as in `modify`, in this order, then soft joint
/// limits (relative to the joint ranges observed so far). With sufficient look-ahead, path lengths
/// and posture equal the offline result; acceleration uses a different method (TimingStream).
/// FootRepair is ignored: the root follows the input motion.
class StreamedModification {
 public:
  /// Throws as `check_streamable`, and for a skeleton other than the canonical body.
  StreamedModification(const Skeleton& body, double frames_per_second,
                       const Modification& modification, const StreamDelay& delay,
                       PathScope scope = PathScope::body);

  /// Allows the joint ranges of a known motion of the same subject, in addition to those observed.
  void expect(const Clip& known);

  /// Takes the next frame; returns none until the delay has passed, then one each time.
  std::optional<Pose> push(const Pose& pose);

  /// Returns the remaining frames. Nothing may be pushed afterwards.
  std::vector<Pose> finish();

  const StreamDelay& delay() const { return delay_; }

  /// `TimingStream::largest_lag`; 0 without acceleration.
  double largest_lag() const { return timing_ ? timing_->largest_lag() : 0.0; }

 private:
  std::optional<Pose> through_timing(std::optional<Pose> pose);
  std::optional<Pose> through_posture(std::optional<Pose> pose);
  Pose limited(Pose pose) const;

  bool limits_ = false;
  TurnExtremes extremes_;
  StreamDelay delay_;  ///< of the active parts only
  std::optional<PathStream> paths_;
  std::optional<TimingStream> timing_;
  std::optional<PostureStream> posture_;
};

/// Streams a whole clip, which must not loop, and returns the result.
Clip streamed(const Clip& clip, const Modification& modification, const StreamDelay& delay,
              PathScope scope = PathScope::body);

}  // namespace mien::motion

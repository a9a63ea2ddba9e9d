#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "motion/modify/modification.h"
#include "motion/modify/soft_limits.h"
#include "motion/stream/path_stream.h"
#include "motion/stream/timing_stream.h"

namespace mien::motion {

/// Applies a posture change as `with_posture` does, frame by frame and `look_ahead` frames late.
/// The strengths of the limbs are smoothed over the frames so far, as if the motion ended there:
/// without look-ahead they are those of the present pose. Trunk and head need no look-ahead.
class PostureStream {
 public:
  PostureStream(const Modification& modification, const Skeleton& body, double frames_per_second,
                int look_ahead);

  /// Takes the next frame and gives, once `look_ahead` have passed, the frame that many before it.
  std::optional<Pose> push(Pose pose);

  /// The frames that have not been given yet. Nothing may be pushed after it.
  std::vector<Pose> finish();

 private:
  Pose next();

  std::vector<PostureChange> changes_;
  std::optional<PoseDifference> difference_;
  LimbFade fade_;
  double frames_per_second_;
  int look_ahead_;
  std::deque<Pose> waiting_;             ///< from the frame that is given next to the newest
  std::deque<LimbStrengths> strengths_;  ///< those of `waiting_`, and of some before
};

/// The joints whose path lengths change.
enum class PathScope {
  body,
  upper_body,  ///< all but pelvis and legs, so that feet slide no more than before
};

/// Look-ahead of each part of a modification in frames, which delays the motion. Posture and
/// acceleration work without.
struct StreamDelay {
  int paths = 0;    ///< of no use beyond `path_reach`
  int timing = 0;   ///< of acceleration: the limb may be before the trunk by as many
  int posture = 0;  ///< of use to limbs that swing; see PostureStream

  int frames() const { return paths + timing + posture; }
};

/// Throws mien::Error for a modification that no bounded delay allows: another tempo (the delay
/// would grow for ever, or what is to be shown would not have come yet), variation (its splines run
/// over the whole motion), filtering of logarithms (about the mean rotation of the whole motion),
/// acceleration near contacts only (they are found on the whole motion); and, as `check`, for
/// numbers out of range. More than 12 bands are refused for their memory.
void check_streamable(const Modification& modification);

/// A motion of the canonical body that is modified while it comes: a frame in, at most one frame
/// out, `delay.frames()` later, with memory that does not grow. What is given depends on nothing
/// that comes later than the delay.
///
/// Path lengths, acceleration and posture as of `modify`, in this order, then soft joint limits
/// (against how far the joints of the motion have gone until now). Path lengths and posture are the
/// offline ones when the look-ahead is long enough, acceleration is one of its own (TimingStream).
/// Feet are not repaired, whatever the modification says: the root goes as in the motion that
/// comes.
class StreamedModification {
 public:
  /// Throws as `check_streamable`, and for a skeleton that is not the canonical body.
  StreamedModification(const Skeleton& body, double frames_per_second,
                       const Modification& modification, const StreamDelay& delay,
                       PathScope scope = PathScope::body);

  /// A known motion of the same performer, whose joint ranges are allowed.
  void expect(const Clip& known);

  /// Takes the next frame; returns none until the delay has passed, then one each time.
  std::optional<Pose> push(const Pose& pose);

  /// The frames that have not been given yet. Nothing may be pushed after it.
  std::vector<Pose> finish();

  const StreamDelay& delay() const { return delay_; }

  /// Largest lag of a limb behind the trunk by acceleration, frames.
  double largest_lag() const { return timing_ ? timing_->largest_lag() : 0.0; }

 private:
  std::optional<Pose> through_timing(std::optional<Pose> pose);
  std::optional<Pose> through_posture(std::optional<Pose> pose);
  Pose limited(Pose pose) const;

  bool limits_ = false;
  TurnExtremes extremes_;
  StreamDelay delay_;  ///< of the parts that there are
  std::optional<PathStream> paths_;
  std::optional<TimingStream> timing_;
  std::optional<PostureStream> posture_;
};

/// The result of streaming a whole clip, which does not loop.
Clip streamed(const Clip& clip, const Modification& modification, const StreamDelay& delay,
              PathScope scope = PathScope::body);

}  // namespace mien::motion

#pragma once

#include "motion/skeleton/clip.h"
#include "motion/stream/streamed_modification.h"

namespace mien::motion {

/// Distance of the joints of one motion from those of another.
struct StreamError {
  double largest_metres = 0.0;
  double rms_metres = 0.0;
  BodyJoint joint = Pelvis;  ///< where the largest is
  int frame = 0;
};

/// Error of a streamed clip; both have the same frames and the canonical body.
StreamError stream_error(const Clip& streamed, const Clip& offline);

/// Tolerance of a joint's distance from the offline result, metres.
inline constexpr double largest_stream_error = 0.01;

/// The modification without foot repair and without anything that `check_streamable` refuses: the
/// offline reference of a stream.
Modification without_repair(Modification modification);

/// The shortest look-ahead of path lengths, frames, with which no joint is farther than
/// `largest_error` from where the modification of the whole motion has it; 0 when path lengths
/// stay. Found by trying on the built-in motions ("actors" and "walks-10", loops walked four times)
/// with some margin, for captures err more. Takes about a second, and depends on nothing else.
///
/// Soft joint limits are excluded: no look-ahead predicts the range of a motion's joints, so they
/// deviate until the motion has covered it.
int shortest_look_ahead(const Modification& modification, double frames_per_second,
                        double largest_error = largest_stream_error);

/// Splits a delay: paths get what they can use, then timing, then posture.
StreamDelay split_delay(int frames, const Modification& modification, double frames_per_second);

}  // namespace mien::motion

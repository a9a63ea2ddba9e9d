#pragma once

#include "motion/skeleton/clip.h"
#include "motion/stream/streamed_modification.h"

namespace mien::motion {

/// How far the joints of one motion are from those of another, frame by frame.
struct StreamError {
  double largest_metres = 0.0;
  double rms_metres = 0.0;
  BodyJoint joint = Pelvis;  ///< where the largest is
  int frame = 0;
};

/// Both have the same frames and the canonical body.
StreamError stream_error(const Clip& streamed, const Clip& offline);

/// What a joint may be off the offline result, metres.
inline constexpr double largest_stream_error = 0.01;

/// The modification as a stream can do it at the best: feet left as they fall, and nothing that
/// `check_streamable` refuses. What a stream is held against offline.
Modification without_repair(Modification modification);

/// The shortest look-ahead of path lengths, frames, with which no joint is farther than
/// `largest_error` from where the modification of the whole motion has it; 0 when path lengths
/// stay. Found by trying on the built-in motions ("actors" and "walks-10", loops walked four times)
/// with some margin, for captures err more. Takes about a second, and depends on nothing else.
///
/// Soft joint limits are left out: no look-ahead tells how far the joints of a motion will go, so
/// that they are off until the motion has shown it.
int shortest_look_ahead(const Modification& modification, double frames_per_second,
                        double largest_error = largest_stream_error);

/// Shares out a delay: paths take what they can use, then timing, then posture.
StreamDelay shared_out(int frames, const Modification& modification, double frames_per_second);

}  // namespace mien::motion

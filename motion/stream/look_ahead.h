#pragma once

#include "motion/skeleton/clip.h"
#include "motion/stream/streamed_modification.h"

namespace mien::motion {

/// Distances between the joints of two motions.
struct StreamError {
  double largest_metres = 0.0;
  double rms_metres = 0.0;
  BodyJoint joint = Pelvis;  ///< joint with the largest distance
  int frame = 0;
};

/// Error of a streamed clip against the offline result. Both clips have the same number of frames
/// and the canonical body.
StreamError stream_error(const Clip& streamed, const Clip& offline);

/// Largest accepted distance of a joint from the offline result, metres.
inline constexpr double largest_stream_error = 0.01;

/// The modification without foot repair: its offline result is the reference for a stream, which
/// never repairs feet.
Modification without_repair(Modification modification);

/// Shortest look-ahead for path lengths, frames, at which no joint deviates by more than
/// `largest_error` (metres) from the offline result; 0 if path lengths are unchanged. Determined by
/// trial on the built-in motions ("actors" and "walks-10", with loops repeated four times), with a
/// margin because errors are larger in captures. Takes about a second; depends on the arguments
/// only.
///
/// Other changes than those of path lengths are not tried. Soft joint limits depend on the motion's
/// joint ranges, which no look-ahead can predict, so they deviate until the motion has covered its
/// range.
int shortest_look_ahead(const Modification& modification, double frames_per_second,
                        double largest_error = largest_stream_error);

/// Divides a delay of `frames` frames among the parts of a modification: path lengths get as many
/// as they can use; the rest is for timing or, without acceleration, for posture.
StreamDelay split_delay(int frames, const Modification& modification, double frames_per_second);

}  // namespace mien::motion

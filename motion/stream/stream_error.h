#pragma once

#include "motion/skeleton/clip.h"

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

}  // namespace mien::motion

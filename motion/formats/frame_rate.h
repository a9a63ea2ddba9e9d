#pragma once

namespace mien::motion {

/// The frame rate that a rounded frame time or rate stands for: the nearest whole number or NTSC
/// rate (23.976…, 29.97…, 59.94…, 119.88…) when it is within 0.1 %, else the rate itself.
/// A frame time of .0083333 s means 120 frames a second.
double snapped_frame_rate(double frames_per_second);

}  // namespace mien::motion

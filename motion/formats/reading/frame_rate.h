#pragma once

#include <string_view>

namespace mien::motion {

/// The exact frame rate for a rounded frame time or rate: the nearest whole number or NTSC rate
/// (23.976…, 29.97…, 59.94…, 119.88…) if it is within 0.1 %, otherwise the rate itself. A frame
/// time of .0083333 s, for example, means 120 frames per second.
double snapped_frame_rate(double frames_per_second);

/// The exact frame rate for a frame time (seconds, > 0) from its written digits: the common rate
/// (10, 12, 12.5, 15, … 1000) or NTSC rate whose period rounds to these digits (.0083 and .0083333:
/// 120; .033: 30; .0417: 24; .0167: 60). If there are several, common rates take precedence over
/// NTSC rates, and then the nearest is returned; if there is none, or if `written` has an exponent
/// or no decimals, the result is that of `snapped_frame_rate`.
double frame_rate_of_period(double seconds, std::string_view written);

/// As above, for a period in seconds written with `decimals` decimals; 0: the number of decimals is
/// unknown.
double frame_rate_of_period(double seconds, int decimals);

}  // namespace mien::motion

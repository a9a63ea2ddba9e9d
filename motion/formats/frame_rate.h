#pragma once

#include <string_view>

namespace mien::motion {

/// The exact frame rate of a rounded frame time or rate: the nearest whole number or NTSC
/// rate (23.976…, 29.97…, 59.94…, 119.88…) when it is within 0.1 %, else the rate itself.
/// A frame time of .0083333 s means 120 frames a second.
double snapped_frame_rate(double frames_per_second);

/// The exact frame rate of a frame time, seconds > 0, by its written digits: the common rate whose
/// period rounds to these digits (.0083 and .0083333: 120; .033: 30; .0417: 24; .0167: 60), of
/// several the nearest, whole ones before NTSC rates; else `snapped_frame_rate` of it.
double frame_rate_of_period(double seconds, std::string_view written);

/// As above for a period written with that many decimals; 0: its digits are unknown.
double frame_rate_of_period(double seconds, int decimals);

}  // namespace mien::motion

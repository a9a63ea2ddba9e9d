#pragma once

#include <string>
#include <vector>

#include "motion/animate/moment.h"
#include "motion/skeleton/clip.h"

namespace mien::motion {

/// Where a motion is not as the animator wants it.
struct Miss {
  std::string part;  ///< "right hand", "head"
  int frame = 0;     ///< nearest frame of the clip
  double seconds = 0.0;
  double amount = 0.0;  ///< metres; degrees of a direction
  bool is_angle = false;
  std::string reason;  ///< "the limit of the elbow's flexion", or "out of reach"
};

/// A miss that is reported: metres, or degrees.
inline constexpr double least_miss = 1e-3;
inline constexpr double least_miss_deg = 0.1;

/// A motion with the animator's changes.
struct AnimatedClip {
  Clip clip;
  std::vector<Miss> misses;          ///< of more than 1 mm or 0.1°
  std::vector<std::string> remarks;  ///< sentences about all of it, misses included
};

/// "right hand 3.2 cm short of its key at 1.20 s (frame 36): out of reach"
std::string sentence_of(const Miss& miss, const std::string& goal);

/// A moment in seconds. Throws mien::Error, "`what` 1.2 s, but the motion lasts 1 s", if the motion
/// does not have it; a loop has those of its first cycle.
double seconds_within(const Moment& at, const Clip& clip, const std::string& what);

/// "1.2 s"
std::string seconds_in_words(double seconds);

}  // namespace mien::motion

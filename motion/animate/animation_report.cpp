#include "motion/animate/animation_report.h"

#include <cstdio>

#include "motion/error.h"

namespace mien::motion {

std::string sentence_of(const Miss& miss, const std::string& goal) {
  const bool is_far = !miss.is_angle && miss.amount >= 1.0;  // metres
  const char* unit = miss.is_angle ? "degrees" : is_far ? "m" : "cm";
  const double amount = miss.is_angle || is_far ? miss.amount : 100.0 * miss.amount;
  char text[240];
  std::snprintf(text, sizeof text, "the %s is %.1f %s from %s at %.2f s (frame %d): %s",
                miss.part.c_str(), amount, unit, goal.c_str(), miss.seconds, miss.frame,
                miss.reason.c_str());
  return text;
}

double seconds_within(const Moment& at, const Clip& clip, const std::string& what) {
  const double seconds = at.seconds(clip.frames_per_second);
  const double last = clip.duration_seconds();
  if (seconds >= 0.0 && (seconds < last || (!clip.loops && seconds <= last + moment_tolerance)))
    return seconds;
  throw Error(
      what + " " + seconds_in_words(seconds) + ", but the motion lasts " + seconds_in_words(last),
      clip.loops ? "give a moment of its first cycle" : "give a moment of the motion");
}

std::string seconds_in_words(double seconds) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g s", seconds);
  return text;
}

}  // namespace mien::motion

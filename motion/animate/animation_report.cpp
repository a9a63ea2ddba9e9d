#include "motion/animate/animation_report.h"

#include <cstdio>

namespace mien::motion {

std::string sentence_of(const Miss& miss, const std::string& goal) {
  char text[240];
  std::snprintf(text, sizeof text, "the %s is %.1f %s from %s at %.2f s (frame %d): %s",
                miss.part.c_str(), miss.is_angle ? miss.amount : 100.0 * miss.amount,
                miss.is_angle ? "degrees" : "cm", goal.c_str(), miss.seconds, miss.frame,
                miss.reason.c_str());
  return text;
}

std::string seconds_in_words(double seconds) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g s", seconds);
  return text;
}

}  // namespace mien::motion

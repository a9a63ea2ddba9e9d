#include "motion/rig/unit_guess.h"

#include <cstdio>
#include <optional>

namespace mien::motion {

namespace {

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

std::optional<double> known_unit(double height) {
  for (const double metres : {1.0, 0.01, 0.001, 0.0254, 0.0254 / 0.45, 0.1, 0.3048}) {
    const double tall = height * metres;
    if (tall >= 1.2 && tall <= 2.2) return metres;
  }
  return std::nullopt;
}

}  // namespace

UnitGuess guess_unit(double height, const std::string& format) {
  constexpr double doll = 0.1;
  constexpr double giant = 20.0;
  const bool is_metric =
      format == "gltf" || format == "bind pose" || format == "smpl" || format == "mvnx";
  if (is_metric && height > doll && height < giant) return {};
  const std::optional<double> known = known_unit(height);
  if (!known) {
    return {
        1.7 / height,
        "The figure stands " + number(height) +
            " units tall, which does not fit any known unit of length; it is scaled to 1.70 m."};
  }
  if (!is_metric) return {*known, ""};
  return {*known, "The figure stands " + number(height) +
                      " m tall in metres, the unit of its format, which is implausible; the unit "
                      "is assumed to be " +
                      number(*known) + " m."};
}

}  // namespace mien::motion

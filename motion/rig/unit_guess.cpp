#include "motion/rig/unit_guess.h"

#include <cstdio>

namespace mien::motion {

UnitGuess guess_unit(double height, const std::string& format) {
  const bool is_metric = format == "gltf" || format == "glb";
  if (is_metric && height > 0.5 && height < 3.0) return {};
  for (const double metres : {1.0, 0.01, 0.001, 0.0254, 0.0254 / 0.45, 0.1, 0.3048}) {
    const double tall = height * metres;
    if (tall >= 1.2 && tall <= 2.2) return {metres, ""};
  }
  char tall[32];
  std::snprintf(tall, sizeof tall, "%.4g", height);
  return {1.7 / height, "The figure stands " + std::string(tall) +
                            " units tall, which fits no known unit of length; it is scaled to "
                            "1.70 m."};
}

}  // namespace mien::motion

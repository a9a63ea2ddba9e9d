#include "motion/points/length_unit.h"

#include <cstddef>

#include "motion/text/text_cursor.h"

namespace mien::motion {

namespace {

struct LengthUnit {
  std::string_view word;
  double metres;
};

constexpr LengthUnit units[] = {
    {"m", 1.0},
    {"metre", 1.0},
    {"meter", 1.0},
    {"metres", 1.0},
    {"meters", 1.0},
    {"dm", 0.1},
    {"cm", 0.01},
    {"centimetre", 0.01},
    {"centimeter", 0.01},
    {"centimetres", 0.01},
    {"centimeters", 0.01},
    {"mm", 0.001},
    {"millimetre", 0.001},
    {"millimeter", 0.001},
    {"millimetres", 0.001},
    {"millimeters", 0.001},
    {"um", 1e-6},
    {"in", 0.0254},
    {"inch", 0.0254},
    {"inches", 0.0254},
    {"ft", 0.3048},
    {"foot", 0.3048},
    {"feet", 0.3048},
};

}  // namespace

double metres_in_unit(std::string_view unit) {
  const std::size_t first = unit.find_first_not_of(" \t");
  if (first == std::string_view::npos) return 0.0;
  unit = unit.substr(first, unit.find_last_not_of(" \t") - first + 1);
  for (const LengthUnit& known : units) {
    if (same_word(unit, known.word)) return known.metres;
  }
  return 0.0;
}

}  // namespace mien::motion

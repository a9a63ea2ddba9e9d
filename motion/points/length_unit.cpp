#include "motion/points/length_unit.h"

#include <array>
#include <cstddef>

#include "motion/text/text_cursor.h"

namespace mien::motion {

namespace {

struct Unit {
  LengthUnit unit;
  std::array<std::string_view, 4> words;  ///< besides its symbol; may be empty
};

constexpr Unit units[] = {
    {{"m", 1.0}, {"metre", "meter", "metres", "meters"}},
    {{"dm", 0.1}, {}},
    {{"cm", 0.01}, {"centimetre", "centimeter", "centimetres", "centimeters"}},
    {{"mm", 0.001}, {"millimetre", "millimeter", "millimetres", "millimeters"}},
    {{"um", 1e-6}, {}},
    {{"in", 0.0254}, {"inch", "inches"}},
    {{"ft", 0.3048}, {"foot", "feet"}},
};

}  // namespace

std::optional<LengthUnit> length_unit(std::string_view word) {
  const std::size_t first = word.find_first_not_of(" \t");
  if (first == std::string_view::npos) return std::nullopt;
  word = word.substr(first, word.find_last_not_of(" \t") - first + 1);
  for (const Unit& known : units) {
    if (same_word(word, known.unit.name)) return known.unit;
    for (const std::string_view other : known.words)
      if (same_word(word, other)) return known.unit;
  }
  return std::nullopt;
}

double metres_in_unit(std::string_view unit) {
  const std::optional<LengthUnit> known = length_unit(unit);
  return known ? known->metres : 0.0;
}

}  // namespace mien::motion

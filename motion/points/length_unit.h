#pragma once

#include <optional>
#include <string_view>

namespace mien::motion {

/// A unit of length as files name it.
struct LengthUnit {
  std::string_view name;  ///< "m", "dm", "cm", "mm", "um", "in", "ft"
  double metres = 0.0;
};

/// The unit for its symbol or English name in any case, with blanks around it and also in the
/// plural: "m", "metres", "Meters", "mm", "inch", "feet". Nothing for any other text.
std::optional<LengthUnit> length_unit(std::string_view word);

/// Metres in one of the named unit; 0 for any other text.
double metres_in_unit(std::string_view unit);

}  // namespace mien::motion

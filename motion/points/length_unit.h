#pragma once

#include <string_view>

namespace mien::motion {

/// Metres in one of the unit that files of motion name, in any case and with blanks around it: "m",
/// "mm", "cm", "dm", "in", "ft", "um" and their English names, also in the plural. 0 for any other
/// text.
double metres_in_unit(std::string_view unit);

}  // namespace mien::motion

#pragma once

#include <string>

namespace mien::motion {

/// Throws Error, with the value's name and the range, unless the value is from `least` to `most`.
void check_range(const std::string& name, double value, double least, double most);

}  // namespace mien::motion

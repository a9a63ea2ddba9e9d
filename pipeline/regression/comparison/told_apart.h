#pragma once

#include <string>
#include <utility>

namespace mien::pipeline {

/// Two numbers with so many digits that they can be told from each other: `digits` significant ones
/// where those do, up to 17 where they must. "3.2" and "3.2" of 3.2 and 3.2000001 would say
/// nothing.
std::pair<std::string, std::string> told_apart(double before, double now, int digits = 6);

}  // namespace mien::pipeline

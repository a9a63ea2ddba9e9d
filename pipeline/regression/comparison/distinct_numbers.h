#pragma once

#include <string>
#include <utility>

namespace mien::pipeline {

/// Returns two numbers as texts with enough significant digits to distinguish them: `digits` if
/// these suffice, otherwise up to 17, such as "3.2" and "3.2000001". Equal numbers give equal
/// texts.
std::pair<std::string, std::string> distinct_numbers(double before, double now, int digits = 6);

}  // namespace mien::pipeline

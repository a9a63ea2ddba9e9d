#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "motion/formats/numpy/npz.h"

namespace mien::motion {

/// Names of arrays that state a frame rate, in Hz.
std::vector<std::string_view> rate_array_names();

/// The frame rate that the arrays of a file state; empty if there is none. Rounded rates are
/// corrected as by `snapped_frame_rate`. Throws mien::Error if one is not a single number between
/// 0.1 and 10,000 or two differ by more than 0.1 %.
std::optional<double> stated_rate(const Npz& npz);

/// Throws mien::Error if a rate that the user gave is not between 0.1 and 10,000.
double checked_rate(double frames_per_second, const std::string& file_name);

/// The error that asks for a rate.
Error no_rate(const std::string& file_name);

}  // namespace mien::motion

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "motion/formats/numpy/npz.h"
#include "motion/formats/reading/read_options.h"

namespace mien::motion {

/// Names of arrays that state a frame rate, in Hz.
std::vector<std::string_view> rate_array_names();

/// The frame rate that the arrays of a file state, else the one that the options give; empty if
/// there is none. Rounded rates are corrected as by `snapped_frame_rate`. Throws mien::Error if
/// none is given and an array is not a single number between 0.1 and 10,000, or two differ by more
/// than 0.1 %; or if the given one is used and not between 0.1 and 10,000.
std::optional<double> rate_of_arrays(const Npz& npz, const ReadOptions& options);

/// The error that asks for a rate.
Error no_rate(const std::string& file_name);

}  // namespace mien::motion

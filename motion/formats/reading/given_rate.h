#pragma once

#include <string>
#include <vector>

#include "motion/formats/reading/read_options.h"

namespace mien::motion {

/// Notes that a file's own frame rate is used instead of the one that the options give, if the two
/// differ by more than 0.1 %. Readers use the given rate only if the file states none, so that a
/// rate that differs from it is that of the file.
void note_unused_rate(double used, const ReadOptions& options, std::vector<std::string>& notes);

}  // namespace mien::motion

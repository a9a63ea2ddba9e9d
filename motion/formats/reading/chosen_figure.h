#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "motion/error.h"
#include "motion/skeleton/recording.h"

namespace mien::motion {

/// Which of the skeletons of a scene is read: the one asked for by name or number from 1, else the
/// one at index `usual`, the largest. `names` are those of the roots, at least one. If there are
/// several, `recording` gets them as its `subjects` (as `subject_names` makes them distinct) with
/// the chosen one as its `subject`, and, if none was asked for, a note on the choice. Throws
/// mien::Error at `place`, with the names, if there is no such figure.
std::size_t chosen_figure(const Place& place, const std::vector<std::string>& names,
                          std::size_t usual, const std::optional<std::string>& wanted,
                          Recording& recording);

}  // namespace mien::motion

#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "pipeline/production/run/production.h"

namespace mien::pipeline {

/// Number of frames of each film, by its task ("film:walk"): that of its motion if it has been
/// produced, otherwise the one assumed for the task's cost. That suffices for splitting a study
/// into chunks, because a chunk is identified by its number, not by its frames.
std::map<std::string, int> film_lengths(const Production& production,
                                        const std::filesystem::path& folder);

/// Like film_lengths, but reads motion files that have not been read yet, since they may have any
/// duration. Throws Error for a file that cannot be staged.
std::map<std::string, int> measured_film_lengths(Production& production,
                                                 const std::filesystem::path& folder);

}  // namespace mien::pipeline

#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "pipeline/production/run/production.h"

namespace mien::pipeline {

/// Number of frames of each film, by its task ("film:walk"): taken from its motion if that has been
/// produced, otherwise the estimate used for the task's cost. An estimate suffices for splitting a
/// study into chunks, because a chunk is identified by its number, not by its frames.
std::map<std::string, int> film_lengths(const Production& production,
                                        const std::filesystem::path& folder);

/// Like film_lengths, but reads motion files that have not been read yet, since they may have any
/// duration. Throws Error for a file that cannot be staged.
std::map<std::string, int> measured_film_lengths(Production& production,
                                                 const std::filesystem::path& folder);

}  // namespace mien::pipeline

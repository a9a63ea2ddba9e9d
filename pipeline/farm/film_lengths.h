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

/// Like film_lengths, but makes the motions from files and along paths that have not been produced
/// yet, since they may have any duration. After 200 of them, the mean length of these is assumed
/// for the others. Throws Error for a motion that cannot be made.
std::map<std::string, int> measured_film_lengths(Production& production,
                                                 const std::filesystem::path& folder);

}  // namespace mien::pipeline

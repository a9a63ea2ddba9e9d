#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "pipeline/production/run/production.h"

namespace mien::pipeline {

/// Frames of each film, by its task ("film:walk"). They are those of its motion where that has been
/// made, and what the tasks' cost assumes elsewhere, which is good enough to cut a study into
/// pieces: a chunk says which of how many it is, not which frames.
std::map<std::string, int> film_lengths(const Production& production,
                                        const std::filesystem::path& folder);

/// The same, but motion files that have not been read yet are read: they may last any time. Throws
/// Error for one that cannot be shown.
std::map<std::string, int> measured_film_lengths(Production& production,
                                                 const std::filesystem::path& folder);

}  // namespace mien::pipeline

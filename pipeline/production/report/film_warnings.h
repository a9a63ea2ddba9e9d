#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

/// Warnings about films, such as hands that are not from the motion, by the id of the stimulus or
/// overlay; without those that have none.
using FilmWarnings = std::map<std::string, std::vector<std::string>>;

/// Those in the records of a study's films, which are in `folder`.
FilmWarnings film_warnings(const Manifest& manifest, const std::filesystem::path& folder);

}  // namespace mien::pipeline

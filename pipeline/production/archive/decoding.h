#pragma once

#include <filesystem>
#include <string>

#include "pipeline/production/film/film_record.h"

namespace mien::pipeline {

/// What is wrong with a file that mien wrote, found by reading all of it as what its name says:
/// videos (decoded, their frames counted, their time measured), pictures (every pixel), CSV, JSON,
/// motions, PDF and pages (from beginning to end), texts. Empty when nothing is.
std::string decoding_fault(const std::filesystem::path& file);

/// Likewise of a video, and whether it is the one that a film's record tells.
std::string decoding_fault(const std::filesystem::path& file, const VideoRecord& record);

}  // namespace mien::pipeline

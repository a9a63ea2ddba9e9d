#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "pipeline/base/documents/fault.h"
#include "pipeline/base/documents/places.h"
#include "pipeline/manifest/stimulus.h"

namespace mien::pipeline {

/// Pixels from side to side, below which a picture shows nothing.
inline constexpr int least_picture_side = 16;

/// Pixels of a picture, cropped or not, that can be drawn in a common machine's memory.
inline constexpr std::int64_t most_picture_pixels = 8192LL * 8192;

/// Where a document says what a film is like: the film's own part, which may be silent, and the one
/// that it is laid over. "stimuli[2].output" and "output"; for options of a command both are empty.
struct FilmPaths {
  std::string own_look;
  std::string look;
  std::string own_output;
  std::string output;
};

/// The paths of a stimulus or an overlay in its manifest.
FilmPaths paths_of(const Stimulus& film);

/// Pictures and videos that cannot be as `output` at that path describes them: sizes and rates.
/// Nothing when the document says none of these there.
std::vector<Fault> check_output(const Output& output, const std::string& path,
                                const Places& places);

/// What a film's look and its output do not allow each other.
std::vector<Fault> check_film(const Stimulus& film, const FilmPaths& paths, const Places& places);

}  // namespace mien::pipeline

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "pipeline/base/documents/fault.h"
#include "pipeline/base/documents/places.h"
#include "pipeline/manifest/stimulus.h"

namespace mien::pipeline {

/// Minimum width and height of a picture after scaling and cropping, in pixels.
inline constexpr int least_picture_side = 16;

/// Maximum number of pixels of a picture after scaling and before cropping, so that it fits into
/// the memory of a common machine.
inline constexpr std::int64_t most_picture_pixels = 8192LL * 8192;

/// Paths in a document at which a film's look and output are stated: the film's own part, which may
/// be absent, and the part of the manifest that supplies its defaults ("stimuli[2].output" and
/// "output"). All are empty for command-line options.
struct FilmPaths {
  std::string own_look;
  std::string look;
  std::string own_output;
  std::string output;
};

/// Returns the paths of a stimulus or an overlay in its manifest.
FilmPaths paths_of(const Stimulus& film);

/// Checks the sizes, samples and frame rates of an output stated at `path`. Returns no faults if
/// the document states none of them at that path.
std::vector<Fault> check_output(const Output& output, const std::string& path,
                                const Places& places);

/// Returns the conflicts between a film's look and its output.
std::vector<Fault> check_film(const Stimulus& film, const FilmPaths& paths, const Places& places);

}  // namespace mien::pipeline

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "pipeline/regression/compared_pictures.h"
#include "pipeline/regression/comparer.h"
#include "pipeline/regression/comparison.h"
#include "pipeline/regression/regression.h"

namespace mien::pipeline {

/// The choice of pictures in a report, which limits the loading time of its page.
struct ReportPictures {
  /// Every frame that differs; false: only the worst frame of each stimulus.
  bool every_frame = true;
  /// Maximum width in pixels, to which wider pictures are scaled; 0: no scaling.
  int most_width = 0;
};

/// Maximum number of stimuli shown with every differing frame; with more, only the worst frames are
/// shown.
inline constexpr std::size_t most_with_every_frame = 50;

/// Target for the total size of a page's pictures, in bytes.
inline constexpr std::uintmax_t most_picture_bytes = 64U << 20U;

/// Returns the largest choice whose pictures have at most most_picture_bytes in total; the size of
/// scaled pictures is estimated. Every frame is chosen only if at most most_with_every_frame
/// stimuli have frames that differ. With very many pictures, even the smallest choice, 320 pixels
/// wide, may be larger.
ReportPictures fitting_pictures(const Regression& regression, const ComparedPictures& pictures);

/// Returns the frames of a stimulus that the page shows, ascending: those that differ and have
/// equal sizes or, unless `every_frame`, only the one of these with the largest mean ꟻLIP error.
std::vector<const FrameComparison*> shown_frames(const StimulusComparison& one, bool every_frame);

/// Returns a PNG as a data URI. Throws the errors of reading and writing.
std::string picture_uri(const std::filesystem::path& file, int most_width);

/// Returns the key frames of a stimulus for the page's script: measures and pictures. An empty list
/// if none is shown. Throws the errors of reading.
nlohmann::ordered_json frames_json(const StimulusComparison& one, const ComparedPictures& pictures,
                                   const ReportPictures& chosen);

/// Returns both motions of a stimulus and their distances for the page's script. Joint positions in
/// world space, frame by frame, are encoded as little-endian 16-bit integers in base64; the size of
/// their step in millimetres is stated. Distances are in millimetres. `one.motion` must be set.
/// Throws the errors of reading.
nlohmann::ordered_json motion_json(const StimulusComparison& one, const ComparedStudy& study);

}  // namespace mien::pipeline

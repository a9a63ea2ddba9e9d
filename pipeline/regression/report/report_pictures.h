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

/// Which pictures a report holds, so that its page opens quickly.
struct ReportPictures {
  bool every_frame = true;  ///< that differs; else the worst of each stimulus
  int most_width = 0;       ///< pixels; wider pictures are made as wide; 0: all stay as they are
};

/// More stimuli than that are shown by their worst frame alone.
inline constexpr std::size_t most_with_every_frame = 50;

/// Pictures of a page should take no more than that.
inline constexpr std::uintmax_t most_picture_bytes = 64U << 20U;

/// The most that fits. A page of very many large pictures may take more even so.
ReportPictures fitting_pictures(const Regression& regression, const ComparedPictures& pictures);

/// Frames of a stimulus that the page shows, ascending: they differ, and are of one size.
std::vector<const FrameComparison*> shown_frames(const StimulusComparison& one, bool every_frame);

/// A PNG as an address that holds all of it. Throws what reading and writing do.
std::string picture_uri(const std::filesystem::path& file, int most_width);

/// Key frames of a stimulus for the page's script: what was measured, and the pictures. An empty
/// list where none is shown. Throws what reading does.
nlohmann::ordered_json frames_json(const StimulusComparison& one, const ComparedPictures& pictures,
                                   const ReportPictures& chosen);

/// Both motions of a stimulus and their distances for the page's script. World places of joints,
/// frame by frame, are 16-bit numbers, little end first, in base64, in steps of so many
/// millimetres; distances are in millimetres. `one.motion` is known. Throws what reading does.
nlohmann::ordered_json motion_json(const StimulusComparison& one, const ComparedStudy& study);

}  // namespace mien::pipeline

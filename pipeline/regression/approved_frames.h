#pragma once

#include <string>

#include "motion/skeleton/clip.h"
#include "pipeline/regression/baseline.h"
#include "pipeline/regression/comparison/noise_test.h"
#include "render/image/image.h"

namespace mien::pipeline {

// Functions that read the stored files of a stimulus in a baseline. If a file cannot be read, or a
// stored picture no longer has the hash that was recorded at approval, they throw an Error that
// names the file and a remedy.

/// Returns the approved clip, accurate to 0.001 mm. `like` supplies what the file does not store:
/// the clip's name and how it loops.
motion::Clip approved_clip(const Baseline& baseline, const std::string& id,
                           const motion::Clip& like);

/// Returns a key frame as a display shows it.
render::Image8 approved_picture(const Baseline& baseline, const std::string& id, int frame);

/// Returns the block statistics of a key frame.
BlockStatistics approved_blocks(const Baseline& baseline, const std::string& id, int frame);

/// Returns the hash by which a baseline identifies a picture.
Hash hash_of_pixels(const render::Image8& picture);

}  // namespace mien::pipeline

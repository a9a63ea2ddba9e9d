#pragma once

#include <string>

#include "motion/skeleton/clip.h"
#include "pipeline/regression/baseline.h"
#include "pipeline/regression/comparison/noise_test.h"
#include "render/image/image.h"

namespace mien::pipeline {

// What a baseline keeps of a stimulus, read and checked. All throw Error, with the file and how to
// mend it.

/// The clip that was approved, to a thousandth of a millimetre. `like` says what the file cannot:
/// its name, and how it repeats.
motion::Clip approved_clip(const Baseline& baseline, const std::string& id,
                           const motion::Clip& like);

/// A key frame as a display shows it.
render::Image8 approved_picture(const Baseline& baseline, const std::string& id, int frame);

/// The block statistics of a key frame.
BlockStatistics approved_blocks(const Baseline& baseline, const std::string& id, int frame);

/// The hash by which a baseline identifies a picture.
Hash hash_of_pixels(const render::Image8& picture);

}  // namespace mien::pipeline

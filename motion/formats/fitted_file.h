#pragma once

#include <filesystem>
#include <optional>

#include "motion/fitting/fit_quality.h"
#include "motion/formats/reading/read_options.h"
#include "motion/skeleton/recording.h"

namespace mien::motion {

/// A file as a motion, and how well the body fits its points.
struct FittedFile {
  Recording recording;
  std::optional<FitQuality> fit;  ///< empty if the file holds no points, or they cannot be fitted
};

/// As `read_motion` (motion_file.h).
FittedFile read_fitted(const std::filesystem::path& path, const ReadOptions& options = {});

}  // namespace mien::motion

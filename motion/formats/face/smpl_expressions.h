#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "motion/formats/face/face_track.h"

namespace mien::motion {

/// The coefficients of facial expression in an .npz file of SMPL-X, such as one of BEAT2: the array
/// `expressions` or `expression` of frames × coefficients, named "exp0", "exp1" … Coefficients may
/// be negative and above 1. The frame rate is that of the file, or else `frames_per_second`. Throws
/// mien::Error without such an array or a rate.
FaceTrack read_smpl_expressions(const std::filesystem::path& path,
                                std::optional<double> frames_per_second);

/// As `read_smpl_expressions`, for a file in memory.
FaceTrack parse_smpl_expressions(std::string_view bytes, const std::string& file_name,
                                 std::optional<double> frames_per_second);

}  // namespace mien::motion

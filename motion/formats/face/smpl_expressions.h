#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "motion/formats/face/face_track.h"

namespace mien::motion {

/// The face in an .npz file of SMPL-X, such as one of BEAT2; at least one of
///
/// - the coefficients of facial expression: the array `expressions` or `expression` of frames ×
///   coefficients, named "exp0", "exp1" … They may be negative and above 1.
/// - the rotations of jaw and eyes, as far as they move: the arrays `jaw_pose` or `pose_jaw`,
///   `leye_pose`, `reye_pose` or `pose_eye`, or those among the 165 columns of `poses` or `pose`.
///   They are rotation vectors in radians, in the axes of the head, named "jaw_pose_x" to
///   "reye_pose_z".
///
/// The frame rate is that of the file, or else `frames_per_second`. Throws mien::Error without
/// such arrays or a rate, or with both rates.
FaceTrack read_smpl_expressions(const std::filesystem::path& path,
                                std::optional<double> frames_per_second);

/// As `read_smpl_expressions`, for a file in memory.
FaceTrack parse_smpl_expressions(std::string_view bytes, const std::string& file_name,
                                 std::optional<double> frames_per_second);

}  // namespace mien::motion

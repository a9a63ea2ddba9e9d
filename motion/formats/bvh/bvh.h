#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "motion/formats/reading/read_options.h"
#include "motion/skeleton/recording.h"

namespace mien::motion {

/// Reads a BVH file (Biovision hierarchy): joints in any order, and on any joint up to six channels
/// in any order. Offsets keep the unit and axes of the file; angles are in degrees.
///
/// - The rotation of a joint is the product of its rotation channels in CHANNELS order.
/// - Each position channel replaces the corresponding coordinate of OFFSET. Those of the root
///   determine `root_position`; if another joint has position channels, every pose gets `offsets`.
/// - A frame may extend over several lines. Comments (# and //) are ignored.
/// - A frame time is converted to the frame rate from which it was rounded (frame_rate.h).
///
/// - A file of several figures has a ROOT for each, and the numbers of all in a frame. `subjects`
///   lists the names of the roots; `options.subject` chooses one by name or number (from 1).
///   Without it, the first is read, and `notes` says so.
///
/// Throws mien::Error with file, line and column for anything that is not a BVH motion of at least
/// one frame, for example a subject that is not there, numbers that are not finite, a frame with
/// more or fewer numbers than there are channels, or a `Frames:` that differs from the actual
/// number of frames.
Recording read_bvh(const std::filesystem::path& path, const ReadOptions& options = {});

/// As `read_bvh`, for a text in memory; `file_name` is used in error messages and, without folder
/// and extension, as the name of the recording.
Recording parse_bvh(std::string_view text, const std::string& file_name,
                    const ReadOptions& options = {});

/// Maximum number of decimals written for positions, angles (degrees) and the frame time (seconds).
inline constexpr int bvh_position_decimals = 7;
inline constexpr int bvh_angle_decimals = 9;
inline constexpr int bvh_time_decimals = 12;

/// The recording as BVH text, joints depth first. The root has the channels X, Y, Z position and Z,
/// X, Y rotation; other joints have the Z, X, Y rotation only, or all six channels if their offset
/// in any pose differs from that of the skeleton. Angles continue beyond ±180°, so that
/// interpolated curves do not jump. Positions have up to 7 decimals, angles up to 9; zeros at the
/// end are omitted. In names, control characters and braces are replaced by '_', and spaces at
/// either end are removed; an empty name becomes "joint_" and the index of the joint.
///
/// The recording has at least one pose. The same recording always produces the same text.
std::string to_bvh(const Recording& recording);

/// The result of `parse_bvh(to_bvh(recording))`, identical to the last bit but computed without the
/// text. The recording must be as returned by `to_recording`: joints depth first, with valid names,
/// and without per-pose offsets.
Recording as_read_from_bvh(const Recording& recording);

}  // namespace mien::motion

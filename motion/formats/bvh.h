#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "motion/skeleton/recording.h"

namespace mien::motion {

/// Reads a BVH file (Biovision hierarchy): one ROOT, joints in any order, one to six channels in
/// any order on any joint or none at all. Offsets stay in the file's unit and axes; angles are
/// degrees.
///
/// - A joint's rotation is the product of its rotation channels in CHANNELS order.
/// - Position channels replace OFFSET, each the one coordinate it names. The root's give
///   `root_position`; when another joint has any, every pose gets `offsets`.
/// - A frame stands on one line or on several. Comments (# and //) are ignored.
/// - A frame time is converted to the frame rate that it was rounded from (frame_rate.h).
///
/// Throws mien::Error with file, line and column for everything that is not a BVH motion of at
/// least one frame: among others a second ROOT, numbers that are not finite, a frame with more or
/// fewer numbers than there are channels, and a `Frames:` that differs from the frames there are.
Recording read_bvh(const std::filesystem::path& path);

/// As `read_bvh`, from a text in memory; `file_name` serves error messages and the recording's
/// name.
Recording parse_bvh(std::string_view text, const std::string& file_name);

/// Number of decimals that are written for positions, angles (degrees) and the frame time
/// (seconds).
inline constexpr int bvh_position_decimals = 7;
inline constexpr int bvh_angle_decimals = 9;
inline constexpr int bvh_time_decimals = 12;

/// The recording as BVH text: joints depth first, channels X, Y, Z position then Z, X, Y rotation
/// on the root, Z, X, Y rotation on the others, and all six on a joint whose offset changes over
/// the poses. Angles run on over ±180° so that curves between frames do not jump. Positions have 7
/// decimals, angles 9. Control characters and braces in names become '_'.
///
/// The recording has at least one pose. The same recording gives the same text.
std::string to_bvh(const Recording& recording);

/// The result of `parse_bvh(to_bvh(recording))`, to the last bit but without the text, for a
/// recording as made by `to_recording`: joints depth first, with names that can be written, and no
/// offsets of poses.
Recording as_read_from_bvh(const Recording& recording);

/// Writes a recording as a BVH file. Throws WriteFailure when the file cannot be written.
void write_bvh(const Recording& recording, const std::filesystem::path& path);

}  // namespace mien::motion

#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "motion/skeleton/recording.h"

namespace mien::motion {

/// Reads the figure and one animation of a glTF 2.0 file, text (.gltf with its .bin files) or
/// binary (.glb). The animation is the one named by `take`, or else the first one that moves
/// anything. `takes` of the recording lists the names of all animations that move anything: the
/// third animation of the file, if it has no name, is "take 3", and a second one named "Walk" is
/// "Walk 2". Units and axes are those of glTF: metres, +Y up.
///
/// - The skeleton consists of the joints of the skins and the nodes between them, parents first and
///   children in the order of the file. Without a skin, it consists of the nodes of the tree that
///   the animation moves, with exceptions (gltf_figure.h). Of several figures, `subject` chooses
///   one by the name of its root or by number (from 1); without it, the one with the most joints is
///   used, and `notes` gets a sentence about it.
///   A node without a name is called "joint_0", "joint_1", … by its index in the skeleton. The
///   `tip` of a joint is the position of its only child, or of the one named after it ("Head_end"),
///   if that is no joint, is not animated and has no children, mesh or camera.
/// - In VRM animations (.vrma) and characters (.vrm, 1.0 and 0.x), the skeleton consists of the
///   bones of the humanoid and the nodes between them, and bones are named as VRM names them
///   ("hips", "leftUpperArm"), whatever their nodes are called. Figures of VRM 0.x face −Z.
/// - World positions are exact for any scales and for matrices without shear: nodes above the root
///   become part of the root's pose, and scales become part of the offsets. Poses get `offsets`
///   only if a joint moves relative to its parent by more than a millionth of the longest offset.
/// - Supported are STEP, LINEAR and CUBICSPLINE interpolation, float and integer values, sparse
///   accessors, and buffer views compressed by meshopt.
/// - Frames extend from the first key to the last. Their rate is that of the keys if the track with
///   the most keys has evenly spaced keys at 10 per second or more (or fewer in some cases, see
///   `timing_of` in gltf_track.h), otherwise `rate`, or 30 per second. Without an animation of the
///   figure there is one frame, the pose of the nodes.
///
/// Throws mien::Error naming the file (for JSON faults also line and column) if it contains no
/// figure or is invalid: for example if `take` does not exist, indices or buffers are out of
/// bounds, a node has two parents, numbers are not finite, or the motion is longer than an hour.
Recording read_gltf(const std::filesystem::path& path,
                    const std::optional<std::string>& take = std::nullopt,
                    const std::optional<std::string>& subject = std::nullopt,
                    std::optional<double> rate = std::nullopt);

/// As `read_gltf`, for a file in memory; `file_name` is used in error messages and, without folder
/// and extension, as the name of the recording. A file that refers to other files for its buffers
/// is refused.
Recording parse_gltf(std::string_view bytes, const std::string& file_name,
                     const std::optional<std::string>& take = std::nullopt,
                     const std::optional<std::string>& subject = std::nullopt,
                     std::optional<double> rate = std::nullopt);

/// The recording as a binary glTF file. It has a node for each joint and one named "…_end" for each
/// tip; one animation, with a rotation track for every joint and a translation track for the root
/// and for joints whose offset in any pose differs from that of the skeleton; and a mesh of
/// octahedra along the bones, skinned so that importers create an armature from the nodes. The bind
/// pose has no rotations. Keys and vertices are 32-bit floats. Lengths are written unchanged, and
/// glTF readers interpret them as metres; use `in_metres` beforehand to convert them. Where the
/// times of the keys do not hold the frame rate, as with one frame, it is stated as
/// `framesPerSecond` in the extras of the animation.
///
/// The recording has at least one pose. The same recording always produces the same bytes.
std::string to_glb(const Recording& recording);

}  // namespace mien::motion

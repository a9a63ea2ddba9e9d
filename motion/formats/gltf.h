#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "motion/skeleton/recording.h"

namespace mien::motion {

/// Reads the figure and one animation of a glTF 2.0 file, text (.gltf, with its .bin files) or
/// binary (.glb): the one that `take` names, else the first that moves anything. `takes` of the
/// recording lists them; one without a name is called "take 3" by its place, a second "Walk"
/// "Walk 2". Units and axes are glTF's: metres, +Y up.
///
/// - The skeleton is the joints of the skins and the nodes between them, parents first, children in
///   the order of the file; without a skin, all nodes of the tree that the animation moves
///   (gltf_figure.h). Of two figures the larger one, which `notes` tell. A node without a name is
///   called "joint_0", "joint_1", … by its place in the skeleton. A still, childless node
///   without a mesh that is the only child of a last joint is the tip of its bone.
/// - World positions are exact whatever scales and matrices there are: nodes above the root become
///   part of the root's pose, scales part of the offsets. Every pose gets `offsets` only when a
///   joint moves on its parent by more than a millionth of the longest offset.
/// - Samplers: STEP, LINEAR, CUBICSPLINE; floats or integers; sparse accessors; buffer
///   views compressed by meshopt.
/// - Frames run from the first key to the last, at the rate of the keys when those of the longest
///   track are evenly spaced at 10 a second or more (slower for recordings, gltf_track.h), else at
///   30. Without an animation there is one frame, the pose of the nodes.
///
/// Throws mien::Error naming the file, for JSON faults with line and column, for everything that is
/// no such figure: among others a take that is not there, indices and buffers out of bounds, a node
/// with two parents, numbers that are not finite, more than an hour of motion.
Recording read_gltf(const std::filesystem::path& path,
                    const std::optional<std::string>& take = std::nullopt);

/// As `read_gltf`, from a file in memory; `file_name` serves error messages and the recording's
/// name. A file that keeps its buffers in other files is refused.
Recording parse_gltf(std::string_view bytes, const std::string& file_name,
                     const std::optional<std::string>& take = std::nullopt);

/// The recording as a binary glTF file: a node for each joint and, named "…_end", for each tip; one
/// animation with a rotation for every joint and a translation for the root and for joints whose
/// offset changes over the poses; and a mesh of octahedra from joint to joint, skinned so that
/// importers make an armature of the nodes. The bind pose has no rotations. Numbers are 32-bit
/// floats; lengths are written as they are and read as metres by others (`in_metres` makes them
/// so).
///
/// The recording has at least one pose. The same recording gives the same bytes.
std::string to_glb(const Recording& recording);

/// Writes a recording as a GLB file. Throws mien::Error when the file cannot be written.
void write_glb(const Recording& recording, const std::filesystem::path& path);

}  // namespace mien::motion

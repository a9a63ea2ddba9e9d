#pragma once

#include <optional>
#include <string>
#include <vector>

#include "motion/formats/gltf/gltf_library.h"
#include "motion/formats/gltf/gltf_nodes.h"
#include "motion/formats/gltf/gltf_track.h"
#include "motion/skeleton/recording.h"

namespace mien::motion {

/// The nodes of a glTF file that form the figure.
struct GltfFigure {
  std::vector<int> above;    ///< the root's ancestors, topmost first
  std::vector<int> joints;   ///< joints of the skeleton, depth first
  std::vector<int> parents;  ///< for each joint, its parent's index in `joints`; −1 for the root
};

/// The figure of a file: the bones of a VRM file and the nodes between them; in any other, the
/// joints of its skins and the nodes between them. Skins belong to the
/// same figure if the root of one is at or below the root of the other. Without a skin, the figure
/// consists of the nodes of the animated tree from the first one that moves or has several
/// children, except cameras and the ends of bones. Of several figures of two or more joints, named
/// after their roots, the one that is asked for is returned, else the one with the most joints (the
/// first of equals); `recording` gets their names and a note (chosen_figure.h). Throws mien::Error
/// if there is neither a VRM humanoid nor a skin nor an animation, or not the figure asked for.
GltfFigure gltf_figure(const GltfFile& file, const GltfNodes& nodes,
                       const std::vector<GltfTrack>& tracks,
                       const std::optional<std::string>& wanted, Recording& recording);

/// For each node, whether a track moves it.
std::vector<bool> moved_nodes(const GltfNodes& nodes, const std::vector<GltfTrack>& tracks);

/// The node that marks the end of a joint's bone: a node that does not move and has no children,
/// mesh or camera, if it is the only child or named after the joint ("Head_end"). −1 if there is
/// none.
int tip_node(const GltfFile& file, const GltfNodes& nodes, const std::vector<bool>& moved,
             int joint);

}  // namespace mien::motion

#pragma once

#include <string>
#include <vector>

#include "motion/formats/gltf_library.h"
#include "motion/formats/gltf_nodes.h"
#include "motion/formats/gltf_track.h"

namespace mien::motion {

/// The nodes of a glTF file that form the figure.
struct GltfFigure {
  std::vector<int> above;    ///< the root's ancestors, topmost first
  std::vector<int> joints;   ///< depth first
  std::vector<int> parents;  ///< of each joint, as the skeleton counts; −1 for the root
};

/// The joints of the skins and the nodes between them; skins that share joints, or of which one
/// hangs on the other, are one figure's. Without a skin: all nodes of the tree that moves, but for
/// cameras and the ends of bones. Of several figures the one with most joints, the first of those;
/// `notes` then gets a sentence. Throws mien::Error when there is neither a skin nor an animation.
GltfFigure gltf_figure(const GltfFile& file, const GltfNodes& nodes,
                       const std::vector<GltfTrack>& tracks, std::vector<std::string>& notes);

/// Whether each node is moved by a track.
std::vector<bool> moved_nodes(const GltfNodes& nodes, const std::vector<GltfTrack>& tracks);

/// The node that marks the end of a leaf joint's bone, or −1.
int tip_node(const GltfFile& file, const GltfNodes& nodes, const std::vector<bool>& moved,
             int joint);

}  // namespace mien::motion

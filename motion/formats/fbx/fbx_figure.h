#pragma once

#include <optional>
#include <string>
#include <vector>

#include "motion/formats/fbx/fbx_scene.h"
#include "motion/skeleton/recording.h"

namespace mien::motion {

/// The models of a file that form the figure.
struct FbxFigure {
  std::vector<int> above;    ///< the root's ancestors, topmost first
  std::vector<int> joints;   ///< joints of the skeleton, depth first
  std::vector<int> parents;  ///< for each joint, its parent's index in `joints`; −1 for the root
};

/// The joints of a file's figures: models of the kinds "LimbNode", "Limb" and "Root", and those
/// that skins are bound to. In a file without any, the models that `moved` marks and all below
/// them, without cameras and lights.
std::vector<bool> fbx_joints(const FbxScene& scene, const std::vector<bool>& moved);

/// The figure: joints that hang on the same topmost joint, and the models between them. The bones
/// of a skin belong to the same figure even if only another model connects them. Of several figures
/// of two or more joints, named after their roots, the one that is asked for is returned, else the
/// one with the most joints (the first of equals); `recording` gets their names and a note
/// (chosen_figure.h). Throws mien::Error if there is no figure, or not the one asked for.
FbxFigure fbx_figure(const FbxScene& scene, const std::vector<bool>& is_joint,
                     const std::optional<std::string>& wanted, Recording& recording);

/// Takes ends of bones out of the figure's joints, such as "HeadTop_End": models without children
/// and motion that are the only child of their parent and are called an end.
void drop_ends(const FbxScene& scene, const std::vector<bool>& moved, FbxFigure& figure);

/// The model whose position is the tip of a joint that has no children in the figure: its only
/// child, if that has no children, no geometry and no motion; −1 if there is none.
int fbx_tip(const FbxScene& scene, const std::vector<bool>& moved, int joint);

}  // namespace mien::motion

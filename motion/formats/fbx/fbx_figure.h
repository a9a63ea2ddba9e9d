#pragma once

#include <string>
#include <vector>

#include "motion/formats/fbx/fbx_scene.h"

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
/// of a skin belong to the same figure even if only another model connects them. If there are
/// several figures, the one with the most joints is returned (the first of equals), and a sentence
/// about others of two or more joints is added to `notes`. Throws mien::Error if there is none.
FbxFigure fbx_figure(const FbxScene& scene, const std::vector<bool>& is_joint,
                     std::vector<std::string>& notes);

/// Takes ends of bones out of the figure's joints, such as "HeadTop_End": models without children
/// and motion that are the only child of their parent and are called an end.
void drop_ends(const FbxScene& scene, const std::vector<bool>& moved, FbxFigure& figure);

/// The model whose position is the tip of a joint that has no children in the figure: its only
/// child, if that has no children, no geometry and no motion; −1 if there is none.
int fbx_tip(const FbxScene& scene, const std::vector<bool>& moved, int joint);

}  // namespace mien::motion

#pragma once

#include <vector>

#include "motion/formats/fbx/fbx_figure.h"
#include "motion/formats/fbx/fbx_scene.h"
#include "motion/skeleton/recording.h"

namespace mien::motion {

/// The figure in a pose of the models: metres, +Y up, with an offset for every joint (that of the
/// root is its position). Throws mien::Error if a joint is more than 10⁹ m away.
Pose fbx_pose(const FbxScene& scene, const FbxFigure& figure, const std::vector<FbxMoving>& moving);

/// The figure's skeleton with the offsets of the models at rest, in metres. Names differ.
Skeleton fbx_skeleton(const FbxScene& scene, const FbxFigure& figure,
                      const std::vector<bool>& moved);

}  // namespace mien::motion

#pragma once

#include <string>
#include <vector>

#include "motion/skeleton/skeleton.h"
#include "scenes/figures/figure.h"

namespace mien::scenes {

/// A joint with a dot, and the dot at the proximal end of its limb.
struct DotJoint {
  std::string name;
  int joint = 0;
  double along = 0.0;  ///< position between the joint (0) and its tip (1)
  int limb = -1;       ///< index of the dot on the nearest joint towards the root; −1: none
};

/// The joints that have dots. Throws Error for one that the skeleton does not have.
std::vector<DotJoint> dot_joints(const motion::Skeleton& skeleton,
                                 const PointLightOptions& options);

/// Names that PointLightOptions::joints may contain: the skeleton's, and "HeadTop" of a canonical
/// body.
std::vector<std::string> dot_joint_names(const motion::Skeleton& skeleton);

}  // namespace mien::scenes

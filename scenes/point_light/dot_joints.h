#pragma once

#include <string>
#include <vector>

#include "motion/skeleton/skeleton.h"
#include "scenes/figures/point_light_options.h"

namespace mien::scenes {

/// A joint that carries a dot, and the one up the body towards which its limb goes.
struct DotJoint {
  std::string name;
  int joint = 0;
  double along = 0.0;  ///< share of the way from the joint to its tip
  int limb = -1;       ///< index of the dot at the other end of its limb; −1: none
};

/// The joints that carry dots. Throws Error for one that the skeleton does not have.
std::vector<DotJoint> dot_joints(const motion::Skeleton& skeleton,
                                 const PointLightOptions& options);

/// Names that `joints` can have: the skeleton's, and "HeadTop" of a body.
std::vector<std::string> dot_joint_names(const motion::Skeleton& skeleton);

}  // namespace mien::scenes

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

/// The joints that have dots; those of fingers (`has_fingers`) are the joints of
/// motion::with_fingers. Throws Error for one that the skeleton does not have, and for fingers if
/// the motion has none.
std::vector<DotJoint> dot_joints(const motion::Skeleton& skeleton, bool has_fingers,
                                 const PointLightOptions& options);

/// Names that PointLightOptions::joints may contain: the skeleton's and, of a canonical body,
/// "HeadTop", those of the joints of fingers ("LeftThumb1", …) and of their tips ("LeftThumbTip").
std::vector<std::string> dot_joint_names(const motion::Skeleton& skeleton);

/// Whether any of the dots would be on a finger of a canonical body.
bool has_dots_on_fingers(const PointLightOptions& options);

}  // namespace mien::scenes

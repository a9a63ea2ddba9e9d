#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "motion/skeleton/skeleton.h"

namespace mien::motion {

/// A degree of freedom of a bone: one number of its line in an AMC frame.
struct AcclaimFreedom {
  int axis = 0;          ///< 0 x, 1 y, 2 z
  bool rotation = true;  ///< else a translation
};

/// The axes and degrees of freedom of a bone.
struct AcclaimBone {
  Quat axis = Quat::Identity();          ///< C: the frame relative to which the bone rotates
  std::vector<AcclaimFreedom> freedoms;  ///< in the order of the numbers in the AMC file
};

/// The contents of an ASF file. Bone j moves joint j; bone 0 is the root.
struct AcclaimSkeleton {
  Skeleton skeleton;
  std::vector<AcclaimBone> bones;
  double metres_per_unit = 1.0;  ///< also 1 if the unit is unknown
  double radians_per_unit = radians_per_degree;
};

/// Reads an ASF text (asf_file.h) into joints, depth first from the root; see acclaim.h for frames
/// and units. Throws mien::Error.
AcclaimSkeleton parse_asf(std::string_view text, const std::string& file_name);

}  // namespace mien::motion

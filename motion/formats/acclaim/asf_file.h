#pragma once

#include <optional>
#include <string>
#include <vector>

#include "motion/formats/acclaim/acclaim_skeleton.h"
#include "motion/text/text_cursor.h"

namespace mien::motion {

/// The rotation of an axis line, in the file's unit of angles.
struct AsfAxis {
  Vec3 angles = Vec3::Zero();  ///< about x, y and z
  std::string order = "XYZ";   ///< the rotation of the first letter is the innermost
};

/// A bone as described in its begin … end block.
struct AsfBone {
  std::string name;
  size_t place = 0;  ///< index of the block in the text, for error messages
  std::optional<Vec3> direction;
  std::optional<double> length;
  std::optional<AsfAxis> axis;
  std::vector<AcclaimFreedom> freedoms;
  int parent = -1;
  std::vector<int> children;
};

/// The statements of an ASF file, in its own units.
struct AsfFile {
  std::vector<AsfBone> bones;  ///< the root, then the bones of :bonedata
  Vec3 root_position = Vec3::Zero();
  double length_unit = 1.0;
  double radians_per_unit = radians_per_degree;
};

/// Reads an ASF text to its end. Every bone of :bonedata must have a name, direction, length and
/// axis, and at most one parent. Throws mien::Error.
AsfFile parse_asf_file(TextCursor& cursor);

}  // namespace mien::motion

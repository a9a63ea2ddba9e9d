#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "motion/math/geometry.h"

namespace mien::motion {

/// A joint and its position relative to its parent.
struct Joint {
  std::string name;
  int parent = -1;             ///< index of the parent joint, −1 for the root
  Vec3 offset = Vec3::Zero();  ///< position in the parent's frame at rest
  std::optional<Vec3> tip;     ///< end of the last bone (BVH "End Site"), in this joint's frame
};

/// A tree of joints. Parents come before their children; joint 0 is the root.
struct Skeleton {
  std::vector<Joint> joints;

  int size() const { return static_cast<int>(joints.size()); }
};

/// Index of the joint of that name, or −1.
int find_joint(const Skeleton& skeleton, std::string_view name);

/// Children of each joint, in skeleton order.
std::vector<std::vector<int>> children_of(const Skeleton& skeleton);

/// Whether every parent index points to an earlier joint and only joint 0 is a root.
bool is_well_formed(const Skeleton& skeleton);

/// Whether two skeletons have the same joint names and parents, and the same offsets to a
/// thousandth of their length.
bool same_rig(const Skeleton& a, const Skeleton& b);

}  // namespace mien::motion

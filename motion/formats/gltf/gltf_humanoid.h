#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace mien::motion {

/// A bone of a VRM humanoid: what its node is, whatever the node is called.
struct HumanBone {
  std::string name;  ///< "hips", "leftUpperArm", … (VRM specification)
  int node = 0;
};

/// The bones that a glTF document names by `VRMC_vrm_animation` (VRM animations, .vrma), `VRMC_vrm`
/// (VRM 1.0) or `VRM` (VRM 0.x, whose figures face −Z); empty if it has none of these. Each has a
/// name and a node of its own, from 0 to `nodes` − 1. Throws mien::Error naming the file otherwise.
std::vector<HumanBone> human_bones(const nlohmann::json& document, size_t nodes,
                                   const std::string& name);

}  // namespace mien::motion

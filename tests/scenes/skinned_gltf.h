#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "motion/skeleton/body.h"
#include "motion/skeleton/pose.h"

namespace mien::test {

/// A skinned glTF figure for tests: a box round each bone of the canonical body, which may have
/// fingers (motion::with_fingers), and follows its joint alone. Change `json` to break it.
struct SkinnedGltf {
  nlohmann::json json;
  std::vector<unsigned char> buffer;
  motion::JointTransforms bind;  ///< of the body's joints, metres, +Y up

  /// The file, buffer and all.
  std::string text() const;
};

struct SkinnedGltfOptions {
  motion::Pose bind;               ///< of the body; empty: a T-pose
  std::vector<std::string> names;  ///< of the nodes; empty: none
  double unit = 1.0;               ///< the file's lengths are metres times this
  bool z_up = false;
  bool posed_nodes = true;  ///< nodes stand in the bind pose; else arms and legs are turned somehow
};

SkinnedGltf skinned_gltf(const motion::Skeleton& body, const SkinnedGltfOptions& options);

/// Gives the figure two morph targets, "one" and "other", which double its size, and two animations
/// of one second: in "Rise" the weight of "one" goes from 0 to 1, in "Fall" from 1 to 0.
void add_face(SkinnedGltf& file);

std::vector<std::string> mixamo_names();
std::vector<std::string> vrm_names();
std::vector<std::string> smpl_names();

/// The spellings of finger joints in rigs.
enum class FingerNaming { mixamo, vrm, smpl };

/// Names of the body's joints, and of those of its hands.
std::vector<std::string> with_finger_names(std::vector<std::string> body, FingerNaming naming);

/// A picture of 2 × 1 pixels, red and green, as a data URI.
std::string two_pixels();

/// A WebP picture of 16 × 8 pixels, its left half red and its right half green, as a data URI.
std::string webp_halves();

}  // namespace mien::test

// Any bytes are a sound character, or are refused: FBX if they begin as such a file, else glTF.

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "motion/error.h"
#include "motion/formats/fbx/fbx_document.h"
#include "scenes/character/character.h"

using namespace mien::scenes;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const std::string_view file(reinterpret_cast<const char*>(bytes), size);
  const bool is_fbx = mien::motion::is_binary_fbx(file) || file.starts_with(';');
  try {
    const Character character = parse_character(file, is_fbx ? "fuzz.fbx" : "fuzz.gltf");
    mien::motion::Pose pose;
    pose.rotations.assign(character.body.joints.size(), mien::motion::Quat::Identity());
    mien::render::Scene scene;
    scene.materials.push_back({});
    // Half of each morph target.
    const std::vector<double> weights(static_cast<std::size_t>(character.face.morph_count), 0.5);
    add_character(scene, character, pose, weights);
    mien::render::validate(scene);
  } catch (const mien::Error&) {
  }
  return 0;
}

// Any bytes are a sound character, or are refused.

#include <cstddef>
#include <cstdint>

#include "motion/error.h"
#include "scenes/character/character.h"

using namespace mien::scenes;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  try {
    const Character character =
        parse_character({reinterpret_cast<const char*>(bytes), size}, "fuzz.gltf");
    mien::motion::Pose pose;
    pose.rotations.assign(character.body.joints.size(), mien::motion::Quat::Identity());
    mien::render::Scene scene;
    scene.materials.push_back({});
    add_character(scene, character, pose);
    mien::render::validate(scene);
  } catch (const mien::Error&) {
  }
  return 0;
}

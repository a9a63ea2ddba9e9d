// Any bytes are a sound FBX figure with meshes that can be posed, or are refused.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "motion/error.h"
#include "motion/formats/fbx/fbx.h"
#include "motion/formats/fbx/fbx_mesh.h"
#include "motion/random_recording.h"

using namespace mien::motion;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const std::string_view file(reinterpret_cast<const char*>(bytes), size);
  try {
    if (!mien::test::is_sound(parse_fbx(file, "fuzz.fbx"))) std::abort();
  } catch (const mien::Error&) {
  }
  try {
    const FbxScene scene = parse_fbx_scene(file, "fuzz.fbx");
    const std::vector<FbxPlace> places = places_of(scene, at_rest(scene));
    for (const FbxMesh& mesh : fbx_meshes(scene)) {
      if (posed_vertices(mesh, places).size() != mesh.positions.size()) std::abort();
    }
  } catch (const mien::Error&) {
  }
  return 0;
}

// Any bytes are a sound glTF figure, which can be written and read again, or are refused.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "motion/error.h"
#include "motion/gltf.h"
#include "motion/random_recording.h"

using namespace mien::motion;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  Recording recording;
  try {
    recording = parse_gltf({reinterpret_cast<const char*>(bytes), size}, "fuzz.gltf");
  } catch (const mien::Error&) {
    return 0;
  }
  if (!mien::test::is_sound(recording)) std::abort();
  const Recording again = parse_gltf(to_glb(recording), "again.glb");
  if (again.skeleton.size() != recording.skeleton.size()) std::abort();
  return 0;
}

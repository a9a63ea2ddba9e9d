// Any bytes are a sound glTF figure, which can be written and read again, or are refused.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "motion/error.h"
#include "motion/formats/gltf/gltf.h"
#include "motion/random_recording.h"

using namespace mien::motion;

namespace {

/// Whether rounding to 32-bit floats cannot take the recording over a limit of the reader.
bool is_usual(const Recording& recording) {
  double reach = 0.0;
  for (const Joint& joint : recording.skeleton.joints) {
    reach += joint.offset.norm() + (joint.tip ? joint.tip->norm() : 0.0);
  }
  for (const Pose& pose : recording.poses) {
    reach = std::max(reach, pose.root_position.norm());
    for (const Vec3& offset : pose.offsets) reach = std::max(reach, offset.norm());
  }
  return reach < 1e6 && recording.frame_count() / recording.frames_per_second < 3000.0;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  Recording recording;
  try {
    recording = parse_gltf({reinterpret_cast<const char*>(bytes), size}, "fuzz.gltf");
  } catch (const mien::Error&) {
    return 0;
  }
  if (!mien::test::is_sound(recording)) std::abort();
  if (!is_usual(recording)) return 0;
  const Recording again = parse_gltf(to_glb(recording), "again.glb");
  if (again.skeleton.size() != recording.skeleton.size()) std::abort();
  return 0;
}

// Any text is a sound MVNX motion or is refused.

#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "motion/error.h"
#include "motion/formats/mvnx/mvnx.h"

using namespace mien::motion;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  Recording recording;
  try {
    recording = parse_mvnx({reinterpret_cast<const char*>(bytes), size}, "fuzz.mvnx");
  } catch (const mien::Error&) {
    return 0;
  }
  if (!is_well_formed(recording.skeleton) || recording.poses.empty()) std::abort();
  for (const Pose& pose : recording.poses) {
    if (pose.rotations.size() != recording.skeleton.joints.size()) std::abort();
    if (!pose.root_position.allFinite()) std::abort();
  }
  return 0;
}

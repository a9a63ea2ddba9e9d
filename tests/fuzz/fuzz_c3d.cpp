// Any bytes are sound points over time, or a sound motion of segments, or are refused.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "motion/error.h"
#include "motion/formats/c3d/c3d.h"

using namespace mien::motion;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const std::string_view file(reinterpret_cast<const char*>(bytes), size);
  try {
    if (holds_c3d_rotations(file)) {
      const Recording recording = parse_c3d_rotations(file, "fuzz.c3d");
      if (!is_well_formed(recording.skeleton) || recording.poses.empty()) std::abort();
      return 0;
    }
    const PointRecording recording = parse_c3d(file, "fuzz.c3d");
    if (recording.frame_count() == 0 || recording.seen.size() != recording.positions.size())
      std::abort();
    for (const Vec3& position : recording.positions) {
      if (!position.allFinite()) std::abort();
    }
  } catch (const mien::Error&) {
    return 0;
  }
  return 0;
}

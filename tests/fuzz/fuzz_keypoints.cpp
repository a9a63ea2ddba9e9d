// Any text is keypoints of a person, or is refused.

#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "motion/error.h"
#include "motion/formats/keypoints/keypoints.h"

using namespace mien::motion;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  ReadOptions options;
  options.frames_per_second = 30.0;
  try {
    const PointRecording recording =
        parse_keypoints({reinterpret_cast<const char*>(bytes), size}, "fuzz.json", options);
    if (recording.frame_count() < 1 || recording.positions.size() != recording.seen.size())
      std::abort();
  } catch (const mien::Error&) {
  }
  return 0;
}

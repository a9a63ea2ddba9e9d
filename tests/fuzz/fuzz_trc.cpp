// Any text is sound points over time, which can be written and read again, or is refused.

#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "motion/error.h"
#include "motion/formats/trc/trc.h"

using namespace mien::motion;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  PointRecording recording;
  try {
    recording = parse_trc({reinterpret_cast<const char*>(bytes), size}, "fuzz.trc");
  } catch (const mien::Error&) {
    return 0;
  }
  if (recording.frame_count() == 0 || recording.seen.size() != recording.positions.size())
    std::abort();
  recording.metres_per_unit = 0.001;
  const PointRecording again = parse_trc(to_trc(recording), "again.trc");
  if (again.seen != recording.seen || again.points.size() != recording.points.size()) std::abort();
  return 0;
}

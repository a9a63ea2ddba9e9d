// Any text is a sound BVH motion, which can be written and read again, or is refused.

#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "motion/error.h"
#include "motion/formats/bvh/bvh.h"
#include "motion/random_recording.h"

using namespace mien::motion;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  Recording recording;
  try {
    recording = parse_bvh({reinterpret_cast<const char*>(bytes), size}, "fuzz.bvh");
  } catch (const mien::Error&) {
    return 0;
  }
  if (!is_well_formed(recording.skeleton) || recording.poses.empty()) std::abort();
  // Finite numbers of any size may overflow when they are added up: only usual ones go on.
  if (!mien::test::is_sound(recording)) return 0;
  for (const Vec3& p : world_positions(recording.skeleton, recording.poses[0])) {
    if (p.norm() > 1e6) return 0;
  }
  const Recording again = parse_bvh(to_bvh(recording), "again.bvh");
  if (again.skeleton.size() != recording.skeleton.size()) std::abort();
  if (again.frame_count() != recording.frame_count()) std::abort();
  return 0;
}

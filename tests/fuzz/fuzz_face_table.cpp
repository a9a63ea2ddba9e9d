// Any text is a table of facial weights from 0 to 1 at increasing times, or is refused.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "motion/error.h"
#include "motion/formats/face/face_table.h"

using namespace mien::motion;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  FaceTrack track;
  try {
    track = parse_face_table({reinterpret_cast<const char*>(bytes), size}, "fuzz.csv", 30.0);
  } catch (const mien::Error&) {
    return 0;
  }
  for (const FaceCurve& curve : track) {
    if (curve.times.empty() || curve.times.size() != curve.values.size()) std::abort();
    if (curve.times.front() != 0.0 || !std::ranges::is_sorted(curve.times)) std::abort();
    const double weight = weight_at(curve, 0.5 * curve.times.back());
    if (!(weight >= 0.0 && weight <= 1.0)) std::abort();
  }
  return 0;
}

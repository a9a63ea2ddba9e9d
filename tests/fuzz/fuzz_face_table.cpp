// Any text is a table of facial weights from 0 to 1 at increasing times, or is refused.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string_view>

#include "motion/error.h"
#include "motion/formats/face/face_table.h"

using namespace mien::motion;

namespace {

/// Tables of seconds are read without a rate of frames, those that count frames with one.
void read(std::string_view text, std::optional<double> frames_per_second) {
  FaceTrack track;
  try {
    track = parse_face_table(text, "fuzz.csv", frames_per_second);
  } catch (const mien::Error&) {
    return;
  }
  for (const FaceCurve& curve : track) {
    if (curve.times.empty() || curve.times.size() != curve.values.size()) std::abort();
    if (curve.times.front() != 0.0 || !std::ranges::is_sorted(curve.times)) std::abort();
    const double weight = weight_at(curve, 0.5 * curve.times.back());
    if (!(weight >= 0.0 && weight <= 1.0)) std::abort();
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(bytes), size);
  read(text, std::nullopt);
  read(text, 30.0);
  return 0;
}

// Any three texts are a BIDS motion recording (table, channels and sidecar) or are refused. The
// input holds them in this order, with a line "====" between two.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "motion/error.h"
#include "motion/formats/table/bids_motion.h"

using namespace mien::motion;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  constexpr std::string_view separator = "\n====\n";
  std::string_view rest(reinterpret_cast<const char*>(bytes), size);
  std::array<std::string_view, 3> texts;
  for (std::string_view& text : texts) {
    text = rest.substr(0, rest.find(separator));
    rest.remove_prefix(std::min(rest.size(), text.size() + separator.size()));
  }
  try {
    const PointRecording recording = parse_bids_motion(
        {texts[0], "fuzz_motion.tsv", texts[1], "fuzz_channels.tsv", texts[2], "fuzz_motion.json"});
    if (recording.frame_count() < 1 || recording.positions.size() != recording.seen.size())
      std::abort();
    for (const Vec3& position : recording.positions) {
      if (!position.allFinite()) std::abort();
    }
  } catch (const mien::Error&) {
  }
  return 0;
}

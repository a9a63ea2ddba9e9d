// Any two texts are a sound Acclaim motion with its skeleton or are refused. The input holds both,
// the skeleton first, with a line "====" between them.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "motion/error.h"
#include "motion/formats/acclaim/acclaim.h"

using namespace mien::motion;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  constexpr std::string_view separator = "\n====\n";
  const std::string_view text(reinterpret_cast<const char*>(bytes), size);
  const std::size_t end = text.find(separator);
  const std::string_view asf = text.substr(0, end);
  const std::string_view amc =
      end == std::string_view::npos ? std::string_view{} : text.substr(end + separator.size());
  try {
    const Recording recording = parse_amc({amc, "fuzz.amc"}, {asf, "fuzz.asf"});
    if (!is_well_formed(recording.skeleton) || recording.poses.empty()) std::abort();
    for (const Pose& pose : recording.poses) {
      if (pose.rotations.size() != recording.skeleton.joints.size()) std::abort();
    }
  } catch (const mien::Error&) {
    return 0;
  }
  return 0;
}

// Any bytes are sound arrays and motions of .npy and .npz files, or are refused.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "motion/error.h"
#include "motion/formats/numpy/npy_positions.h"
#include "motion/formats/smpl/smpl.h"
#include "motion/random_recording.h"

using namespace mien::motion;

namespace {

template <typename Read>
void try_to_read(Read read) {
  try {
    read();
  } catch (const mien::Error&) {
  }
}

void check(const PointRecording& recording) {
  const bool is_whole = recording.positions.size() == recording.seen.size() &&
                        recording.frame_count() > 0 &&
                        recording.positions.size() % recording.points.size() == 0;
  if (!is_whole) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const std::string_view file{reinterpret_cast<const char*>(bytes), size};
  ReadOptions options;
  options.frames_per_second = 30.0;
  for (const ReadOptions& some : {options, ReadOptions()}) {
    try_to_read([&] {
      if (!mien::test::is_sound(parse_smpl(file, "fuzz.npz", some))) std::abort();
    });
    try_to_read([&] { check(parse_smpl_markers(file, "fuzz.npz", some)); });
    try_to_read([&] { check(parse_npy_positions(file, "fuzz.npy", some)); });
  }
  return 0;
}

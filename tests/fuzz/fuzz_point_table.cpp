// Any text is a table of points, which can be written and read again, or is refused.

#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "motion/error.h"
#include "motion/formats/table/bids_motion.h"
#include "motion/formats/table/point_table.h"
#include "motion/formats/table/tidy_csv.h"

using namespace mien::motion;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  ReadOptions options;
  options.frames_per_second = 50.0;
  PointRecording recording;
  try {
    recording =
        parse_point_table({reinterpret_cast<const char*>(bytes), size}, "fuzz.csv", options);
  } catch (const mien::Error&) {
    return 0;
  }
  if (recording.frame_count() < 1 || recording.positions.size() != recording.seen.size())
    std::abort();
  if (recording.positions.size() > 100'000) return 0;
  for (const std::string& point : recording.points)
    if (point.find('\0') != std::string::npos) return 0;
  const PointRecording again = parse_point_table(to_tidy_csv(recording), "again.csv", options);
  if (again.frame_count() != recording.frame_count()) std::abort();
  const auto files = to_bids_motion(recording);
  const PointRecording bids = parse_bids_motion({files[0].second, files[0].first, files[1].second,
                                                 files[1].first, files[2].second, files[2].first});
  if (bids.point_count() != recording.point_count()) std::abort();
  return 0;
}

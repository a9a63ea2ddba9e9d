#include "motion/formats/c3d/c3d_points.h"

#include <cmath>

#include "motion/error.h"

namespace mien::motion {

namespace {

constexpr double largest_position = 1e12;

/// A value of the data section; `is_real` decides between floats and integers.
template <C3dProcessor processor, bool is_real>
double value_at(const char* at) {
  if constexpr (is_real) return c3d_real<processor>(at);
  return static_cast<std::int16_t>(c3d_word<processor>(at));
}

/// Returns how many points were exactly at the origin without being marked as missing.
template <C3dProcessor processor, bool is_real>
std::size_t read_points(const C3dFile& file, const C3dLayout& layout,
                        std::span<const std::size_t> columns, PointRecording& recording) {
  constexpr std::size_t size = is_real ? 4 : 2;
  std::size_t at_origin = 0;
  std::size_t index = 0;
  for (std::size_t frame = 0; frame < layout.frames; ++frame) {
    const std::size_t start = layout.start + frame * layout.frame_bytes();
    for (const std::size_t column : columns) {
      const std::size_t byte = start + 4 * size * column;
      const char* at = file.bytes.data() + byte;
      const Vec3 position = layout.scale * Vec3(value_at<processor, is_real>(at),
                                                value_at<processor, is_real>(at + size),
                                                value_at<processor, is_real>(at + 2 * size));
      const double mark = value_at<processor, is_real>(at + 3 * size);
      const bool is_marked = std::isnan(mark) || mark < 0.0;
      const bool is_origin = position == Vec3::Zero();
      const std::size_t i = index++;
      if (is_marked || is_origin || !position.allFinite()) {
        if (is_origin && !is_marked) ++at_origin;
        continue;
      }
      if (!(position.cwiseAbs().maxCoeff() < largest_position)) {
        fail_c3d(file, byte, "a point is too far away for any motion",
                 "obtain the file again, or export it again");
      }
      recording.positions[i] = position;
      recording.seen[i] = true;
    }
  }
  return at_origin;
}

template <C3dProcessor processor>
std::size_t read_points(const C3dFile& file, const C3dLayout& layout,
                        std::span<const std::size_t> columns, PointRecording& recording) {
  return layout.is_real ? read_points<processor, true>(file, layout, columns, recording)
                        : read_points<processor, false>(file, layout, columns, recording);
}

}  // namespace

void read_c3d_points(const C3dFile& file, const C3dLayout& layout,
                     std::span<const std::size_t> columns, PointRecording& recording) {
  recording.positions.assign(layout.frames * columns.size(), Vec3::Zero());
  recording.seen.assign(layout.frames * columns.size(), false);
  std::size_t at_origin = 0;
  switch (file.processor) {
    case C3dProcessor::intel:
      at_origin = read_points<C3dProcessor::intel>(file, layout, columns, recording);
      break;
    case C3dProcessor::dec:
      at_origin = read_points<C3dProcessor::dec>(file, layout, columns, recording);
      break;
    case C3dProcessor::mips:
      at_origin = read_points<C3dProcessor::mips>(file, layout, columns, recording);
      break;
  }
  if (at_origin == 0) return;
  recording.notes.push_back(
      (at_origin == 1 ? "1 position" : std::to_string(at_origin) + " positions") +
      " of exactly 0 0 0 that the file does not mark as missing " +
      (at_origin == 1 ? "counts" : "count") + " as missing.");
}

}  // namespace mien::motion

#include "motion/points/kept_points.h"

#include <string>
#include <utility>

namespace mien::motion {

void keep_points(PointRecording& recording, const std::vector<std::size_t>& kept) {
  const auto frames = static_cast<std::size_t>(recording.frame_count());
  const std::size_t before = recording.points.size();
  std::vector<Vec3> positions(frames * kept.size());
  std::vector<bool> seen(frames * kept.size());
  for (std::size_t f = 0; f < frames; ++f) {
    for (std::size_t k = 0; k < kept.size(); ++k) {
      positions[f * kept.size() + k] = recording.positions[f * before + kept[k]];
      seen[f * kept.size() + k] = recording.seen[f * before + kept[k]];
    }
  }
  std::vector<std::string> names;
  for (const std::size_t k : kept) names.push_back(std::move(recording.points[k]));
  recording.points = std::move(names);
  recording.positions = std::move(positions);
  recording.seen = std::move(seen);
}

}  // namespace mien::motion

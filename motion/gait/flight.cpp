#include "motion/gait/flight.h"

#include <algorithm>
#include <cmath>

namespace mien::motion {

namespace {

constexpr double shortest_seconds = 0.06;
constexpr double beside_seconds = 0.4;
constexpr double tellable_seconds = 0.25;  // over which noise hides no fall
constexpr double least_fall = -4.0;        // m/s²

double mean_pelvis_height(const Clip& clip, int first, int last) {
  first = std::max(first, 0);
  last = std::min(last, clip.frame_count() - 1);
  double sum = 0.0;
  for (int t = first; t <= last; ++t) sum += clip.poses[t].root_position.y();
  return sum / (last - first + 1);
}

/// Whether the pelvis falls through a long gap between plants. In one that it does not, a foot
/// slides or is too short on the floor to be seen.
bool falls(const Clip& clip, int first, int last) {
  const double seconds = (last - first + 2) / clip.frames_per_second;
  if (seconds < tellable_seconds) return true;
  const auto height = [&](int frame) {
    return clip.poses[std::clamp(frame, 0, clip.frame_count() - 1)].root_position.y();
  };
  const double bend = height(first - 1) - 2.0 * height((first + last) / 2) + height(last + 1);
  return bend / (0.25 * seconds * seconds) < least_fall;
}

/// The plant that ends latest before `frame`; null when there is none.
const FootPlant* last_before(const std::vector<FootPlant>& plants, int frame) {
  const FootPlant* latest = nullptr;
  for (const FootPlant& plant : plants) {
    if (plant.last < frame && (!latest || plant.last > latest->last)) latest = &plant;
  }
  return latest;
}

bool touches(const std::vector<FootPlant>& plants, int frame) {
  return std::any_of(plants.begin(), plants.end(), [frame](const FootPlant& plant) {
    return plant.first <= frame && frame <= plant.last;
  });
}

}  // namespace

std::vector<Flight> flights(const Clip& clip, const std::vector<FootPlant>& plants) {
  const double rate = clip.frames_per_second;
  const auto beside = static_cast<int>(std::lround(beside_seconds * rate));
  std::vector<Flight> found;
  for (const FootPlant& landing : plants) {
    const FootPlant* take_off = last_before(plants, landing.first);
    if (!take_off || touches(plants, landing.first - 1)) continue;
    const int first = take_off->last + 1;
    const int last = landing.first - 1;
    const bool is_up = mean_pelvis_height(clip, first, last) >
                       mean_pelvis_height(clip, first - beside, last + beside);
    if ((last - first + 1) / rate < shortest_seconds || !is_up) continue;
    if (!falls(clip, first, last)) continue;
    found.push_back({first, last, take_off->left, landing.left});
  }
  return found;
}

}  // namespace mien::motion

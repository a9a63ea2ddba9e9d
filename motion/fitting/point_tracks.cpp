#include "motion/fitting/point_tracks.h"

namespace mien::motion {

Track PointTracks::of_point(int point) const {
  Track track(frame_count());
  for (int frame = 0; frame < recording.frame_count(); ++frame) {
    const std::size_t at = recording.at(frame, point);
    if (recording.seen[at]) track[static_cast<std::size_t>(frame)] = recording.positions[at];
  }
  return track;
}

Track PointTracks::of(Landmark landmark, Side side) const {
  std::vector<Track> tracks;
  for (const int point : set.points_of(landmark, side)) {
    Track track = of_point(point);
    if (is_known(track)) tracks.push_back(std::move(track));
  }
  if (tracks.empty()) return Track(frame_count());
  Track sum = tracks.front();
  for (std::size_t i = 1; i < tracks.size(); ++i) {
    sum = combined([](const Vec3& p, const Vec3& q) { return Vec3(p + q); }, sum, tracks[i]);
  }
  const double count = static_cast<double>(tracks.size());
  return combined([&](const Vec3& p) { return Vec3(p / count); }, sum);
}

}  // namespace mien::motion

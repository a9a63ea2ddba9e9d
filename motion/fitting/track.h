#pragma once

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "motion/math/geometry.h"
#include "motion/math/percentile.h"

namespace mien::motion {

/// A position (metres, world space) or unit direction in each frame; none where it is unknown.
using Track = std::vector<std::optional<Vec3>>;

/// Whether the track is known in any frame.
inline bool is_known(const Track& track) {
  for (const auto& value : track) {
    if (value) return true;
  }
  return false;
}

/// The function of several tracks in each frame in which all of them are known.
template <class Function, class... Tracks>
Track combined(Function function, const Track& first, const Tracks&... others) {
  Track result(first.size());
  for (std::size_t frame = 0; frame < first.size(); ++frame) {
    if (first[frame] && (others[frame] && ...)) {
      result[frame] = Vec3(function(*first[frame], *others[frame]...));
    }
  }
  return result;
}

inline Track middle_of(const Track& a, const Track& b) {
  return combined([](const Vec3& p, const Vec3& q) { return Vec3(0.5 * (p + q)); }, a, b);
}

/// The unit vector from one track to another; unknown where they coincide.
inline Track direction(const Track& from, const Track& to) {
  Track result(from.size());
  for (std::size_t frame = 0; frame < from.size(); ++frame) {
    if (!from[frame] || !to[frame]) continue;
    const Vec3 way = *to[frame] - *from[frame];
    if (way.norm() > 1e-6) result[frame] = way.normalized();
  }
  return result;
}

/// The track plus `metres` along a direction.
inline Track shifted(const Track& track, const Track& along, double metres) {
  return combined([&](const Vec3& p, const Vec3& d) { return Vec3(p + metres * d); }, track, along);
}

/// The first of two tracks where it is known, otherwise the second.
inline Track first_known(Track first, const Track& second) {
  for (std::size_t frame = 0; frame < first.size(); ++frame) {
    if (!first[frame]) first[frame] = second[frame];
  }
  return first;
}

/// Median distance in the frames in which both are known; none if there are none.
inline std::optional<double> median_distance(const Track& a, const Track& b) {
  std::vector<double> distances;
  for (std::size_t frame = 0; frame < a.size(); ++frame) {
    if (a[frame] && b[frame]) distances.push_back((*a[frame] - *b[frame]).norm());
  }
  if (distances.empty()) return std::nullopt;
  return percentile(distances, 50.0);
}

/// Median of each coordinate; none if the track is unknown.
inline std::optional<Vec3> median_of(const Track& track) {
  std::vector<double> parts[3];
  for (const auto& value : track) {
    if (!value) continue;
    for (int axis = 0; axis < 3; ++axis) parts[axis].push_back((*value)[axis]);
  }
  if (parts[0].empty()) return std::nullopt;
  return Vec3(percentile(parts[0], 50.0), percentile(parts[1], 50.0), percentile(parts[2], 50.0));
}

}  // namespace mien::motion

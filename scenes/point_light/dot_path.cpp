#include "scenes/point_light/dot_path.h"

#include <algorithm>

namespace mien::scenes {

namespace {

using motion::Vec3;

/// The path with `change` done to each of its points.
template <class Change>
DotPath changed(const DotPath& path, Change change) {
  DotPath result;
  result.reserve(path.size());
  std::transform(path.begin(), path.end(), std::back_inserter(result), change);
  return result;
}

}  // namespace

DotPath reversed(const DotPath& path) { return {path.rbegin(), path.rend()}; }

std::vector<PathPlace> places_at_constant_speed(const DotPath& path) {
  std::vector<PathPlace> places(path.size());
  const double length = length_of(path);
  if (length <= 0.0) {
    for (std::size_t f = 0; f < path.size(); ++f) places[f].frame = f;
    return places;
  }
  std::size_t next = 1;
  double before = 0.0;  // arc length up to point next − 1
  const auto steps = static_cast<double>(path.size() - 1);
  for (std::size_t f = 0; f + 1 < path.size(); ++f) {
    const double wanted = length * static_cast<double>(f) / steps;
    double segment = (path[next] - path[next - 1]).norm();
    while (before + segment < wanted && next + 1 < path.size()) {
      before += segment;
      ++next;
      segment = (path[next] - path[next - 1]).norm();
    }
    places[f] = {next - 1, segment > 0.0 ? std::min((wanted - before) / segment, 1.0) : 0.0};
  }
  places.back().frame = path.size() - 1;
  return places;
}

DotPath at_places(const DotPath& path, const std::vector<PathPlace>& places) {
  DotPath result;
  for (const auto& [frame, share] : places) {
    const Vec3& from = path[frame];
    const Vec3& to = path[std::min(frame + 1, path.size() - 1)];
    result.push_back(from + share * (to - from));
  }
  return result;
}

DotPath at_constant_speed(const DotPath& path) {
  return at_places(path, places_at_constant_speed(path));
}

DotPath begun_at(const DotPath& path, int frame) {
  DotPath later = path;
  if (path.empty()) return later;
  const auto count = static_cast<int>(path.size());
  const int first = ((frame % count) + count) % count;
  std::rotate(later.begin(), later.begin() + first, later.end());
  return later;
}

DotPath without_travel(const DotPath& path, const Vec3& step) { return with_travel(path, -step); }

DotPath with_travel(const DotPath& path, const Vec3& step) {
  double frame = 0.0;
  return changed(path, [&](const Vec3& point) -> Vec3 { return point + frame++ * step; });
}

DotPath shifted(const DotPath& path, const Vec3& shift) {
  return changed(path, [&](const Vec3& point) -> Vec3 { return point + shift; });
}

DotPath mirrored(const DotPath& path, const Vec3& centre, const Vec3& across) {
  return changed(path, [&](const Vec3& point) -> Vec3 {
    return point - 2.0 * (point - centre).dot(across) * across;
  });
}

DotPath inverted(const DotPath& path, double height) {
  return changed(path, [&](const Vec3& point) {
    return Vec3(point.x(), 2.0 * height - point.y(), point.z());
  });
}

DotPath rotated(const DotPath& path, const Vec3& centre, double degrees) {
  const motion::Quat turn(Eigen::AngleAxisd(degrees * motion::radians_per_degree, Vec3::UnitY()));
  return changed(path, [&](const Vec3& point) -> Vec3 { return centre + turn * (point - centre); });
}

double length_of(const DotPath& path) {
  double length = 0.0;
  for (std::size_t f = 1; f < path.size(); ++f) length += (path[f] - path[f - 1]).norm();
  return length;
}

}  // namespace mien::scenes

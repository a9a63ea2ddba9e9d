#include "motion/skeleton/markers.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <string_view>
#include <utility>

namespace mien::motion {

namespace {

/// A mark of one side at the beginning or the end of a name, and that of the other side.
constexpr std::array<std::pair<std::string_view, std::string_view>, 8> side_marks = {
    {{"Left", "Right"},
     {"left", "right"},
     {"L", "R"},
     {"l", "r"},
     {"Right", "Left"},
     {"right", "left"},
     {"R", "L"},
     {"r", "l"}}};

/// The index of a name, or −1.
int index_of(const std::vector<std::string>& names, std::string_view name) {
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? -1 : static_cast<int>(found - names.begin());
}

/// The index of the name with its side exchanged, or −1.
int opposite_of(const std::string& name, const std::vector<std::string>& names) {
  for (const auto& [side, other] : side_marks) {
    if (name.starts_with(side)) {
      const int found = index_of(names, std::string(other) + name.substr(side.size()));
      if (found >= 0) return found;
    }
    if (name.ends_with(side)) {
      const int found =
          index_of(names, name.substr(0, name.size() - side.size()) + std::string(other));
      if (found >= 0) return found;
    }
  }
  return -1;
}

}  // namespace

std::vector<int> opposite_points(const std::vector<std::string>& points) {
  std::vector<int> opposite;
  for (std::size_t p = 0; p < points.size(); ++p) {
    const int found = opposite_of(points[p], points);
    // Only pairs that choose each other, so that no point is shown twice and none is lost.
    const bool is_pair = found >= 0 && opposite_of(points[static_cast<std::size_t>(found)],
                                                   points) == static_cast<int>(p);
    opposite.push_back(is_pair ? found : static_cast<int>(p));
  }
  return opposite;
}

Markers with_sides_exchanged(const Markers& markers) {
  const std::vector<int> opposite = opposite_points(markers.points);
  Markers exchanged = markers;
  for (int frame = 0; frame < markers.frame_count(); ++frame) {
    for (int point = 0; point < markers.point_count(); ++point) {
      const std::size_t to = markers.at(frame, point);
      const std::size_t from = markers.at(frame, opposite[static_cast<std::size_t>(point)]);
      exchanged.positions[to] = markers.positions[from];
      exchanged.seen[to] = markers.seen[from];
      exchanged.filled[to] = markers.filled[from];
    }
  }
  return exchanged;
}

std::vector<Vec3> bridged(std::vector<Vec3> path, const std::vector<bool>& known) {
  assert(path.size() == known.size());
  const auto first = std::find(known.begin(), known.end(), true);
  assert(first != known.end());
  auto last = static_cast<std::size_t>(first - known.begin());
  std::fill_n(path.begin(), last, path[last]);
  for (std::size_t f = last + 1; f < path.size(); ++f) {
    if (!known[f]) continue;
    for (std::size_t between = last + 1; between < f; ++between) {
      const double share = static_cast<double>(between - last) / static_cast<double>(f - last);
      path[between] = (1.0 - share) * path[last] + share * path[f];
    }
    last = f;
  }
  std::fill(path.begin() + static_cast<std::ptrdiff_t>(last), path.end(), Vec3(path[last]));
  return path;
}

}  // namespace mien::motion

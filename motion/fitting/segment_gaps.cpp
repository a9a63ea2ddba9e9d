#include "motion/fitting/segment_gaps.h"

#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "motion/fitting/attachments.h"
#include "motion/fitting/rigid_placement.h"

namespace mien::motion {

namespace {

constexpr double most_deviation = 0.020;  // metres, root mean square

using Shape = std::vector<std::optional<Vec3>>;  ///< of a segment's points, in their order

Shape points_in(const PointRecording& recording, int frame, const std::vector<int>& segment) {
  Shape shape;
  for (const int point : segment) {
    const std::size_t at = recording.at(frame, point);
    shape.push_back(recording.seen[at] ? std::optional(recording.positions[at]) : std::nullopt);
  }
  return shape;
}

int count_of(const Shape& shape) {
  int count = 0;
  for (const auto& point : shape) count += point.has_value();
  return count;
}

/// The placement that takes the points known in both shapes from one to the other; none if it would
/// leave them too far apart.
std::optional<Placement> placement_between(const Shape& from, const Shape& to) {
  std::vector<Vec3> start;
  std::vector<Vec3> end;
  for (std::size_t i = 0; i < from.size(); ++i) {
    if (!from[i] || !to[i]) continue;
    start.push_back(*from[i]);
    end.push_back(*to[i]);
  }
  std::optional<Placement> placement = rigid_placement(start, end);
  if (!placement) return std::nullopt;
  double square = 0.0;
  for (std::size_t i = 0; i < start.size(); ++i) {
    square += (*placement * start[i] - end[i]).squaredNorm();
  }
  const double deviation = std::sqrt(square / static_cast<double>(start.size()));
  return deviation <= most_deviation ? placement : std::nullopt;
}

/// The first frame's points among those with the most.
Shape fullest_shape(const PointRecording& recording, const std::vector<int>& segment) {
  Shape fullest(segment.size());
  for (int frame = 0; frame < recording.frame_count(); ++frame) {
    Shape shape = points_in(recording, frame, segment);
    if (count_of(shape) > count_of(fullest)) fullest = std::move(shape);
  }
  return fullest;
}

/// The mean shape over the frames, placed as in the fullest one.
Shape mean_shape(const PointRecording& recording, const std::vector<int>& segment) {
  const Shape fullest = fullest_shape(recording, segment);
  std::vector<Vec3> sums(segment.size(), Vec3::Zero());
  std::vector<int> counts(segment.size(), 0);
  for (int frame = 0; frame < recording.frame_count(); ++frame) {
    const Shape shape = points_in(recording, frame, segment);
    const std::optional<Placement> placement = placement_between(shape, fullest);
    if (!placement) continue;
    for (std::size_t i = 0; i < shape.size(); ++i) {
      if (!shape[i]) continue;
      sums[i] += *placement * *shape[i];
      ++counts[i];
    }
  }
  Shape mean(segment.size());
  for (std::size_t i = 0; i < mean.size(); ++i) {
    if (counts[i] > 0) mean[i] = Vec3(sums[i] / counts[i]);
  }
  return mean;
}

void complete(PointRecording& recording, const std::vector<int>& segment) {
  const Shape whole = mean_shape(recording, segment);
  for (int frame = 0; frame < recording.frame_count(); ++frame) {
    const Shape shape = points_in(recording, frame, segment);
    if (count_of(shape) == count_of(whole)) continue;
    const std::optional<Placement> placement = placement_between(whole, shape);
    if (!placement) continue;
    for (std::size_t i = 0; i < shape.size(); ++i) {
      if (shape[i] || !whole[i]) continue;
      const std::size_t at = recording.at(frame, segment[i]);
      recording.positions[at] = *placement * *whole[i];
      recording.seen[at] = true;
    }
  }
}

}  // namespace

PointRecording with_segments_completed(const PointTracks& points) {
  std::array<std::vector<int>, body_joint_count> segments;
  for (std::size_t point = 0; point < points.set.roles.size(); ++point) {
    if (!points.set.roles[point]) continue;
    const std::optional<BodyJoint> segment = rigid_segment_of(*points.set.roles[point]);
    if (segment) segments[*segment].push_back(static_cast<int>(point));
  }
  constexpr std::size_t fewest = 4;  // three to place the segment, one to be placed
  PointRecording completed = points.recording;
  for (const std::vector<int>& segment : segments) {
    if (segment.size() >= fewest) complete(completed, segment);
  }
  return completed;
}

}  // namespace mien::motion

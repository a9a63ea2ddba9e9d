#include "motion/points/joint_points.h"

#include <utility>

#include "motion/points/point_names.h"

namespace mien::motion {

namespace {

void add_markers(const Markers& markers, PointRecording& points) {
  points.points = markers.points;
  points.seen = markers.seen;
  for (std::size_t i = 0; i < markers.positions.size(); ++i)
    points.positions.push_back(markers.seen[i] ? markers.positions[i] : Vec3(Vec3::Zero()));
}

void add_joints(const Recording& recording, PointRecording& points) {
  std::vector<std::string> names;
  for (const Joint& joint : recording.skeleton.joints) names.push_back(joint.name);
  points.points = distinct_point_names(std::move(names), points.notes);
  for (const Pose& pose : recording.poses) {
    const std::vector<Vec3> places = world_positions(recording.skeleton, pose);
    points.positions.insert(points.positions.end(), places.begin(), places.end());
  }
  points.seen.assign(points.positions.size(), true);
}

}  // namespace

PointRecording joint_points(const Recording& recording) {
  PointRecording points;
  points.name = recording.name;
  points.format = recording.format;
  points.frames_per_second = recording.frames_per_second;
  points.metres_per_unit = 1.0;
  points.subjects = recording.subjects;
  points.subject = recording.subject;
  points.notes = recording.notes;
  const bool is_unfitted = recording.markers && recording.skeleton.size() == 1;
  if (is_unfitted) {
    add_markers(*recording.markers, points);
  } else {
    add_joints(recording, points);
  }
  return points;
}

}  // namespace mien::motion

#include "motion/fitting/recorded_points.h"

#include <utility>

#include "motion/error.h"
#include "motion/points/gaps.h"
#include "motion/skeleton/clip_markers.h"

namespace mien::motion {
namespace {

/// The points of all frames of the fitted clip or, without one, of the whole recording.
Markers markers_of_points(const PointRecording& points, const PointAxes& axes,
                          const FittedMotion* fit) {
  const FilledPoints whole = filled(in_metres_y_up(points, axes));
  const int first = fit != nullptr ? fit->first_frame : 0;
  const int count = fit != nullptr ? fit->clip.frame_count() : points.frame_count();
  Markers markers;
  markers.points = points.points;
  for (int frame = first; frame < first + count; ++frame) {
    const double lift =
        fit != nullptr ? fit->raised_by_frame[static_cast<std::size_t>(frame - first)] : 0.0;
    const Vec3 raised = lift * Vec3::UnitY();
    for (int point = 0; point < points.point_count(); ++point) {
      const std::size_t at = points.at(frame, point);
      const bool is_filled = whole.filled[at], is_seen = whole.recording.seen[at] && !is_filled;
      markers.positions.push_back(
          is_seen || is_filled ? Vec3(whole.recording.positions[at] + raised) : Vec3(Vec3::Zero()));
      markers.seen.push_back(is_seen);
      markers.filled.push_back(is_filled);
    }
  }
  return markers;
}

}  // namespace

RecordedPoints recorded_points(const PointRecording& points) {
  if (points.frame_count() == 0)
    throw Error(Place{points.name}, "it holds no points",
                "give a recording of at least one point and frame");
  RecordedPoints result;
  try {
    result.fit = fit_body(points);
  } catch (const Error& error) {
    result.rejection = error.what();
  }
  const PointAxes axes = result.fit ? result.fit->axes : point_axes(points);
  Markers markers = markers_of_points(points, axes, result.fit ? &*result.fit : nullptr);
  Recording& recording = result.recording;
  recording =
      to_recording(result.fit ? result.fit->clip
                              : clip_of_markers(points.name, points.frames_per_second, markers));
  recording.name = points.name;
  recording.format = points.format;
  recording.subjects = points.subjects;
  recording.subject = points.subject;
  recording.notes = points.notes;
  if (result.fit) {
    for (const auto* sentences : {&result.fit->notes, &result.fit->warnings})
      recording.notes.insert(recording.notes.end(), sentences->begin(), sentences->end());
  } else {
    if (!axes.note.empty()) recording.notes.push_back(axes.note);
    recording.notes.push_back("The points cannot be fitted to a body: " + result.rejection);
  }
  recording.markers = std::move(markers);
  return result;
}

}  // namespace mien::motion

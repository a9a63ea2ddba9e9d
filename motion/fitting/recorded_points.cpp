#include "motion/fitting/recorded_points.h"

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "motion/error.h"
#include "motion/points/gaps.h"
#include "motion/points/kept_points.h"
#include "motion/skeleton/clip_markers.h"
#include "motion/text/excerpt.h"

namespace mien::motion {
namespace {

/// The points of all frames of the fitted clip or, without one, of the whole recording.
Markers markers_of_points(const PointRecording& points, const PointAxes& axes,
                          const FittedMotion* fit) {
  const FilledPoints whole = filled(in_metres_y_up(points, axes));
  const int first = fit != nullptr ? fit->first_frame : 0;
  const int count = fit != nullptr ? fit->clip.frame_count() : points.frame_count();
  const Vec3 raised = (fit != nullptr ? fit->raised : 0.0) * Vec3::UnitY();
  Markers markers;
  markers.points = points.points;
  for (int frame = first; frame < first + count; ++frame) {
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

std::string_view person_of(std::string_view point) {
  const std::size_t colon = point.find(':');
  return colon == std::string_view::npos ? std::string_view() : point.substr(0, colon);
}

/// Indices of the points of the person with the most, if those of several people are together.
std::vector<std::size_t> points_of_one_person(const PointRecording& points) {
  if (points.subjects.size() < 2 || !points.subject.empty()) return {};
  std::map<std::string_view, std::vector<std::size_t>> of_person;
  for (std::size_t i = 0; i < points.points.size(); ++i)
    if (const std::string_view person = person_of(points.points[i]); !person.empty())
      of_person[person].push_back(i);
  std::vector<std::size_t> most;
  for (const auto& [person, own] : of_person) {
    const bool is_earlier = !most.empty() && own.front() < most.front();
    if (own.size() > most.size() || (own.size() == most.size() && is_earlier)) most = own;
  }
  return most;
}

/// The body of one of several people; what is told of the points is told of all.
FittedMotion fit_one_person(const PointRecording& points, const std::vector<std::size_t>& own) {
  PointRecording alone = points;
  keep_points(alone, own);
  FittedMotion fit = fit_body(alone);
  std::vector<FittedPoint> all;
  for (const std::string& name : points.points) all.push_back({.name = name});
  for (std::size_t i = 0; i < own.size(); ++i) all[own[i]] = std::move(fit.points[i]);
  fit.points = std::move(all);
  fit.notes.insert(fit.notes.begin(),
                   "The body is that of " + in_quotes(person_of(points.points[own.front()])) +
                       ", one of " + std::to_string(points.subjects.size()) + " people.");
  return fit;
}

}  // namespace

RecordedPoints recorded_points(const PointRecording& points) {
  if (points.frame_count() == 0)
    throw Error(Place{points.name}, "it holds no points",
                "give a recording of at least one point and frame");
  RecordedPoints result;
  try {
    const std::vector<std::size_t> own = points_of_one_person(points);
    result.fit = own.empty() ? fit_body(points) : fit_one_person(points, own);
  } catch (const Error& error) {
    result.rejection = error.what();
  }
  Markers markers = markers_of_points(points, result.fit ? result.fit->axes : point_axes(points),
                                      result.fit ? &*result.fit : nullptr);
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
    recording.notes.push_back("The points cannot be fitted to a body: " + result.rejection);
  }
  recording.markers = std::move(markers);
  return result;
}

}  // namespace mien::motion

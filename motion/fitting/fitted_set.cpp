#include "motion/fitting/fitted_set.h"

#include <utility>

#include "motion/error.h"
#include "motion/text/excerpt.h"

namespace mien::motion {

namespace {

bool is_usable(const MarkerSet& set) { return !set.name.empty() && set.missing_parts.empty(); }

MarkerSet usable_set(const PointRecording& recording) {
  MarkerSet set = recognised_marker_set(recording.points);
  if (set.name.empty()) {
    throw Error(
        Place{recording.name},
        "the points are not a set of markers or joints that is known: " + listed(recording.points),
        points_a_body_needs());
  }
  if (!is_usable(set)) {
    throw Error(Place{recording.name},
                "the points (" + set.name + ") do not show the " + listed(set.missing_parts) +
                    "; found: " + listed(recording.points),
                points_a_body_needs());
  }
  return set;
}

/// The set of the points whose names begin with `subject` and a colon.
MarkerSet set_of_subject(const PointRecording& recording, const std::string& subject) {
  std::vector<std::string> names;
  std::vector<std::size_t> points;
  for (std::size_t point = 0; point < recording.points.size(); ++point) {
    if (!recording.points[point].starts_with(subject + ":")) continue;
    names.push_back(recording.points[point]);
    points.push_back(point);
  }
  MarkerSet set = recognised_marker_set(names);
  std::vector<std::optional<Role>> roles(recording.points.size());
  for (std::size_t i = 0; i < points.size(); ++i) roles[points[i]] = set.roles[i];
  set.roles = std::move(roles);
  return set;
}

}  // namespace

std::string points_a_body_needs() {
  return "a body needs points at the pelvis, knees and ankles of both sides, named as in Plug-in "
         "Gait (LASI, LPSI, LKNE, LANK), IOR, CMU or OpenSim, or joints (LeftHip, LeftKnee, "
         "LeftAnkle); the points can still be shown as they are with `figure: markers`";
}

FittedSet fitted_set(const PointRecording& recording) {
  if (recording.subject.empty() && recording.subjects.size() > 1) {
    for (const std::string& subject : recording.subjects) {
      MarkerSet set = set_of_subject(recording, subject);
      if (is_usable(set)) return {std::move(set), subject};
    }
  }
  return {usable_set(recording), ""};
}

}  // namespace mien::motion

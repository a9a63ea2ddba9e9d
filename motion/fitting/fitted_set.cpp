#include "motion/fitting/fitted_set.h"

#include <optional>
#include <utility>

#include "motion/error.h"
#include "motion/fitting/point_tracks.h"
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

/// Takes its role from a joint of the back that is at the pelvis or at the neck, where bones
/// without length begin in some rigs: it would show no direction of the trunk.
void leave_out_joints_without_bone(const PointRecording& recording, MarkerSet& set) {
  constexpr double least = 0.05;  // of the thigh
  const auto distance = [&](Landmark a, Landmark b, Side side) {
    const PointTracks tracks{recording, set};
    return median_distance(tracks.of(a, side), tracks.of(b, side));
  };
  const auto thigh = distance(Landmark::hip, Landmark::knee, Side::left);
  for (const auto& [joint, end] :
       {std::pair(Landmark::spine, Landmark::pelvis), std::pair(Landmark::chest, Landmark::neck)}) {
    const auto length = distance(joint, end, Side::middle);
    if (!thigh || !length || *length >= least * *thigh) continue;
    for (const int point : set.points_of(joint, Side::middle))
      set.roles[static_cast<std::size_t>(point)].reset();
  }
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
         "LeftAnkle, or as in a rig: LeftUpLeg, LeftLeg, LeftFoot, LeftArm, LeftForeArm); the "
         "points can still be shown as they are with `figure: markers`";
}

FittedSet fitted_set(const PointRecording& recording) {
  if (recording.subject.empty() && recording.subjects.size() > 1) {
    for (const std::string& subject : recording.subjects) {
      MarkerSet set = set_of_subject(recording, subject);
      if (!is_usable(set)) continue;
      leave_out_joints_without_bone(recording, set);
      return {std::move(set), subject};
    }
  }
  MarkerSet set = usable_set(recording);
  leave_out_joints_without_bone(recording, set);
  return {std::move(set), ""};
}

}  // namespace mien::motion

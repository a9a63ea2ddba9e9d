#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "motion/fitting/point_tracks.h"
#include "motion/fitting/track.h"
#include "motion/skeleton/body.h"

namespace mien::motion {

/// Radius of a marker on the skin, metres (those of 14 mm are the most usual).
inline constexpr double marker_radius = 0.007;

/// What the points tell about the body, frame by frame: joint centres and the directions from which
/// rotations follow. World space, metres, +Y up.
struct BodyTracks {
  /// Size of the body relative to a stature of 1.75 m, by the length of the legs.
  double scale = 1.0;
  std::array<Track, body_joint_count> joints;  ///< joint centres
  std::array<Track, body_joint_count> tips;    ///< of the head, the wrists and the toes
  Track pelvis_left;                           ///< to the subject's left, +X at rest
  Track pelvis_up;                             ///< +Y at rest
  Track chest_left;
  Track chest_up;
  /// Of the hips: the axis of the knee, +X at rest. Of the shoulders: that of the elbow towards its
  /// outer side, +Y at rest. Of the elbows: to the thumb's side of the wrist, +Z at rest.
  std::array<Track, body_joint_count> axes;
  std::vector<std::optional<Quat>> head;  ///< world rotation of the head

  std::size_t frame_count() const { return joints[Pelvis].size(); }
};

/// Joint centres from the file come first; those that it lacks are found from other points. These
/// are our decisions where no source is named; all lengths are for a stature of 1.75 m and scale
/// with the legs (hip–knee–ankle 0.85 m):
///
/// - Pelvis: the plane through the front and back iliac spines leans forward at rest as far as
///   makes the pelvis in line with the trunk in most frames, 0–20° (10° without a trunk): markers
///   are placed at heights that differ between laboratories by 10° and more. Hips by Harrington et
///   al. 2007 (hip_centres.h); without points on the back of the pelvis its depth is taken as 0.66
///   of its width. The pelvis joint is 0.03 above the hips.
/// - Knees and ankles: the middle of their outer and inner points; with an outer one only, inwards
///   along the knee's axis (hinge_axis.h) by 7 mm (a marker's radius) and half the joint's width,
///   0.125 (knee) and 0.085 (ankle) of the leg's length. Without such points, by the motion of the
///   markers on both segments (functional_joint.h).
/// - Balls of the feet: the second metatarsal's point, or the middle of the first and fifth, 0.02
///   above the skin; otherwise 3/4 of the way from heel to toe tip.
/// - Neck: midway between the jugular notch and the seventh cervical vertebra and 0.03 higher, or
///   0.06 above the middle of the shoulders. Chest: 0.24 below the neck; spine: 0.11 above the
///   pelvis.
/// - Shoulders: below the acromion by 0.17 of the distance between both (Rab, Petuskey and Bagley
///   2002). Elbows: as knees, half the width 0.135 of the upper arm. Wrists: the middle of both
///   sides.
/// - Head: a rigid head of average shape (head_shape in upper_body_tracks.cpp) is placed on its
///   points.
BodyTracks body_tracks(const PointTracks& points);

}  // namespace mien::motion

#include "motion/fitting/body_tracks.h"

#include "motion/fitting/leg_tracks.h"
#include "motion/fitting/upper_body_tracks.h"

namespace mien::motion {

BodyTracks body_tracks(const PointTracks& points) {
  const Track unknown(points.frame_count());
  BodyTracks body;
  body.joints.fill(unknown);
  body.tips.fill(unknown);
  body.axes.fill(unknown);
  body.pelvis_left = unknown;
  body.pelvis_up = unknown;
  body.chest_left = unknown;
  body.chest_up = unknown;
  body.head.resize(points.frame_count());
  add_pelvis_and_legs(points, body);
  add_upper_body(points, body);
  return body;
}

}  // namespace mien::motion

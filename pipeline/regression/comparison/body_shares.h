#pragma once

#include <string>
#include <vector>

#include "render/image/image.h"
#include "render/scene/camera.h"
#include "scenes/stage/shot.h"

namespace mien::pipeline {

/// The share of a body part in the difference of two pictures.
struct BodyShare {
  std::string part;       ///< "left forearm"; empty: pixels that are not near a moved body part
  double share = 0.0;     ///< share of the squared error of all pixels
  double moved_px = 0.0;  ///< largest displacement in the picture, in pixels
};

/// A body in a picture: the clip, the frame whose joint positions in world space are shown, and the
/// camera.
struct ProjectedBody {
  const motion::Clip& clip;  ///< on the canonical body, as staged
  int frame = 0;
  const render::Camera& camera;
};

/// Splits the difference of two pictures among the moved parts of a body. A pixel is assigned to
/// the nearest projected bone of a moved part, before or now, if that bone is within a distance
/// equivalent to 0.15 m. A part has moved if one of its points, or a virtual point at 0.1 m from it
/// that rotates with it, is displaced by at least 0.05 pixels in the view of the current camera; a
/// shift caused by the camera does not count. Shares are sorted from the largest; the unassigned
/// remainder stands last, without a name. Empty if no pixel differs.
std::vector<BodyShare> body_shares(const render::Image8& picture_before,
                                   const render::Image8& picture_now, const ProjectedBody& before,
                                   const ProjectedBody& now);

}  // namespace mien::pipeline

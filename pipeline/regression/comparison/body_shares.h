#pragma once

#include <string>
#include <vector>

#include "render/image/image.h"
#include "render/scene/camera.h"
#include "scenes/stage/shot.h"

namespace mien::pipeline {

/// How much of what changed in a picture a part of the body explains.
struct BodyShare {
  std::string part;       ///< "left forearm"; empty: nothing of the body that moved is near
  double share = 0.0;     ///< of the squared error of all pixels
  double moved_px = 0.0;  ///< how far it moved in the picture, at most
};

/// A body in a picture: world positions of its joints, and the camera that sees them.
struct ProjectedBody {
  const motion::Clip& clip;  ///< of the canonical body, as it is staged
  int frame = 0;
  const render::Camera& camera;
};

/// Splits the difference of two pictures among the parts of a body that moved: a pixel counts for
/// the nearest bone, where that is (before or now) within 0.15 m of it as the camera sees it and a
/// point of the part, or one 0.1 m beside it that turns with it, moved by a twentieth of a pixel at
/// least before the camera that there is now: what shifts because the camera does has not moved.
/// The largest share first; what is left stands last, without a name. Empty when no pixel differs.
std::vector<BodyShare> body_shares(const render::Image8& picture_before,
                                   const render::Image8& picture_now, const ProjectedBody& before,
                                   const ProjectedBody& now);

}  // namespace mien::pipeline

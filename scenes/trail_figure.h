#pragma once

#include <vector>

#include "render/camera.h"
#include "render/scene.h"
#include "scenes/actor.h"

namespace mien::scenes {

/// A pose of a trail.
struct Ghost {
  int frame = 0;
  float opacity = 1.0f;

  friend bool operator==(const Ghost&, const Ghost&) = default;
};

/// The poses that a trail shows besides the present one, the farthest from it first: those left
/// behind up to now, then onion skin. The farther, the fainter.
std::vector<Ghost> ghosts_at(const TrailOptions& options, int frame, int frame_count,
                             double frames_per_second);

/// Frames of a clip of which a picture with a trail shows the poses, at most.
int most_ghosts(const TrailOptions& options);

/// Appends the actor at a frame, its ghosts, and the traces of its joints up to now. Throws Error
/// for traces of joints that the clip's skeleton does not have.
void add_trail(render::Scene& scene, const Actor& actor, const TrailOptions& options, int frame,
               const render::Camera& camera);

}  // namespace mien::scenes

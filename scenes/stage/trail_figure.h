#pragma once

#include <vector>

#include "render/scene/camera.h"
#include "render/scene/scene.h"
#include "scenes/stage/actor.h"

namespace mien::scenes {

/// An additional pose of a trail.
struct Ghost {
  int frame = 0;
  float opacity = 1.0f;

  friend bool operator==(const Ghost&, const Ghost&) = default;
};

/// The poses that a trail shows besides the present one: first those that have stayed visible so
/// far, then the onion skin, both from the farthest in time to the nearest. No pose occurs twice.
/// Poses farther away in time are fainter, among those that stayed visible and on either side of
/// the onion skin.
std::vector<Ghost> ghosts_at(const TrailOptions& options, int frame, int frame_count,
                             double frames_per_second);

/// Largest number of ghosts in a picture.
int max_ghosts(const TrailOptions& options);

/// The paths of the joints that a trail traces. Throws Error for joints that the clip's skeleton
/// does not have.
std::vector<Dot> traces_of(const motion::Clip& clip, const TrailOptions& options);

/// Appends the actor at a frame, and its ghosts and traces as they are at frame `made_at`.
void add_trail(render::Scene& scene, const Actor& actor, const TrailOptions& options, int frame,
               int made_at, const render::Camera& camera);

}  // namespace mien::scenes

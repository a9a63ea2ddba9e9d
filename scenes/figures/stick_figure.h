#pragma once

#include "motion/skeleton/clip.h"
#include "render/scene/scene.h"
#include "scenes/figures/figure_colour.h"

namespace mien::scenes {

/// Appends a stick figure to a scene: a round cone for each bone and a sphere for each joint, with
/// thickness in proportion to a body of `height_m` metres; a visor shows the facing direction.
/// Hands of a pose with fingers have five, on the bones of the palm; without, a hand is one bone.
///
/// `skeleton` is usually the canonical body, whose left and right limbs get their own shades; any
/// other skeleton, in metres, is drawn in one shade with even thickness and without a visor. Each
/// joint, with the bones that it rotates, is a part of the scene's last figure; fingers are part of
/// their wrist.
void add_stick_figure(render::Scene& scene, const motion::Skeleton& skeleton,
                      const motion::Pose& pose, const FigureColours& colours, double height_m);

}  // namespace mien::scenes

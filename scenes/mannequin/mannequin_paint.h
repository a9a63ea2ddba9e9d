#pragma once

#include <array>
#include <vector>

#include "motion/skeleton/pose.h"
#include "motion/skeleton/skeleton.h"
#include "render/scene/scene.h"
#include "scenes/figures/figure_colour.h"
#include "scenes/skinning/skinned_model.h"

namespace mien::scenes {

/// The texture of a mannequin. u is the side of the body (0 right … 0.5 middle … 1 left), v the
/// depth inside the face (above 0.5) or outside (below). Both change smoothly over the surface, and
/// the texture has sharp borders across them: the borders on the body are clean curves however
/// large its triangles are.
render::Texture mannequin_paint(const FigureColours& colours);

/// The texture coordinates of a vertex in the bind pose.
std::array<float, 2> paint_uv(const motion::Skeleton& body, const motion::JointTransforms& pose,
                              const motion::Vec3& point, const std::vector<Influence>& influences);

}  // namespace mien::scenes

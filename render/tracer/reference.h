#pragma once

#include "render/tracer/prepared_scene.h"
#include "render/tracer/tile.h"

namespace mien::render {

/// Renders the pixels of `part` by camera and shadow rays alone: the reference for the tests of all
/// other rendering (contract.h).
///
/// Each sample is one camera ray. For the point that it hits, one point of each light and one
/// direction of the sky are chosen, and a shadow ray is cast towards each. Nothing is shared
/// between samples or pixels, interpolated, known in closed form or kept from other pictures; the
/// grid of the floor is not filtered: each sample takes the albedo where its ray ends. The
/// background and the masks of the prepared scene are not used.
void draw_reference(const PreparedScene& prepared, const Window& part, const Canvas& canvas);

}  // namespace mien::render

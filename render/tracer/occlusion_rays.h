#pragma once

#include "render/tracer/prepared_scene.h"
#include "render/tracer/shared_occlusion.h"
#include "render/tracer/tile.h"

namespace mien::render {

/// Finds, for tiles in a row, the light that the figure occludes, and sets their rows: on the
/// figure, that of the sky and, with Quality::figure_shares_lights, of the area lights, and on the
/// floor, that of the area lights. One of every Quality::figure_samples_per_ray samples casts rays,
/// or of floor_samples_per_ray where the floor may be shadowed. `band` has all tiles of a row that
/// anything is to be found for.
void find_occlusion_in(const PreparedScene& prepared, const Window& band, SharedOcclusion& shared);

}  // namespace mien::render

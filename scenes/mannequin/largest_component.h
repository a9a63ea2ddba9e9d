#pragma once

#include "scenes/mannequin/surface_nets.h"

namespace mien::scenes {

/// The largest connected component of a surface. Where a shape is thinner than the cells of the
/// grid, its end may become a separate component.
Surface largest_component(Surface surface);

}  // namespace mien::scenes

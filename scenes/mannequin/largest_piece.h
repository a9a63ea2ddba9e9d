#pragma once

#include "scenes/mannequin/surface_nets.h"

namespace mien::scenes {

/// The surface without what is not connected with its largest piece: where something is thinner
/// than the cells of the grid its end comes off as a crumb.
Surface largest_piece(Surface surface);

}  // namespace mien::scenes

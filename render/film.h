#pragma once

#include "render/image.h"

namespace mien::render {

/// What the tracer exposes: linear radiance, Rec.709 primaries, scene-referred (0.18 is mid grey,
/// values above 1 are allowed).
using Film = Image<float>;

}  // namespace mien::render

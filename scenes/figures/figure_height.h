#pragma once

#include "motion/skeleton/clip.h"

namespace mien::scenes {

/// How tall the figure is drawn, metres: the body's stature, or how far any other skeleton reaches
/// from its root at first, and at least 0.2.
double figure_height(const motion::Clip& clip);

}  // namespace mien::scenes

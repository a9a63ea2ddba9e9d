#pragma once

#include <string>

#include "pipeline/manifest.h"
#include "pipeline/motions.h"

namespace mien::pipeline {

/// How large figures come out, a row a stimulus: stimulus, figure_px (height of the standing figure
/// in the middle of the action, as the first picture shows it), visual_degrees (the visual angle
/// under which it is seen on the screen that its camera names; empty without one).
std::string views_csv(const Manifest& manifest, Motions& motions);

}  // namespace mien::pipeline

#pragma once

#include "pipeline/manifest/ratings/scales/scales.h"

namespace mien::pipeline {

/// The six pairs of the emotion thesis, answered on −2 … 2: sad-happy, tired-excited,
/// angry-relaxed, weak-strong, afraid-confident, masculine-feminine. The Japanese is ours.
ScaleSet emotion_scales();

}  // namespace mien::pipeline

#pragma once

#include "motion/interpolation/blend.h"
#include "motion/interpolation/interpolation_options.h"
#include "motion/interpolation/time_warp.h"

namespace mien::motion {

/// Options of motion synthesis from examples.
struct SynthesisOptions {
  InterpolationOptions weights;  ///< computation of blend weights from parameters
  RotationBlend rotations = RotationBlend::karcher_mean;
  WarpShape time_warp = WarpShape::monotone;
  bool foot_lock = true;

  friend bool operator==(const SynthesisOptions&, const SynthesisOptions&) = default;
};

}  // namespace mien::motion

#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "motion/interpolation/time_warp.h"
#include "motion/skeleton/example.h"

namespace mien::motion {

/// Averaging method for the rotations of a joint.
enum class RotationBlend {
  karcher_mean,       ///< the rotation with the least weighted squared angle to all; default
  direction_vectors,  ///< weighted sum of direction vectors, made orthonormal again
  markley_mean,  ///< nearest to all as quaternions: largest eigenvector of Σ w q qᵀ (Markley
                 ///< et al. 2007)
};

struct BlendOptions {
  double frames_per_second = 30.0;
  RotationBlend rotations = RotationBlend::karcher_mean;
  WarpShape warp = WarpShape::monotone;
};

/// Weighted mean of rotations. Weights are ≥ 0 and sum to 1. Exact when one weight is 1.
Quat blend_rotations(std::span<const Quat> rotations, std::span<const double> weights,
                     RotationBlend how);

/// Keytimes of the blend with these weights, seconds.
std::vector<double> mean_keytimes(const ExampleSet& set, const Eigen::VectorXd& weights);

/// A weighted blend of the examples: keytimes and duration are weighted means; at each time every
/// example is sampled at its corresponding time, rotations are averaged and root positions summed
/// with the weights.
///
/// `weights` has one entry an example, all ≥ 0 and summing to 1. All examples stand on the same
/// body and have the same number of keytimes. A loop's duration is rounded to whole frames
/// (keytimes with it), so that it can be played without a seam. With all weight on one example at
/// its own frame rate the result is that example.
Example blend(const ExampleSet& set, const Eigen::VectorXd& weights,
              const BlendOptions& options = {});

}  // namespace mien::motion

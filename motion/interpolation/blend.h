#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "motion/interpolation/time_warp.h"
#include "motion/skeleton/example.h"

namespace mien::motion {

/// Method of averaging the rotations of a joint.
enum class RotationBlend {
  karcher_mean,  ///< the rotation with the least weighted sum of squared angles to all; default
  direction_vectors,  ///< weighted sum of direction vectors, orthonormalised
  markley_mean,  ///< quaternion average: largest eigenvector of Σ w q qᵀ (Markley et al. 2007)
};

struct BlendOptions {
  double frames_per_second = 30.0;
  RotationBlend rotations = RotationBlend::karcher_mean;
  WarpShape warp = WarpShape::monotone;
};

/// Weighted mean of rotations. Weights are ≥ 0 and sum to 1.
Quat blend_rotations(std::span<const Quat> rotations, std::span<const double> weights,
                     RotationBlend how);

/// Keytimes of the blend with given weights, seconds.
std::vector<double> mean_keytimes(const ExampleSet& set, const Eigen::VectorXd& weights);

/// A weighted blend of the examples. Keytimes and duration are weighted means; at each time, every
/// example is sampled at its corresponding time, and the weighted means of rotations and root
/// positions are taken, and of fingers where all examples with weight have them.
///
/// `weights` has one entry per example, all ≥ 0 and summing to 1. All examples have the same body
/// and the same number of keytimes. The duration is rounded to whole frames, so that a loop can be
/// played without a seam, and the keytimes are scaled accordingly. With all weight on one example,
/// the result at that example's frame rate is its motion.
Example blend(const ExampleSet& set, const Eigen::VectorXd& weights,
              const BlendOptions& options = {});

}  // namespace mien::motion

#pragma once

#include <cstdint>

#include <Eigen/Core>

namespace mien::motion {

/// The rotation (or rotation with reflection) that makes whitened signals as independent as
/// possible.
struct FastIca {
  Eigen::MatrixXd rotation;  ///< orthonormal; sources = signals · rotation
  int iterations = 0;
  bool converged = false;
};

/// FastICA (Hyvärinen 1999) with g = tanh and symmetric decorrelation. The rows of `white` are
/// samples; its columns are uncorrelated signals of mean zero and unit variance. The initial guess
/// is random, determined by the seed.
FastIca fast_ica(const Eigen::MatrixXd& white, std::uint64_t seed, int most_iterations = 500);

}  // namespace mien::motion

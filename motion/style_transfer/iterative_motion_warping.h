#pragma once

#include <vector>

#include <Eigen/Core>

namespace mien::motion {

struct IterativeMotionWarpingOptions {
  double smoothness = 1e3;    ///< weight of the squared second differences of scale and offset
  double convergence = 1e-4;  ///< stops when the relative change of the error is below this
  int most_iterations = 50;
};

/// A correspondence between an input u and an output y: y at row times(i) ≈ scale(i)·u(i) +
/// offset(i).
struct MotionCorrespondence {
  std::vector<double> times;  ///< corresponding (fractional) output row per input row, ascending
  Eigen::MatrixXd scale;      ///< same shape as the input; varies smoothly over time
  Eigen::MatrixXd offset;
  double error = 0.0;  ///< remaining root mean square difference
  int iterations = 0;
  bool converged = false;
};

/// Iterative motion warping (Hsu, Pulli and Popović 2005): starting with scale 1 and offset 0,
/// alternates between time-warping the scaled and offset input onto the output by dynamic
/// programming, and fitting scale and offset of each signal by least squares for that time warp.
/// Rows are frames, columns are signals.
MotionCorrespondence iterative_motion_warping(const Eigen::MatrixXd& input,
                                              const Eigen::MatrixXd& output,
                                              const IterativeMotionWarpingOptions& options = {});

}  // namespace mien::motion

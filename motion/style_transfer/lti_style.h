#pragma once

#include <Eigen/Core>

#include "motion/math/state_space.h"
#include "motion/style_transfer/iterative_motion_warping.h"
#include "motion/style_transfer/motion_curves.h"

namespace mien::motion {

struct LtiStyleOptions {
  double amount = 1.0;  ///< 0 leaves the motion, 1 translates it, more exaggerates
  int order = 10;       ///< states of the model, 1 … 10
  int inputs = 3;       ///< principal components of the neutral motion that drive it, ≥ 1
  bool timing = true;   ///< translate the timing too
  IterativeMotionWarpingOptions warping;
};

/// A translation of style as a linear time-invariant system (Hsu, Pulli and Popović 2005), learnt
/// from a neutral motion and a styled one that iterative motion warping aligned to it. Inputs are
/// the principal components of the motion about its mean; outputs are what style adds to every
/// curve and the logarithm of the rate of time.
struct LtiStyleModel {
  std::vector<Quat> means;  ///< of the neutral motion; all curves are about them
  bool loops = false;
  double frames_per_second = 30.0;
  Eigen::MatrixXd components;  ///< curve_count × inputs, orthonormal
  StateSpace system;
  Eigen::RowVectorXd mean_difference;  ///< of the outputs
  Vec3 displacement_difference =
      Vec3::Zero();            ///< of the ways, frame of the mean direction, metres
  double error_radians = 0.0;  ///< root mean square error of joint rotations on the training pair
  MotionCorrespondence correspondence;
};

/// Both must loop, and begin at the same moment of the cycle, or neither; throws Error otherwise
/// and when options are out of range.
LtiStyleModel fit_lti_style(const Clip& neutral, const Clip& styled,
                            const LtiStyleOptions& options = {});

/// The motion filtered by the system: motion + amount · output. A loop stays one: the system is
/// taken in the state that it would have after endlessly many cycles. Feet are not repaired.
Clip translated(const Clip& motion, const LtiStyleModel& model,
                const LtiStyleOptions& options = {});

}  // namespace mien::motion

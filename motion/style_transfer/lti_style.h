#pragma once

#include <Eigen/Core>

#include "motion/math/state_space.h"
#include "motion/style_transfer/iterative_motion_warping.h"
#include "motion/style_transfer/motion_curves.h"

namespace mien::motion {

struct LtiStyleOptions {
  double amount = 1.0;  ///< 0: motion unchanged; 1: translated; above 1: exaggerated
  int order = 10;       ///< number of states of the model, 1 … 10
  int inputs = 3;       ///< number of principal components used as inputs, 1 … `curve_count`
  bool timing = true;   ///< whether to translate the timing too
  IterativeMotionWarpingOptions warping;  ///< `smoothness` as for 30 frames per second
};

/// A translation of style as a linear time-invariant system (Hsu, Pulli and Popović 2005), learnt
/// from a neutral motion and a styled motion aligned to it by iterative motion warping. Inputs are
/// the principal components of the motion about its mean; outputs are the difference that the style
/// adds to every curve, and the logarithm of the time rate.
struct LtiStyleModel {
  std::vector<Quat> means;  ///< mean rotations of the neutral motion, to which curves are relative
  bool loops = false;
  double frames_per_second = 30.0;
  Eigen::MatrixXd components;  ///< curve_count × inputs, orthonormal
  StateSpace system;
  Eigen::RowVectorXd mean_difference;  ///< mean of the outputs
  Vec3 displacement_difference =
      Vec3::Zero();  ///< difference in travel, metres, in the frame of the mean direction of travel
  double error_radians = 0.0;  ///< root mean square error of joint rotations on the training pair
  MotionCorrespondence correspondence;
};

/// Fits the model. Both clips must loop and begin at the same phase of the cycle, or neither may
/// loop. Throws Error if only one loops, and for options out of range.
LtiStyleModel fit_lti_style(const Clip& neutral, const Clip& styled,
                            const LtiStyleOptions& options = {});

/// The motion filtered by the system: motion + amount · output. A loop remains a loop: the system
/// is in its periodic steady state. Foot plants are not restored.
Clip translated(const Clip& motion, const LtiStyleModel& model,
                const LtiStyleOptions& options = {});

}  // namespace mien::motion

#pragma once

#include <vector>

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

/// What the inputs and outputs of a model were like while it was learnt.
struct LtiStyleRange {
  Eigen::RowVectorXd input_variance;  ///< of each input
  double largest_score = 0.0;     ///< of any frame: sum over inputs of squared value by variance
  double largest_residual = 0.0;  ///< of any frame: squared norm of what the inputs do not explain
  Eigen::RowVectorXd largest_output;  ///< of any frame, about the mean, absolute
};

/// A translation of style as a linear time-invariant system (Hsu, Pulli and Popović 2005), learnt
/// from a neutral motion and a styled motion aligned to it by iterative motion warping. Inputs are
/// the principal components of the motion about its mean; outputs are the difference that the style
/// adds to every curve, and the logarithm of the time rate.
struct LtiStyleModel {
  std::vector<Quat> means;  ///< mean rotations of the neutral motion, to which curves are relative
  bool loops = false;
  int frames = 0;  ///< of the neutral motion
  double frames_per_second = 30.0;
  Eigen::MatrixXd components;          ///< curve_count × inputs, orthonormal
  StateSpace system;                   ///< fitted closely, for motions like the neutral one
  StateSpace robust_system;            ///< fitted with a ridge, for other motions
  Eigen::MatrixXd inputs;              ///< of the neutral motion
  Eigen::RowVectorXd mean_difference;  ///< mean of the outputs
  Vec3 displacement_difference =
      Vec3::Zero();  ///< difference in travel, metres, in the frame of the mean direction of travel
  double error_radians = 0.0;  ///< root mean square error of joint rotations on the training pair
  MotionCorrespondence correspondence;
  LtiStyleRange range;
};

/// Fits the model. Both clips must loop and begin at the same phase of the cycle, or neither may
/// loop. Throws Error if only one loops, and for options out of range.
LtiStyleModel fit_lti_style(const Clip& neutral, const Clip& styled,
                            const LtiStyleOptions& options = {});

/// A motion translated into a style.
struct LtiTranslation {
  Clip clip;
  /// For each frame of the clip, the corresponding (fractional) frame of the motion; ascending.
  std::vector<double> source_frames;
  double deviating_share = 0.0;  ///< share of the frames that deviate, 0 … 1
};

/// The motion filtered by the system: motion + amount · output. A loop remains a loop: the system
/// is in its periodic steady state. It is filtered as if its cycle lasted as long as the neutral
/// one, since a system that learnt one cycle knows no other frequencies than this cycle's. Foot
/// plants are not restored.
///
/// A linear system amplifies without limit what it has not learnt. The less the inputs are like
/// those of the neutral motion, the more the robust system takes the place of the other one. Frames
/// that deviate from the neutral motion, in the size of the inputs or in what the inputs do not
/// explain, therefore remain as in the motion, with smooth transitions: the style fades where a
/// frame is more than half as far again from the mean as the farthest frame learnt, and vanishes at
/// three times as far (Hsu et al. leave deviating parts of heterogeneous motions as they are; these
/// thresholds were chosen for mien). Outputs are limited softly to between one and 1.5 times the
/// largest output learnt, and time runs at most three times as fast or slow, or 1.5 times as fast
/// or slow as learnt, whichever is more. So the result is bounded for any motion, and proportional
/// to `amount` for motions like the neutral one.
LtiTranslation translation(const Clip& motion, const LtiStyleModel& model,
                           const LtiStyleOptions& options = {});

/// The clip of `translation`.
Clip translated(const Clip& motion, const LtiStyleModel& model,
                const LtiStyleOptions& options = {});

}  // namespace mien::motion

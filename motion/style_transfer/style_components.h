#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "motion/style_transfer/motion_curves.h"

namespace mien::motion {

struct StyleComponentOptions {
  double amount = 1.0;
  int components = 6;        ///< ≥ 1; no more than the motions have
  std::uint64_t seed = 0;    ///< of the first guess
  std::vector<int> swapped;  ///< from 0, the strongest; empty: the `most_different`
  int most_different = 2;    ///< how many are swapped when none are named
};

/// Independent components of two motions of the same action (Shapiro, Cao and Faloutsos 2006).
/// curves = mean + series · mixing + residual, for the neutral motion and for the styled one
/// aligned to it in time.
struct StyleComponents {
  MotionCurves neutral;
  Eigen::RowVectorXd mean;           ///< of both motions together
  Eigen::MatrixXd neutral_series;    ///< frames × components, unit variance over both motions
  Eigen::MatrixXd styled_series;     ///< of the styled motion, in the neutral motion's time
  Eigen::MatrixXd mixing;            ///< components × curve_count
  Eigen::MatrixXd neutral_residual;  ///< frames × curve_count: what the components leave
  Eigen::VectorXd energy;            ///< squared norm of each mixing row, descending
  /// Mean squared difference of the two series times the energy: how much of the style is in it.
  Eigen::VectorXd difference;
  Eigen::MatrixXd joint_shares;  ///< components × body_joint_count: share of the energy, rows sum 1
                                 ///< with the root's place counted to the pelvis
  int iterations = 0;
  bool converged = false;
};

/// The styled motion is aligned by dynamic time warping, both are put one after the other, whitened
/// by principal components and turned to independence by FastICA (Hyvärinen 1999; tanh, symmetric).
/// The same seed gives the same components; signs are such that the largest number in each mixing
/// row is positive. Both must loop, beginning at the same moment of the cycle, or neither; throws
/// Error otherwise and when options are out of range.
StyleComponents style_components(const Clip& neutral, const Clip& styled,
                                 const StyleComponentOptions& options = {});

/// Indices of the components that the options swap: the named ones or the most different ones.
std::vector<int> swapped_components(const StyleComponents& components,
                                    const StyleComponentOptions& options);

/// The motion with the chosen components' series taken from the styled motion. Of another motion
/// than the neutral one: plus what that changes in the neutral one at the same share of the cycle
/// or take. Timing stays. Feet are not repaired.
Clip restyled(const Clip& motion, const StyleComponents& components,
              const StyleComponentOptions& options = {});

}  // namespace mien::motion

#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "motion/style_transfer/motion_curves.h"

namespace mien::motion {

struct StyleComponentOptions {
  double amount = 1.0;
  int components = 6;      ///< number of components, ≥ 1; limited to those that the motions have
  std::uint64_t seed = 0;  ///< seed of the initial guess
  /// Indices of the swapped components, 0 being the strongest; if empty, the most different ones
  /// are swapped, as many as `most_different`.
  std::vector<int> swapped;
  int most_different = 2;  ///< number of components to swap if `swapped` is empty
};

/// Independent components of two motions of the same action (Shapiro, Cao and Faloutsos 2006).
/// curves = mean + series · mixing + residual, for the neutral motion and for the styled one
/// aligned to it in time.
struct StyleComponents {
  MotionCurves neutral;
  Eigen::RowVectorXd mean;         ///< of both motions together
  Eigen::MatrixXd neutral_series;  ///< frames × components, unit variance over both motions
  Eigen::MatrixXd styled_series;   ///< as above for the styled motion, in the neutral motion's time
  Eigen::MatrixXd mixing;          ///< components × curve_count
  Eigen::MatrixXd neutral_residual;  ///< frames × curve_count: not explained by the components
  Eigen::VectorXd energy;            ///< squared norm of each mixing row, descending
  /// Mean squared difference of the two series times the energy: each component's contribution to
  /// the style.
  Eigen::VectorXd difference;
  Eigen::MatrixXd joint_shares;  ///< components × body_joint_count: share of the energy per joint;
                                 ///< rows sum to 1; the root position counts towards the pelvis
  int iterations = 0;
  bool converged = false;
};

/// Aligns the styled motion by dynamic time warping, concatenates both motions, whitens them by
/// principal components and rotates them to independence by FastICA (Hyvärinen 1999; tanh,
/// symmetric). The same seed yields the same components; signs are chosen so that the largest
/// element of each mixing row is positive. Both clips must loop and begin at the same phase of the
/// cycle, or neither may loop. Throws Error if only one loops, and for options out of range.
StyleComponents style_components(const Clip& neutral, const Clip& styled,
                                 const StyleComponentOptions& options = {});

/// Indices of the components that the options swap: `swapped` or the most different ones. Throws
/// Error for an index in `swapped` without a component.
std::vector<int> swapped_components(const StyleComponents& components,
                                    const StyleComponentOptions& options);

/// The motion with the chosen components' series taken from the styled motion. For a motion other
/// than the neutral one, adds the change that this makes in the neutral motion at the same
/// normalized time of the cycle or clip. Timing is unchanged. Foot plants are not restored.
Clip restyled(const Clip& motion, const StyleComponents& components,
              const StyleComponentOptions& options = {});

}  // namespace mien::motion

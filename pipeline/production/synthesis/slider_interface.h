#pragma once

#include <Eigen/Core>

#include "motion/live/slider_interface.h"
#include "pipeline/production/synthesis/repertoire.h"

namespace mien::pipeline {

// Slider interfaces for making motions (motion/live/slider_interface.h) from a repertoire.

using motion::FittedInterface;
using motion::InterfaceKind;
using motion::SliderInterface;

/// Returns the examples that an interpolation blends: those with locked feet if foot locking is
/// enabled.
const motion::ExampleSet& examples_for(const Interpolation& interpolation,
                                       const Repertoire& repertoire);

/// Fits an interface. The settings of the last `held` sliders are held rather than requested
/// (interpolation.h). Throws Error if the examples lack a slider's parameter, or the method does
/// not support so many sliders.
FittedInterface fit_interface(const SliderInterface& interface, const Interpolation& interpolation,
                              const Repertoire& repertoire, Eigen::Index held = 0);

/// Returns the motion for the settings of an interface. Feet are not locked: locking changes joint
/// positions by only a few millimetres and would dominate the computing time when many settings are
/// tried. If all weights are 0, the result is the mean of all examples.
motion::Example motion_of(const FittedInterface& interface, const Eigen::RowVectorXd& settings,
                          const Interpolation& interpolation, const Repertoire& repertoire,
                          double frames_per_second = 30.0);

/// Returns the settings that an ideal user would choose for a motion with known blend weights: the
/// weights scaled to a maximum of 1, the weighted sums of the adjectives, or the measured features,
/// clamped to [0, 1]. Negative weights, which a statistical model may return, become 0; a feature
/// that cannot be measured becomes 0.5.
Eigen::RowVectorXd ideal_settings(const SliderInterface& interface, const motion::Example& target,
                                  const Eigen::VectorXd& weights, const Repertoire& repertoire);

/// Returns the settings, each rounded to the nearest multiple of `step`.
Eigen::RowVectorXd rounded(const Eigen::RowVectorXd& settings, double step);

}  // namespace mien::pipeline

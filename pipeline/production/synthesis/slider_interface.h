#pragma once

#include <Eigen/Core>

#include "motion/live/slider_interface.h"
#include "pipeline/production/synthesis/repertoire.h"

namespace mien::pipeline {

// Interfaces for making motions (motion/live/slider_interface.h) of a repertoire.

using motion::FittedInterface;
using motion::InterfaceKind;
using motion::SliderInterface;

/// The examples that an interpolation blends: with settled feet where feet are to be locked.
const motion::ExampleSet& examples_for(const Interpolation& interpolation,
                                       const Repertoire& repertoire);

/// The last `held` sliders are not requested, but held at their settings (interpolation.h).
/// Throws Error when the examples lack a slider's parameter, or the method cannot take so many.
FittedInterface fit_interface(const SliderInterface& interface, const Interpolation& interpolation,
                              const Repertoire& repertoire, Eigen::Index held = 0);

/// The motion that the sliders of an interface make. Feet are not locked: that moves joints by a
/// few millimetres and would take most of the time where many settings are tried. Weights that are
/// all 0 make the mean of all examples.
motion::Example motion_of(const FittedInterface& interface, const Eigen::RowVectorXd& settings,
                          const Interpolation& interpolation, const Repertoire& repertoire,
                          double frames_per_second = 30.0);

/// Where an ideal user would put the sliders for a motion that was made with known weights: the
/// weights with the largest at 1, the adjectives that they sum up to, or the features as measured,
/// cut to [0, 1]. Weights below 0, which a statistical model's may be, become 0.
Eigen::RowVectorXd ideal_settings(const SliderInterface& interface, const motion::Example& target,
                                  const Eigen::VectorXd& weights, const Repertoire& repertoire);

/// Settings to the nearest multiple of `step` (and to 1).
Eigen::RowVectorXd rounded(const Eigen::RowVectorXd& settings, double step);

}  // namespace mien::pipeline

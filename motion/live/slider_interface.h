#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "motion/interpolation/interpolation.h"
#include "motion/interpolation/parameter_table.h"
#include "motion/interpolation/synthesis_options.h"
#include "motion/skeleton/example.h"

namespace mien::motion {

// Interfaces for making motions: sliders for adjectives, for features, or for the weights of the
// examples. A stimulus that names parameters is one setting of such sliders.

enum class InterfaceKind { adjectives, features, weights };

/// "adjectives", "features", "weights".
const char* name_of(InterfaceKind kind);

/// The kind of that name; none of another.
std::optional<InterfaceKind> interface_kind(std::string_view name);

/// Sliders from 0 to 1 and what they make.
struct SliderInterface {
  InterfaceKind kind = InterfaceKind::adjectives;
  std::vector<std::string> sliders;  ///< of weights: all examples in their order
};

/// An interface ready to make motions: what lies between its sliders and the examples, fitted once.
struct FittedInterface {
  SliderInterface sliders;
  Interpolator interpolator;  ///< of the weights' interface: the shares themselves
};

/// Examples are those that will be blended. `table`: where they lie on the interface's parameters;
/// not looked at for weights. The last `held` sliders are not asked for, but to be kept where they
/// are set (interpolation.h). Throws Error when the examples lack a slider's parameter, or the
/// method cannot take so many.
FittedInterface fit_interface(const SliderInterface& interface, const SynthesisOptions& how,
                              const ExampleSet& examples, const ParameterTable& table,
                              Eigen::Index held = 0);

/// The motion that the sliders of an interface make, without a foot lock (made_motion.h). Weights
/// that are all 0 make the mean of all examples.
Example motion_of(const FittedInterface& interface, const Eigen::RowVectorXd& settings,
                  const SynthesisOptions& how, const ExampleSet& examples,
                  double frames_per_second = 30.0);

}  // namespace mien::motion

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "motion/interpolation/interpolation.h"
#include "motion/interpolation/parameter_table.h"
#include "motion/interpolation/synthesis_options.h"
#include "motion/skeleton/example.h"
#include "motion/text/words.h"

namespace mien::motion {

// Interfaces for making motions: sliders for adjectives, for features, or for the weights of the
// examples. A stimulus that names parameters is one setting of such sliders.

enum class InterfaceKind { adjectives, features, weights };

inline constexpr mien::Words<InterfaceKind> interface_kinds = {
    {"adjectives", InterfaceKind::adjectives},
    {"features", InterfaceKind::features},
    {"weights", InterfaceKind::weights}};

inline const char* name_of(InterfaceKind kind) { return word_of(interface_kinds, kind).data(); }

/// The sliders of an interface, from 0 to 1.
struct SliderInterface {
  InterfaceKind kind = InterfaceKind::adjectives;
  std::vector<std::string> sliders;  ///< of weights: all examples in their order
};

/// An interface with its fitted interpolation.
struct FittedInterface {
  SliderInterface sliders;
  Interpolator interpolator;  ///< of the weights' interface: the shares themselves
};

/// Fits an interface to the examples that will be blended. `table`: their values of the interface's
/// parameters; ignored for weights. The last `held` sliders are held, not requested
/// (interpolation.h). Throws Error when the examples lack a slider's parameter, or the method does
/// not support that many.
FittedInterface fit_interface(const SliderInterface& interface, const SynthesisOptions& how,
                              const ExampleSet& examples, const ParameterTable& table,
                              Eigen::Index held = 0);

/// The motion for slider values, without foot lock (synthesis.h). Weights that are all 0 give the
/// mean of all examples.
Example motion_of(const FittedInterface& interface, const Eigen::RowVectorXd& settings,
                  const SynthesisOptions& how, const ExampleSet& examples,
                  double frames_per_second = 30.0);

}  // namespace mien::motion

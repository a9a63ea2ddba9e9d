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

// Interfaces for creating motions: sliders for adjectives, for features, or for the weights of the
// examples, or for modifications of one motion (live_modification.h). A stimulus that specifies
// parameters corresponds to one setting of such sliders.

enum class InterfaceKind { adjectives, features, weights, modifications };

inline constexpr mien::Words<InterfaceKind> interface_kinds = {
    {"adjectives", InterfaceKind::adjectives},
    {"features", InterfaceKind::features},
    {"weights", InterfaceKind::weights},
    {"modifications", InterfaceKind::modifications}};

inline const char* name_of(InterfaceKind kind) { return word_of(interface_kinds, kind).data(); }

/// The sliders of an interface whose motions are blends, from 0 to 1; not of modifications.
struct SliderInterface {
  InterfaceKind kind = InterfaceKind::adjectives;
  std::vector<std::string> sliders;  ///< names; for weights all examples in their order
};

/// An interface with its fitted interpolation.
struct FittedInterface {
  SliderInterface sliders;
  Interpolator interpolator;  ///< for weights, the identity up to normalisation
};

/// Fits an interface to the examples to be blended. `table` holds the values of the examples for
/// the parameters of the interface; it is ignored for weights. The last `held` sliders are
/// parameters to be held rather than requested (interpolation.h). Throws Error if the examples lack
/// the parameter of a slider, or the method does not support so many parameters.
FittedInterface fit_interface(const SliderInterface& interface, const SynthesisOptions& how,
                              const ExampleSet& examples, const ParameterTable& table,
                              Eigen::Index held = 0);

/// The motion for slider values; its feet are not locked (synthesis.h locks them). If all weights
/// are 0, the mean of all examples.
Example motion_of(const FittedInterface& interface, const Eigen::RowVectorXd& settings,
                  const SynthesisOptions& how, const ExampleSet& examples,
                  double frames_per_second = 30.0);

}  // namespace mien::motion

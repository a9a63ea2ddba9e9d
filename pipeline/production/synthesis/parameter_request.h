#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "motion/interpolation/reach.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/production/synthesis/repertoire.h"
#include "pipeline/production/synthesis/slider_interface.h"

namespace mien::pipeline {

class Motions;

/// The parameters that a stimulus requests, as slider settings.
struct ParameterRequest {
  SliderInterface sliders;      ///< the requested parameters, then those that are held
  Eigen::RowVectorXd settings;  ///< one per slider
  Eigen::Index held = 0;        ///< number of trailing parameters that are only held
};

/// Returns the stimulus's features, otherwise its adjectives; empty if it requests neither.
const NamedValues& requested_values(const Stimulus& stimulus);

/// Returns the request of a stimulus. Throws Error.
ParameterRequest request_of(const Stimulus& stimulus, const Repertoire& repertoire);

/// Returns the values of the examples for the parameters that a stimulus names.
const ParameterTable& table_of(const Stimulus& stimulus, const Repertoire& repertoire);

/// The range that blends of the examples can reach in a requested parameter while the other
/// requested parameters have their requested values. Held parameters have their held values, unless
/// the request is infeasible with these.
struct FeasibleParameter {
  std::string name;
  double requested = 0.0;
  motion::ParameterRange range;
  motion::ParameterRange alone;  ///< range over all blends, whatever their other values
  NamedValues others;         ///< the other requested parameters, and the held ones unless ignored
  bool ignores_held = false;  ///< the request is infeasible with the held values, which are ignored

  /// Whether a blend reaches the requested value together with the others, within 0.005.
  bool is_feasible() const;
};

/// Returns the feasible range of each requested parameter.
std::vector<FeasibleParameter> feasible_parameters(const ParameterRequest& request,
                                                   const ParameterTable& table);

/// Returns "feasible range 0.37 to 0.75 with openness 0.50". If no blend has the values of
/// `others`, the sentence says so and states the range over all blends.
std::string to_sentence(const FeasibleParameter& parameter);

/// A parameter requested by a stimulus.
struct RequestedParameter {
  std::string stimulus;
  FeasibleParameter parameter;
};

/// Returns "mix-1: extraversion 0.74 requested; feasible range 0.37 to 0.75 with openness 0.50".
std::string to_sentence(const RequestedParameter& requested);

/// Returns a heading and one line per parameter, and an explanation of the mark of infeasible
/// values if there are any. Each line is ended by a line break. Empty without parameters.
std::string feasibility_table(const std::vector<RequestedParameter>& requested);

/// Returns the requested parameters of all stimuli made from adjectives, except those made by the
/// statistical model. Loads the examples only if there is such a stimulus.
std::vector<RequestedParameter> requested_parameters(const Manifest& manifest, Motions& motions);
std::vector<RequestedParameter> requested_parameters(const Manifest& manifest);

}  // namespace mien::pipeline

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

/// The named parameters that a stimulus requests, as slider settings.
struct ParameterRequest {
  SliderInterface sliders;      ///< the requested parameters, then those that are held
  Eigen::RowVectorXd settings;  ///< one a slider
  Eigen::Index held = 0;        ///< how many of the last are held only
};

/// The stimulus's features, or else its adjectives; empty where it requests neither.
const NamedValues& requested_values(const Stimulus& stimulus);

/// Throws Error when the examples lack a parameter.
ParameterRequest request_of(const Stimulus& stimulus, const Repertoire& repertoire);

/// Where the examples lie on the parameters that a stimulus names.
const ParameterTable& table_of(const Stimulus& stimulus, const Repertoire& repertoire);

/// The values of a requested parameter that blends of the examples can have while the other
/// requested parameters are as requested.
struct FeasibleParameter {
  std::string name;
  double requested = 0.0;
  motion::ParameterRange range;
  motion::ParameterRange alone;  ///< whatever the others are
  NamedValues others;  ///< the other requested parameters, and the held ones where that is possible
  bool ignores_held = false;  ///< held values are infeasible and were ignored

  /// Whether the requested value is in the range.
  bool holds() const;
};

/// One for each requested parameter.
std::vector<FeasibleParameter> feasible_parameters(const ParameterRequest& request,
                                                   const ParameterTable& table);

/// "feasible range 0.37 to 0.75 with openness 0.50". Where no blend has the others, the range is
/// that of all blends.
std::string to_sentence(const FeasibleParameter& parameter);

/// A parameter that a stimulus asks for.
struct RequestedParameter {
  std::string stimulus;
  FeasibleParameter parameter;
};

/// "mix-1: extraversion 0.74 requested; feasible range 0.37 to 0.75 with openness 0.50".
std::string to_sentence(const RequestedParameter& requested);

/// A line each below a heading, each ended by a line break; empty for none.
std::string feasibility_table(const std::vector<RequestedParameter>& requested);

/// The requested parameters of every stimulus made from adjectives. Loads the examples only if
/// there is one.
std::vector<RequestedParameter> requested_parameters(const Manifest& manifest, Motions& motions);
std::vector<RequestedParameter> requested_parameters(const Manifest& manifest);

}  // namespace mien::pipeline

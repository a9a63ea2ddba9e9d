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

/// What a stimulus asks for by name, as settings of sliders.
struct Wish {
  SliderInterface sliders;      ///< the parameters asked for, then those that are held
  Eigen::RowVectorXd settings;  ///< one a slider
  Eigen::Index held = 0;        ///< how many of the last are held only
};

/// Its features, or else its adjectives; empty where it asks for nothing by name.
const NamedValues& wishes_of(const Stimulus& stimulus);

/// Throws Error when the examples lack a parameter.
Wish wish_of(const Stimulus& stimulus, const Repertoire& repertoire);

/// Where the examples lie on the parameters that a stimulus names.
const ParameterTable& table_of(const Stimulus& stimulus, const Repertoire& repertoire);

/// What blends of the examples can have of a parameter that is asked for, while the other wishes
/// are met.
struct FeasibleParameter {
  std::string name;
  double asked = 0.0;
  motion::ParameterRange range;
  motion::ParameterRange alone;  ///< whatever the others are
  NamedValues others;  ///< the other parameters asked for, and those held where that is possible
  bool gives_up_held = false;  ///< what is held cannot be, and was left out of account

  /// Whether what is asked for lies in the range.
  bool holds() const;
};

/// One a parameter asked for.
std::vector<FeasibleParameter> feasible_parameters(const Wish& wish, const ParameterTable& table);

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

/// Of every stimulus that asks for adjectives. Reads the examples, once for all who ask the same
/// motions; not at all when nobody asks.
std::vector<RequestedParameter> requested_parameters(const Manifest& manifest, Motions& motions);
std::vector<RequestedParameter> requested_parameters(const Manifest& manifest);

}  // namespace mien::pipeline

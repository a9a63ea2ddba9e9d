#include "pipeline/production/methods/method_sources.h"

namespace mien::pipeline {

MethodWords words_of(motion::InterpolationMethod method) {
  using Method = motion::InterpolationMethod;
  static const std::vector<MethodWords> all = {
      {Method::reach,
       "a quadratic program that reaches the requested values exactly or as closely as possible, "
       "with weights as close as possible to those of a cardinal basis of linear and radial "
       "functions",
       {"rose1998", "sloan2001", "huang2010"}},
      {Method::cardinal,
       "a cardinal basis of linear and radial functions",
       {"rose1998", "sloan2001", "adjectives"}},
      {Method::nearest,
       "nearest neighbours among the examples and random blends of them",
       {"kovar2004"}},
      {Method::inverse_distance, "inverse distance weighting", {"shepard1968"}},
      {Method::grid, "multilinear interpolation on a regular grid", {"wiley1997"}},
      {Method::kriging, "kriging", {"mukai2005"}},
      {Method::pca, "a statistical model of the motions (principal components)", {"min2009"}},
      {Method::incremental, "incremental steps along adjectives", {"forger2012", "adjectives"}},
  };
  for (const MethodWords& one : all) {
    if (one.method == method) return one;
  }
  return {method, std::string(motion::name_of(method)) + " interpolation", {}};
}

std::string source_of(StyleMethod method) {
  switch (method) {
    case StyleMethod::amaya:
      return "amaya1996";
    case StyleMethod::unuma:
      return "unuma1995";
    case StyleMethod::hsu:
      return "hsu2005";
    case StyleMethod::witkin:
      return "witkin1995";
    case StyleMethod::shapiro:
      return "shapiro2006";
    case StyleMethod::neff:
      return "neff2009";
    case StyleMethod::waveshape:
    case StyleMethod::displacement:
      break;
  }
  return "bruderlin1995";
}

}  // namespace mien::pipeline

#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "motion/lint/finding.h"
#include "motion/skeleton/example.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/production/synthesis/parameter_request.h"
#include "pipeline/production/synthesis/repertoire.h"

namespace mien::pipeline {

/// A motion that was made, and how.
struct Synthesis {
  motion::Example motion;  ///< at the output's frame rate; one cycle of a loop, travelling
  /// One an example; empty when a file is shown as it is. Of a statistical model they may be
  /// negative (interpolation.h).
  Eigen::VectorXd weights;
  std::optional<double> expected_error_m;  ///< kriging's own: how far joints may be off
  NamedValues requested;                   ///< the parameters that the stimulus sets
  /// The same parameters as the motion has them: adjectives by the blend, Σ weight · value;
  /// features as measured of the motion that was made, on the examples' scale.
  NamedValues reached;
  NamedValues held;          ///< the values at which parameters were held
  NamedValues held_reached;  ///< the values that the blend has of these
  std::vector<FeasibleParameter>
      feasible;                  ///< one for each requested parameter; none of a statistical model
  double planted_drift_m = 0.0;  ///< horizontal, largest over all plants of the result
  std::vector<std::string> warnings;
  std::vector<std::string> notes;         ///< plain sentences that call for nothing
  std::string modified;                   ///< what was done to it ("sad × 0.8"); empty for nothing
  double modified_share = 1.0;            ///< of the requested strengths (OnFault::reduce)
  std::vector<motion::Finding> findings;  ///< of the lint: of a modified motion against what it was
};

/// Blend weights of a stimulus: given, or from its adjectives or features by the interpolation
/// method that it asks for, over the parameters that it names.
Eigen::VectorXd weights_of(const Stimulus& stimulus, const Repertoire& repertoire);

/// What people would say of a blend: every rated parameter, Σ weight · value. Empty for what is no
/// blend, or was modified after it, and without ratings.
NamedValues rated_values(const Synthesis& synthesis, const Repertoire& repertoire);

/// Makes a stimulus's motion: weights, blend of the examples (with settled feet), foot lock; or, of
/// a stimulus with `clip:`, the file mapped onto the body and otherwise as captured. Then its
/// modifications, and a lint of the result. Throws Error.
Synthesis synthesize(const Stimulus& stimulus, const Repertoire& repertoire);

/// An example of the repertoire as if a stimulus had requested it alone (sheets may name one).
Synthesis synthesize_example(const std::string& name, const Output& output,
                             const Interpolation& interpolation, const Repertoire& repertoire);

}  // namespace mien::pipeline

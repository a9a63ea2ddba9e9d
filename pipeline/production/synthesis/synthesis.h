#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "motion/fitting/fit_quality.h"
#include "motion/lint/finding.h"
#include "motion/skeleton/example.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/production/synthesis/parameter_request.h"
#include "pipeline/production/synthesis/repertoire.h"

namespace mien::pipeline {

/// A synthesized motion and how it was made.
struct Synthesis {
  motion::Example motion;  ///< at the output's frame rate; one cycle of a loop, including travel
  /// One weight per example; empty for a motion file or path. Weights of a statistical model may be
  /// negative (interpolation.h).
  Eigen::VectorXd weights;
  /// Expected error of the joint positions as estimated by kriging, metres; empty for other
  /// methods.
  std::optional<double> expected_error_m;
  NamedValues requested;  ///< the parameters that the stimulus sets
  /// The values reached for the same parameters. Adjectives: Σ weight · value over the blend;
  /// features: measured on the motion before modifications, 0 the smallest and 1 the largest of the
  /// examples.
  NamedValues reached;
  NamedValues held;          ///< the values at which parameters were held
  NamedValues held_reached;  ///< values of the held parameters in the blend
  /// One per requested adjective or group of adjectives; empty for features and for a statistical
  /// model.
  std::vector<FeasibleParameter> feasible;
  /// Largest horizontal drift over all foot plants of the result, metres.
  double planted_drift_m = 0.0;
  std::vector<std::string> warnings;
  std::vector<std::string> notes;  ///< plain sentences that require no action
  std::string modified;         ///< description of the modifications ("sad × 0.8"); empty for none
  double modified_share = 1.0;  ///< applied share of the requested strengths (OnFault::reduce)
  /// Lint findings; a modified motion is compared with the original.
  std::vector<motion::Finding> findings;
  /// How well the body fits the points of the clip's file, if that holds points.
  std::optional<motion::FitQuality> fit;
  double clip_start_s = 0.0;  ///< start of the clip in the motion of its file
  /// Of a walk along a path: its moods, by time of the motion after modifications; one if it does
  /// not change. A change is when the walker begins to follow the other mood.
  std::vector<ShownMood> moods;
};

/// Returns the blend weights of a stimulus that is made from examples: the given ones, or those
/// computed from its adjectives or features by its interpolation method.
Eigen::VectorXd weights_of(const Stimulus& stimulus, const Repertoire& repertoire);

/// Returns the predicted ratings of a blend: Σ weight · value for every rated parameter. Empty
/// without ratings and for motions that are not blends or were modified afterwards.
NamedValues rated_values(const Synthesis& synthesis, const Repertoire& repertoire);

/// Makes a stimulus's motion: blends the examples; for `clip:`, retargets the file to the body and
/// leaves it otherwise as captured; for `path:`, walks along the path (walked_path.h). Unless foot
/// locking is disabled, the blended examples have locked feet, and the feet of the blend are locked
/// again. Modifications are applied last. The result is checked with the lint. Throws Error.
Synthesis synthesize(const Stimulus& stimulus, const Repertoire& repertoire);

/// Returns an example of the repertoire as if a stimulus had requested only that example, for
/// sheets and overlays that name one. It is not checked with the lint.
Synthesis synthesize_example(const std::string& name, const Output& output,
                             const Interpolation& interpolation, const Repertoire& repertoire);

}  // namespace mien::pipeline

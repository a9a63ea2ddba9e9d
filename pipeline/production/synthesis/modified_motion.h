#pragma once

#include <string>
#include <vector>

#include "motion/lint/finding.h"
#include "motion/modify/modification.h"
#include "motion/skeleton/example.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/production/synthesis/repertoire.h"

namespace mien::pipeline {

/// A motion to which a stimulus's modifications have been applied, as far as lint errors allow.
struct ModifiedMotion {
  motion::Example motion;
  /// Applied share of the requested strengths; below 1 if reduced, 0 if reverted.
  double share = 1.0;
  /// Largest drift of a foot planted in the original, metres; that which keys, constraints, drives,
  /// frozen parts and a closed loop add is added.
  double planted_drift_m = 0.0;
  /// Lint findings of the result compared with the original.
  std::vector<motion::Finding> findings;
  std::vector<std::string> notes;     ///< remarks about the steps, plain sentences
  std::vector<std::string> warnings;  ///< consequences of lint errors, plain sentences
  std::vector<double> times = {};     ///< given times of the original, in the result, seconds
};

/// Returns each of the stimulus's modifications as at a strength of 1, including the differences
/// between the poses that it names; an empty modification for a step of style transfer
/// (StyleMethod). Throws Error if a pose is not available.
std::vector<motion::Modification> modifications_of(const Stimulus& stimulus,
                                                   const Repertoire& repertoire);

/// Applies the stimulus's modifications in order and checks the result with the lint. Errors that
/// are new, or more than 1.5 times as large as in the original, are treated as `on_fault` says,
/// which is reported in the warnings. The result has the output's frame rate. Throws Error if a
/// pose or style is not available and, with `on_fault: fail`, if there are such errors. `times` are
/// times of the original, seconds, that are moved with it (ModifiedMotion::times), and
/// `planted_drift_m` is how far planted feet drift in it.
ModifiedMotion modify_motion(const motion::Example& original, const Stimulus& stimulus,
                             const Repertoire& repertoire, const std::vector<double>& times = {},
                             double planted_drift_m = 0.0);

/// Returns the errors that lint found in a modified motion and the original, at the same frame
/// rate, does not have, or that are more than 1.5 times as large as in it.
std::vector<motion::Finding> new_errors(const std::vector<motion::Finding>& findings,
                                        const motion::Clip& original);

/// Returns a readable description of a step: "sad × 0.8", "paths 1.4, acceleration +0.3,
/// head-flexion 12°".
std::string described(const ModificationStep& step);

/// Returns the applied share of a modification as text, " at 40 % of that strength"; empty for a
/// share of 1.
std::string share_text(double share);

/// Returns the description of all steps of a stimulus, in order; empty if there are none.
std::string described_modifications(const Stimulus& stimulus);

}  // namespace mien::pipeline

#pragma once

#include <string>
#include <vector>

#include "motion/lint/finding.h"
#include "motion/modify/modification.h"
#include "motion/skeleton/example.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/production/synthesis/repertoire.h"

namespace mien::pipeline {

/// A motion with a stimulus's modifications done, or with as much of them as faults allow.
struct ModifiedMotion {
  motion::Example motion;
  double share = 1.0;                     ///< of the requested strengths; below 1 when reduced
  double planted_drift_m = 0.0;           ///< largest, of the feet that the original plants
  std::vector<motion::Finding> findings;  ///< of the result, against the original
  std::vector<std::string> notes;         ///< what was done on the way, plain sentences
  std::vector<std::string> warnings;      ///< what came of faults, plain sentences
};

/// What each of the stimulus's modifications does at its full strength, poses read; of an older
/// method, nothing. Throws Error when a pose cannot be had.
std::vector<motion::Modification> modifications_of(const Stimulus& stimulus,
                                                   const Repertoire& repertoire);

/// Does the stimulus's modifications one after the other and looks the result over. Errors
/// that the original has not, or that are half as bad again, are dealt with as `on_fault` says;
/// what was done is among the warnings. The motion comes back at the output's frame rate. Throws
/// Error when a pose cannot be had, and for `on_fault: fail`.
ModifiedMotion modify_motion(const motion::Example& original, const Stimulus& stimulus,
                             const Repertoire& repertoire);

/// "sad × 0.8", "paths 1.4, acceleration +0.3, head-flexion 12°": a step as people read it.
std::string described(const ModificationStep& step);

/// " at 40 % of that": what was done of a modification, empty when it was all.
std::string share_text(double share);

/// All steps of a stimulus, in their order; empty without any.
std::string described_modifications(const Stimulus& stimulus);

}  // namespace mien::pipeline

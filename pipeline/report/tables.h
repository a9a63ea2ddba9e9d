#pragma once

#include <string>

#include "pipeline/manifest/manifest.h"
#include "pipeline/synthesis/motions.h"

namespace mien::pipeline {

// The study's numbers as tidy CSV: one row an observation, metres and seconds. The column `ratings`
// says whose ratings a motion rests on: "given", "simulated", or "none" for features, weights and
// files.

/// A row a sheet: sheet, target, created, ratings, alignment, d_m (eq. (8) divided by its number of
/// terms), d_sum_m (as printed), mpjpe_m, threshold_m, match (1 or 0).
std::string distances_csv(const Manifest& manifest, Motions& motions);

/// A row a sheet, joint and time: sheet, target, created, ratings, joint, time (share of the
/// duration), distance_m.
std::string joint_distances_csv(const Manifest& manifest, Motions& motions);

/// A row a stimulus and example: stimulus, ratings, example, weight. All examples, zeros too.
std::string weights_csv(const Manifest& manifest, Motions& motions);

/// A row a stimulus: stimulus, role, ratings, source (adjectives, features, weights, clip), frames
/// and duration_s of what is shown, fps, cycle_s, stride_m (along the floor, a cycle), speed_m_s,
/// planted_drift_m (largest, of a planted foot), method, expected_error_m, modified (what was done
/// to it), modified_share (of the strengths asked for; below 1 when reduced).
std::string clips_csv(const Manifest& manifest, Motions& motions);

/// A row a stimulus and parameter: stimulus, ratings, parameter, asked, reached (Synthesis), both
/// 0 … 1, name and name_ja (as people read them: "sad – happy"). First what the stimulus asks for,
/// then, with `asked` empty, all other parameters of the ratings as the blend has them: where a
/// slider would start that is added.
std::string parameters_csv(const Manifest& manifest, Motions& motions);

/// What people think of the examples, a row a scale and example: scale, example, ratings, answers,
/// mean (0 low end … 1 high end), sd (over participants; empty where only means are known). No
/// rows where nothing is blended or nothing was rated.
std::string impressions_csv(const Manifest& manifest, Motions& motions);

/// What the lint found in the motions, a row a finding: stimulus, check, severity, joint,
/// first_frame and last_frame (of one cycle, or of the whole clip), first_s, last_s, measured,
/// threshold, unit, sentence.
std::string findings_csv(const Manifest& manifest, Motions& motions);

/// How motions differ from the reference of their comparison (feature_changes.h), a row a
/// comparison with a reference and a feature: sheet, reference, target, created, ratings, feature,
/// name, name_ja, unit, reference_value, target_change, created_change, moved (1: the target
/// differs measurably from the reference), agrees (1: so does the created motion, the same way;
/// empty when the target has not moved).
std::string feature_changes_csv(const Manifest& manifest, Motions& motions);

}  // namespace mien::pipeline

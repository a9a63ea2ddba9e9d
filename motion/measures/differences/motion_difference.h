#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "motion/lint/finding.h"
#include "motion/lint/lint_options.h"
#include "motion/measures/differences/contact_difference.h"
#include "motion/measures/differences/joint_difference.h"
#include "motion/measures/differences/timing_difference.h"
#include "motion/measures/differences/whole_change.h"
#include "motion/measures/features/motion_features.h"

namespace mien::motion {

/// Change of a lint finding between two motions.
struct LintChange {
  enum class Kind { gone, appeared, worse, better };
  Kind kind = Kind::appeared;
  Finding finding;  ///< from the second motion; from the first if `kind` is `gone`
};

/// "gone", "new", "worse", "better".
std::string_view name_of(LintChange::Kind kind);

/// The lint findings in which two motions differ. Two findings are the same fault if they have the
/// same check and joint and their intervals overlap or touch in time; it is worse or better if its
/// severity changed. Findings of the second motion come first, in their order, followed by those
/// that are gone.
std::vector<LintChange> lint_changes(const std::vector<Finding>& before, double rate_before,
                                     const std::vector<Finding>& now, double rate_now);

/// Mean distances between corresponding joints over all common frames, metres.
struct PositionErrors {
  double mpjpe = 0.0;                ///< in world space, without alignment
  double root_relative_mpjpe = 0.0;  ///< relative to the body's root (`RootDifference::joint`)
  double pa_mpjpe = 0.0;  ///< after Procrustes alignment (rotation, scale, translation) of each
                          ///< pose with the first motion's
};

/// Differences of two motions of the canonical body.
struct BodyDifference {
  double d_m = 0.0;      ///< D of distance.h, aligned at the pelvis, over the full durations
  double mpjpe_m = 0.0;  ///< also aligned at the pelvis
  std::array<FootDifference, 2> feet;  ///< left, right
};

/// A motion feature before and after, in the feature's unit; NaN if a motion lacks it.
struct FeatureDifference {
  int feature = 0;  ///< index into motion_features()
  double before = 0.0;
  double now = 0.0;
  /// Whether it changed by more than the measurement error of motion capture
  /// (FeatureChange::moved), or exists in only one of the motions.
  bool is_notable() const;
};

/// Difference of a motion from its earlier version. Lengths are in metres, angles in radians, times
/// in seconds.
///
/// Everything is exactly zero or empty for equal motions. Distances are symmetric if both have the
/// same frame rate and skeleton, except `aligned_m` and `pa_mpjpe`, which are at the scale of the
/// first motion, and `BodyDifference::mpjpe_m`, which is a mean over the frames of the first.
struct MotionDifference {
  bool identical = false;  ///< whether all numbers and names are exactly equal
  /// Whether both were mapped to the canonical body because their rigs differ; the mapping
  /// (calibration, floor) is then part of the comparison.
  bool on_body = false;
  TimingDifference timing;
  std::vector<JointDifference> joints;             ///< joints in both motions; never empty
  std::vector<std::string> only_before, only_now;  ///< joints in one motion only
  /// Renamed joints of recordings: old name, new name. `joints` uses the old names.
  std::vector<std::pair<std::string, std::string>> renamed;
  PositionErrors errors;
  RootDifference root;
  WholeBodyChange whole;
  std::optional<BodyDifference> body;       ///< for human motions only
  std::vector<LintChange> lint;             ///< new, gone, worse or better; empty unless requested
  std::vector<FeatureDifference> features;  ///< from feature_differences; filled in by the caller
  std::vector<std::string> remarks;         ///< sentences, for example on changed units or axes

  double frames_per_second() const { return timing.before.frames_per_second; }
};

struct MotionDifferenceOptions {
  bool lint = true;
  LintOptions lint_options;
};

/// Compares two motions without any alignment or preprocessing. Joints are paired by name, frames
/// by time (paired_motions.h). `body` is computed if both are of the canonical body. Throws Error
/// as `paired` does.
MotionDifference motion_difference(const Clip& before, const Clip& now,
                                   const MotionDifferenceOptions& options = {});

/// Body differences of two clips of the canonical body.
BodyDifference body_difference(const Clip& before, const Clip& now);

/// Lint findings in which the clips differ; empty when they are identical.
std::vector<LintChange> lint_difference(const Clip& before, const Clip& now,
                                        const LintOptions& options = {});

/// Differences of all features that at least one of the motions has, in the order of
/// motion_features().
std::vector<FeatureDifference> feature_differences(const FeatureValues& before,
                                                   const FeatureValues& now);

/// Indices into `joints` of the joints that differ locally (differs_itself), not only through their
/// ancestors, sorted by rotation in descending order.
std::vector<int> causes(const MotionDifference& difference);

/// Whether a joint is the body's root or an ancestor of it, so that its translation moves the
/// whole figure instead of changing a bone.
bool carries_body(const MotionDifference& difference, int joint);

/// Whether only the root's position or orientation differs.
bool is_root_only(const MotionDifference& difference);

/// The joint with the largest value of a curve, and its peak.
struct WorstJoint {
  int joint = 0;
  CurvePeak peak;
};
WorstJoint worst_joint(const MotionDifference& difference,
                       std::vector<double> JointDifference::*curve);

/// Root mean square over all joints and frames.
double root_mean_square(const MotionDifference& difference,
                        std::vector<double> JointDifference::*curve);

}  // namespace mien::motion

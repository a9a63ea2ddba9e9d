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

/// Change of a fault between two motions.
struct LintChange {
  enum class Kind { gone, appeared, worse, better };
  Kind kind = Kind::appeared;
  Finding finding;  ///< of the second motion; one that is gone, of the first
};

/// "gone", "new", "worse", "better".
std::string_view name_of(LintChange::Kind kind);

/// The findings in which two motions differ. Two are one fault when check and
/// joint are the same and their frames touch by time; it is worse or better when its severity
/// changed. Findings of the second come first, in their order, then those that are gone.
std::vector<LintChange> lint_changes(const std::vector<Finding>& before, double rate_before,
                                     const std::vector<Finding>& now, double rate_now);

/// Mean distances between joints over all moments that both motions have, metres.
struct PositionErrors {
  double mpjpe = 0.0;                ///< as they are in the world
  double root_relative_mpjpe = 0.0;  ///< relative to the root joint's position
  double pa_mpjpe = 0.0;  ///< after turning, scaling and moving each pose onto the first's
};

/// Differences of two motions of the canonical body.
struct BodyDifference {
  double d_m = 0.0;      ///< D of distance.h, aligned at the pelvis, over the whole durations
  double mpjpe_m = 0.0;  ///< aligned at the pelvis too
  std::array<FootDifference, 2> feet;  ///< left, right
};

/// A motion feature before and after, in its unit; NaN where a motion has none.
struct FeatureDifference {
  int feature = 0;  ///< index into motion_features()
  double before = 0.0;
  double now = 0.0;
  /// Whether it changed by more than can be measured of a capture (FeatureChange::moved), or is
  /// there in one of them only.
  bool is_notable() const;
};

/// Difference of a motion from its earlier version. All lengths are metres, angles radians, times
/// seconds.
///
/// Everything is exactly zero or empty for equal motions. Distances are symmetric when both have
/// the same frame rate, `aligned_m` and `pa_mpjpe` apart, which are in the size of the first.
struct MotionDifference {
  bool identical = false;  ///< every number of both is the same
  /// Whether both were mapped to the canonical body because their rigs differ; the mapping
  /// (calibration, floor) is then part of the comparison.
  bool on_body = false;
  TimingDifference timing;
  std::vector<JointDifference> joints;             ///< those that both have; never empty
  std::vector<std::string> only_before, only_now;  ///< joints that one has
  /// Renamed joints of recordings: old name, new name. `joints` have the old names.
  std::vector<std::pair<std::string, std::string>> renamed;
  PositionErrors errors;
  RootDifference root;
  WholeBodyChange whole;
  std::optional<BodyDifference> body;  ///< of humans
  std::vector<LintChange> lint;        ///< new, gone, worse or better; empty when not asked for
  std::vector<FeatureDifference> features;  ///< as feature_differences has them; the caller's
  std::vector<std::string> remarks;         ///< plain sentences: units or axes that changed

  double frames_per_second() const { return timing.before.frames_per_second; }
};

struct MotionDifferenceOptions {
  bool lint = true;
  LintOptions lint_options;
};

/// Compares two motions as they are: nothing is settled, moved or turned first. Joints are paired
/// by name, moments by time (paired_motions.h). BodyDifference is made when both are of the
/// canonical body. Throws Error as `paired` does.
MotionDifference motion_difference(const Clip& before, const Clip& now,
                                   const MotionDifferenceOptions& options = {});

/// Body differences of two clips of the canonical body.
BodyDifference body_difference(const Clip& before, const Clip& now);

/// Lint findings in which the clips differ; empty when they are identical.
std::vector<LintChange> lint_difference(const Clip& before, const Clip& now,
                                        const LintOptions& options = {});

/// Differences of all features, in the order of motion_features(), that at least one of the two
/// has.
std::vector<FeatureDifference> feature_differences(const FeatureValues& before,
                                                   const FeatureValues& now);

/// The joints that differ themselves (differs_itself) and not only through their ancestors, sorted
/// by rotation, largest first. Indices into `joints`.
std::vector<int> causes(const MotionDifference& difference);

/// Whether a joint is the body's root or its ancestor, so that its translation is the figure's path
/// and not a bone.
bool carries_body(const MotionDifference& difference, int joint);

/// Whether only the root's position or orientation differs.
bool is_root_only(const MotionDifference& difference);

/// The joint and frame of a maximum.
struct WorstJoint {
  int joint = 0;
  CurvePeak peak;
};
WorstJoint worst_joint(const MotionDifference& difference,
                       std::vector<double> JointDifference::*curve);

/// Root mean square over all joints and moments.
double root_mean_square(const MotionDifference& difference,
                        std::vector<double> JointDifference::*curve);

}  // namespace mien::motion

#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "motion/lint/lint_options.h"
#include "motion/measures/differences/contact_difference.h"
#include "motion/measures/differences/joint_difference.h"
#include "motion/measures/differences/lint_difference.h"
#include "motion/measures/differences/timing_difference.h"
#include "motion/measures/differences/whole_change.h"
#include "motion/measures/features/motion_features.h"

namespace mien::motion {

/// Mean distances between joints over all moments that both motions have, metres.
struct PositionErrors {
  double mpjpe = 0.0;         ///< as they are in the world
  double rooted_mpjpe = 0.0;  ///< both seen from their root joint's place
  double pa_mpjpe = 0.0;      ///< after turning, scaling and moving each pose onto the first's
};

/// What can be said of two motions of the canonical body.
struct BodyDifference {
  double d_m = 0.0;      ///< D of distance.h, aligned at the pelvis, over the whole durations
  double mpjpe_m = 0.0;  ///< likewise aligned
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

/// How a motion differs from what it was. All lengths are metres, angles radians, times seconds.
///
/// Everything is exactly zero or empty for equal motions. Distances are symmetric when both have
/// the same frame rate, `aligned_m` and `pa_mpjpe` apart, which are in the size of the first.
struct MotionDifference {
  bool identical = false;  ///< every number of both is the same
  /// Rigs differ, so that both were put on the canonical body first: then what lies between rig and
  /// body (calibration, the floor) is part of what is compared.
  bool on_body = false;
  TimingDifference timing;
  std::vector<JointDifference> joints;             ///< those that both have; never empty
  std::vector<std::string> only_before, only_now;  ///< joints that one has
  /// Joints that are called otherwise now, of recordings: was, is. `joints` have the names of then.
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

/// Both of the canonical body.
BodyDifference body_difference(const Clip& before, const Clip& now);

/// What lint finds in one of the clips and not in the other; nothing when they are identical.
std::vector<LintChange> lint_difference(const Clip& before, const Clip& now,
                                        const LintOptions& options = {});

/// All features, in the order of motion_features(), that one of the two has.
std::vector<FeatureDifference> feature_differences(const FeatureValues& before,
                                                   const FeatureValues& now);

/// Joints that do something else themselves (differs_itself), by how far they turn, the largest
/// first: the causes, where others are only carried along. Indices into `joints`.
std::vector<int> causes(const MotionDifference& difference);

/// Whether a joint is the body's root or above it: where it is placed is the figure's path, and no
/// bone.
bool carries_body(const MotionDifference& difference, int joint);

/// Whether the body is placed or turned otherwise and no joint below its root does anything else.
bool is_root_only(const MotionDifference& difference);

/// A joint and moment at which something is largest.
struct WorstJoint {
  int joint = 0;
  Peak peak;
};
WorstJoint worst_joint(const MotionDifference& difference,
                       std::vector<double> JointDifference::*curve);

/// Root mean square over all joints and moments.
double root_mean_square(const MotionDifference& difference,
                        std::vector<double> JointDifference::*curve);

}  // namespace mien::motion

#include <algorithm>
#include <cmath>

#include "motion/lint/checks.h"
#include "motion/lint/threshold_findings.h"
#include "motion/math/percentile.h"

namespace mien::motion {

namespace {

bool is_finite(const Quat& rotation) { return rotation.coeffs().allFinite(); }

/// The motion of checks that calculate nothing: the frames as they are.
LintMotion as_given(const Clip& clip) {
  LintMotion motion;
  motion.clip.frames_per_second = clip.frames_per_second;
  motion.frames = clip.frame_count();
  return motion;
}

std::string joint_name(const Clip& clip, int joint) { return clip.body.joints[joint].name; }

void find_non_finite(const Clip& clip, Findings& findings) {
  for (int j = 0; j < clip.body.size(); ++j) {
    std::vector<double> broken(clip.poses.size(), 0.0);
    for (int t = 0; t < clip.frame_count(); ++t) {
      const Pose& pose = clip.poses[t];
      const bool fine = is_finite(pose.rotations[j]) && (j > 0 || pose.root_position.allFinite()) &&
                        (pose.offsets.empty() || pose.offsets[j].allFinite());
      broken[t] = fine ? 0.0 : 1.0;
    }
    const std::string name = joint_name(clip, j);
    const auto sentence = [&](double) {
      return "The " + display_name(name) + " has invalid numbers (NaN or infinite).";
    };
    add_threshold_findings(findings, as_given(clip),
                           {"non-finite", name, "", {0.5, 0.5}, 0, 1, sentence}, broken);
  }
}

void find_non_unit(const Clip& clip, const LintOptions& options, Findings& findings) {
  for (int j = 0; j < clip.body.size(); ++j) {
    std::vector<double> error;
    for (const Pose& pose : clip.poses) error.push_back(std::abs(pose.rotations[j].norm() - 1.0));
    const std::string name = joint_name(clip, j);
    const auto sentence = [&](double worst) {
      return "The quaternion of the " + display_name(name) +
             " is not a valid rotation: its length is off by " + rounded(worst, 6) + ".";
    };
    add_threshold_findings(findings, as_given(clip),
                           {"rotation-not-unit", name, "", options.unit_error, 0, 1, sentence},
                           error);
  }
}

/// Whether a joint lies on the way from the root to where the skeleton first branches: rigs move
/// the figure there as well as at the root.
std::vector<bool> carries_the_figure(const Skeleton& skeleton) {
  const auto children = children_of(skeleton);
  std::vector<bool> result(children.size(), false);
  for (size_t j = 0; j < children.size(); ++j) {
    const int parent = skeleton.joints[j].parent;
    result[j] = parent < 0 || (result[parent] && children[parent].size() == 1);
  }
  return result;
}

/// A shorter bone (two joints in one place, but for rounding) has no length of its own: it is held
/// against this share of the longest.
constexpr double shortest_bone = 0.01;

double longest_bone(const Skeleton& skeleton) {
  double longest = 0.0;
  for (const Joint& joint : skeleton.joints) {
    if (joint.parent >= 0) longest = std::max(longest, joint.offset.norm());
  }
  return longest;
}

void find_bone_drift(const Clip& clip, const LintOptions& options, Findings& findings) {
  const auto has_offsets = [](const Pose& pose) { return !pose.offsets.empty(); };
  if (std::none_of(clip.poses.begin(), clip.poses.end(), has_offsets)) return;
  const std::vector<bool> is_moved = carries_the_figure(clip.body);
  const double least = shortest_bone * longest_bone(clip.body);
  for (int j = 1; j < clip.body.size(); ++j) {
    if (is_moved[j]) continue;
    std::vector<double> lengths;
    for (const Pose& pose : clip.poses) {
      lengths.push_back(
          (pose.offsets.empty() ? clip.body.joints[j].offset : pose.offsets[j]).norm());
    }
    const double usual = percentile(lengths, 50);
    const double whole = std::max(usual, least);
    if (!(whole > 0.0)) continue;
    for (double& length : lengths) length = std::abs(length - usual) / whole;
    const std::string name = joint_name(clip, j);
    const auto sentence = [&](double worst) {
      return "The bone leading to the " + display_name(name) + " changes its length by " +
             rounded(100.0 * worst, 1) + " %.";
    };
    add_threshold_findings(findings, as_given(clip),
                           {"bone-length", name, "", options.bone_drift, 0, 1, sentence}, lengths);
  }
}

}  // namespace

Findings find_broken_data(const Clip& clip, const LintOptions& options) {
  Findings findings;
  find_non_finite(clip, findings);
  find_non_unit(clip, options, findings);
  find_bone_drift(clip, options, findings);
  return findings;
}

bool is_calculable(const Clip& clip) {
  return std::all_of(clip.poses.begin(), clip.poses.end(), [](const Pose& pose) {
    const auto fine = [](const Quat& q) { return is_finite(q) && q.norm() > 1e-3; };
    const auto finite = [](const Vec3& v) { return v.allFinite(); };
    return pose.root_position.allFinite() &&
           std::all_of(pose.rotations.begin(), pose.rotations.end(), fine) &&
           std::all_of(pose.fingers.begin(), pose.fingers.end(), fine) &&
           std::all_of(pose.offsets.begin(), pose.offsets.end(), finite);
  });
}

}  // namespace mien::motion

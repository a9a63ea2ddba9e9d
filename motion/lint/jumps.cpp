#include <algorithm>
#include <cmath>

#include "motion/lint/checks.h"
#include "motion/lint/steps.h"
#include "motion/lint/threshold_findings.h"
#include "motion/math/percentile.h"
#include "motion/math/rotation.h"

namespace mien::motion {

namespace {

// Shares of a step by which the next may differ from it: limbs are flung, whole bodies are not.
constexpr double flung = 0.5;
constexpr double pushed = 0.2;

/// Steps from each frame to the next.
std::vector<Vec3> turns(const Clip& clip, int joint) {
  std::vector<Vec3> steps;
  for (int t = 0; t + 1 < clip.frame_count(); ++t) {
    const Quat& from = clip.poses[t].rotations[joint];
    steps.push_back(log(from.conjugate() * clip.poses[t + 1].rotations[joint]));
  }
  return steps;
}

std::vector<Vec3> root_steps(const Clip& clip) {
  std::vector<Vec3> steps;
  for (int t = 0; t + 1 < clip.frame_count(); ++t) {
    steps.push_back(clip.poses[t + 1].root_position - clip.poses[t].root_position);
  }
  return steps;
}

std::vector<double> lengths(const std::vector<Vec3>& steps) {
  std::vector<double> result;
  for (const Vec3& step : steps) result.push_back(step.norm());
  return result;
}

/// The usual excess of a quarter second around: limbs that are shaken fast step far in every frame
/// of a slow recording, a leap stands alone.
std::vector<double> usual(const std::vector<double>& excess, double rate) {
  const int count = static_cast<int>(excess.size());
  const int reach = std::max(3, static_cast<int>(std::lround(0.25 * rate)));
  std::vector<double> result;
  for (int i = 0; i < count; ++i) {
    const auto first = excess.begin() + std::max(0, i - reach);
    const auto last = excess.begin() + std::min(count, i + reach + 1);
    result.push_back(percentile(std::vector<double>(first, last), 50));
  }
  return result;
}

/// How far a joint's steps leap: beyond what is usual around, and beyond the share of their
/// neighbours by which limbs that are flung change.
std::vector<double> leaps_of_joint(const std::vector<Vec3>& turns, double rate) {
  std::vector<double> leaps = excesses(turns);
  const std::vector<double> around = usual(leaps, rate);
  const std::vector<double> pace = paces(turns);
  for (size_t i = 0; i < leaps.size(); ++i) leaps[i] -= std::max(around[i], flung * pace[i]);
  return leaps;
}

std::vector<double> leaps_of_body(const std::vector<Vec3>& steps) {
  std::vector<double> leaps = excesses(steps);
  const std::vector<double> pace = paces(steps);
  for (size_t i = 0; i < leaps.size(); ++i) leaps[i] -= pushed * pace[i];
  return leaps;
}

/// Toes flick when they leave the floor: by nearly 40° in one thirtieth of a second as captured.
double flick(const LintMotion& motion, int joint) {
  const bool is_toe = is_body(motion.clip.body) && (joint == LeftToe || joint == RightToe);
  return is_toe ? 1.5 : 1.0;
}

std::vector<double> in_degrees(std::vector<double> radians) {
  for (double& value : radians) value /= radians_per_degree;
  return radians;
}

/// How many joints, and the root, leap at each step.
std::vector<int> leaping_joints(const LintMotion& motion, const LintOptions& options) {
  const double rate = motion.rate();
  std::vector<int> counts(std::max(motion.frame_count() - 1, 0), 0);
  const auto add = [&](const std::vector<double>& leaps, double level) {
    for (size_t i = 0; i < leaps.size(); ++i) counts[i] += leaps[i] > level ? 1 : 0;
  };
  for (int j = 0; j < motion.clip.body.size(); ++j) {
    add(in_degrees(leaps_of_joint(turns(motion.clip, j), rate)),
        flick(motion, j) * at_rate(options.jump_degrees, rate).warning);
  }
  add(leaps_of_body(root_steps(motion.clip)), at_rate(options.jump_metres, rate).warning);
  return counts;
}

/// Whether half of all joints, or more, step farther at step `i` than in any of the steps that
/// follow it: out of a pose that is another altogether, however near its limbs may be.
bool is_another_pose(const LintMotion& motion, int i) {
  const int after = static_cast<int>(std::ceil(take_limits.calibration_seconds * motion.rate()));
  int joints = 0;
  for (int j = 0; j < motion.clip.body.size(); ++j) {
    const std::vector<double> steps = in_degrees(lengths(turns(motion.clip, j)));
    const auto next = steps.begin() + i + 1;
    const auto end = next + std::min<std::ptrdiff_t>(after, steps.end() - next);
    const double usual = next == end ? 0.0 : *std::max_element(next, end);
    joints += steps[i] > std::max(1.0, take_limits.calibration_times * usual) ? 1 : 0;
  }
  return joints > take_limits.calibration_joints && 2 * joints >= motion.clip.body.size();
}

/// The step over the seam at the end of the middle lap beyond twice what the loop does elsewhere.
double seam_excess(const LintMotion& motion, const std::vector<double>& steps) {
  std::vector<double> elsewhere;
  for (int i = motion.start; i < motion.start + motion.frames - 1; ++i) {
    const bool is_beside = i < motion.start + 2 || i > motion.start + motion.frames - 4;
    if (!is_beside) elsewhere.push_back(steps[i]);
  }
  const double usual = elsewhere.empty() ? 0.0 : percentile(elsewhere, 95);
  return steps[motion.start + motion.frames - 1] - 2.0 * usual;
}

void add_seam(const LintMotion& motion, const MeasuredFault& fault, double excess,
              Findings& findings) {
  std::vector<double> values(motion.frame_count(), no_value);
  values[motion.start + motion.frames - 1] = excess;
  add_threshold_findings(findings, motion, fault, values);
}

}  // namespace

Findings find_jumps(const LintMotion& motion, const LintOptions& options) {
  Findings findings;
  for (int j = 0; j < motion.clip.body.size(); ++j) {
    const std::string& name = motion.clip.body.joints[j].name;
    const auto sentence = [&](double worst) {
      return "The " + display_name(name) + " jumps by " + rounded(worst, 0) +
             "° from one frame to the next.";
    };
    const std::vector<double> leaps =
        in_degrees(leaps_of_joint(turns(motion.clip, j), motion.rate()));
    const Levels steady = at_rate(options.jump_degrees, motion.rate());
    const double flicked = flick(motion, j);
    const Levels levels = {flicked * steady.warning, flicked * steady.error};
    add_threshold_findings(findings, motion, {"jump", name, "°", levels, 0, 1, sentence},
                           without_seams(motion, leaps));
  }
  const auto sentence = [](double worst) {
    return "The whole body jumps by " + rounded(100.0 * worst, 0) +
           " cm from one frame to the next.";
  };
  add_threshold_findings(
      findings, motion,
      {"jump", "", "m", at_rate(options.jump_metres, motion.rate()), 0, 1, sentence},
      without_seams(motion, leaps_of_body(root_steps(motion.clip))));
  return findings;
}

Findings find_calibration_pose(const LintMotion& motion, const LintOptions& options) {
  if (motion.was_loop || motion.frame_count() < 4) return {};
  const std::vector<int> leaping = leaping_joints(motion, options);
  const int few = std::max(3, static_cast<int>(take_limits.calibration_seconds * motion.rate()));
  bool has_moved = false;
  for (int i = 0; i + 2 < static_cast<int>(leaping.size()); ++i) {
    if (i >= few && has_moved) break;
    const bool is_left = leaping[i] > take_limits.calibration_joints ||
                         (leaping[i] > 0 && is_another_pose(motion, i));
    if (is_left) {
      Finding finding;
      finding.check = "calibration-pose";
      finding.last = i;
      finding.measured = leaping[i];
      finding.threshold = take_limits.calibration_joints;
      finding.unit = "joints";
      finding.severity = Severity::error;
      finding.sentence =
          std::string("The take begins with a different pose, such as for calibration: ") +
          std::to_string(leaping[i]) + (leaping[i] == 1 ? " joint jumps" : " joints jump at once") +
          " after it.";
      return {finding};
    }
    has_moved = has_moved || !is_frozen(motion, i);
  }
  return {};
}

Findings find_broken_seam(const LintMotion& motion, const LintOptions& options) {
  Findings findings;
  if (!motion.was_loop || motion.frames < 8) return findings;
  for (int j = 0; j < motion.clip.body.size(); ++j) {
    const std::string& name = motion.clip.body.joints[j].name;
    const auto sentence = [&](double worst) {
      return "The loop does not close: the " + display_name(name) + " jumps by " +
             rounded(worst, 1) + "° at its seam.";
    };
    const std::vector<double> steps = in_degrees(excesses(turns(motion.clip, j)));
    add_seam(motion, {"loop-seam", name, "°", options.seam_degrees, 0, 1, sentence},
             seam_excess(motion, steps), findings);
  }
  const auto sentence = [](double worst) {
    return "The loop does not close: the whole body jumps by " + rounded(100.0 * worst, 1) +
           " cm at its seam.";
  };
  add_seam(motion, {"loop-seam", "", "m", options.seam_metres, 0, 1, sentence},
           seam_excess(motion, excesses(root_steps(motion.clip))), findings);
  return findings;
}

}  // namespace mien::motion

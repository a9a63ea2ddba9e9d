#include <algorithm>
#include <cmath>

#include "motion/lint/checks.h"
#include "motion/lint/limb_ends.h"
#include "motion/lint/path_noise.h"
#include "motion/lint/steps.h"
#include "motion/lint/threshold_findings.h"

namespace mien::motion {

namespace {

constexpr double surroundings_seconds = 0.3;  // before and after a step
constexpr int own_steps = 2;                  // around a jump, which changes them too
constexpr double times_largest = 1.5;         // a jump is so much larger than any other change
constexpr double times_roughness = 12.0;      // standard deviations; larger than noise by chance
constexpr double flung_share = 0.5;           // share of a step by which the next may differ

std::vector<Vec3> steps_of(const std::vector<Vec3>& path) {
  std::vector<Vec3> steps;
  for (size_t t = 0; t + 1 < path.size(); ++t) steps.push_back(path[t + 1] - path[t]);
  return steps;
}

/// How far each step deviates from the mean of its neighbours and from each of them,
/// whichever is least. A foot that lands changes its velocity at once, and its steps deviate from
/// one neighbour only. 0 for the first and the last step, which have only one.
std::vector<double> deviations(const std::vector<Vec3>& steps) {
  const std::vector<double> from_mean = excesses(steps);
  std::vector<double> result(steps.size(), 0.0);
  for (size_t i = 1; i + 1 < steps.size(); ++i) {
    result[i] = std::min(
        {from_mean[i], (steps[i] - steps[i - 1]).norm(), (steps[i] - steps[i + 1]).norm()});
  }
  return result;
}

/// The largest of the values around each but for its neighbours.
std::vector<double> largest_around(const std::vector<double>& values, double rate) {
  const int count = static_cast<int>(values.size());
  const int reach = std::max(6, static_cast<int>(std::lround(surroundings_seconds * rate)));
  std::vector<double> largest(values.size(), 0.0);
  for (int i = 0; i < count; ++i) {
    for (int k = std::max(0, i - reach); k <= std::min(count - 1, i + reach); ++k) {
      if (std::abs(k - i) > own_steps) largest[i] = std::max(largest[i], values[k]);
    }
  }
  return largest;
}

/// How far the steps of a limb's end leap, metres of a stature of 1.75 m; 0 where others around do
/// as well, or where the path is rough.
std::vector<double> leaps_of_end(const LintMotion& motion, int end) {
  const std::vector<Vec3> steps = steps_of(path_from_pelvis(motion, end));
  std::vector<double> leaps = deviations(steps);
  const std::vector<double> around = largest_around(leaps, motion.rate());
  const std::vector<double> pace = paces(steps);
  const std::vector<double> roughness = path_roughness(motion, end);
  for (size_t i = 0; i < leaps.size(); ++i) {
    const bool is_alone = leaps[i] > times_largest * around[i] &&
                          leaps[i] > times_roughness * motion.scale * roughness[i];
    leaps[i] = is_alone ? (leaps[i] - flung_share * pace[i]) / motion.scale : 0.0;
  }
  return leaps;
}

/// Whether a joint named so carries the end of a limb, which then jumps with it.
bool is_carried_by(const Skeleton& body, int end, const std::string& joint) {
  for (int j = end; j >= 0; j = body.joints[j].parent) {
    if (body.joints[j].name == joint) return true;
  }
  return false;
}

}  // namespace

Findings find_limb_jumps(const LintMotion& motion, const LintOptions& options,
                         const Findings& joint_jumps) {
  Findings findings;
  const Levels levels = at_rate(options.limb_jump_metres, motion.rate());
  for (const int end : limb_ends) {
    const std::string name(name_of(BodyJoint(end)));
    const auto sentence = [&](double worst) {
      return "The " + display_name(name) + " jumps by " + rounded(100.0 * worst, 0) +
             " cm from one frame to the next.";
    };
    Findings found;
    add_threshold_findings(found, motion, {"jump", name, "m", levels, 0, 1, sentence},
                           without_seams(motion, leaps_of_end(motion, end)));
    std::erase_if(found, [&](const Finding& jump) {
      return std::any_of(joint_jumps.begin(), joint_jumps.end(), [&](const Finding& joint) {
        const bool is_as_severe =
            joint.severity == Severity::error || jump.severity == Severity::warning;
        return is_as_severe && joint.first <= jump.last && joint.last >= jump.first &&
               is_carried_by(motion.clip.body, end, joint.joint);
      });
    });
    findings.insert(findings.end(), found.begin(), found.end());
  }
  return findings;
}

}  // namespace mien::motion

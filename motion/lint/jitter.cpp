#include "motion/lint/checks.h"
#include "motion/lint/limb_ends.h"
#include "motion/lint/path_noise.h"
#include "motion/lint/threshold_findings.h"

namespace mien::motion {

namespace {

constexpr double least_rate = 20.0;  // Hz; below, smooth movement is taken for noise

}  // namespace

Findings find_jitter(const LintMotion& motion, const LintOptions& options,
                     const LintMotion* original) {
  Findings findings;
  if (motion.rate() < least_rate) return findings;
  for (const int end : limb_ends) {
    const std::string name(name_of(BodyJoint(end)));
    const auto sentence = [&](double worst) {
      return "The " + display_name(name) + " trembles at random by " + rounded(1000.0 * worst, 1) +
             " mm (standard deviation) from frame to frame.";
    };
    const Levels levels = raised_levels(
        options.jitter_metres, original ? path_noise(*original, end) : std::vector<double>());
    add_threshold_findings(findings, motion, {"jitter", name, "m", levels, 0, 1, sentence},
                           path_noise(motion, end));
  }
  return findings;
}

}  // namespace mien::motion

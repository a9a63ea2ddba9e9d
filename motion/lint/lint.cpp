#include "motion/lint/lint.h"

namespace mien::motion {

const std::vector<LintCheck>& lint_checks() {
  static const std::vector<LintCheck> checks = {
      {"non-finite", "numbers that are none"},
      {"rotation-not-unit", "rotations that are none"},
      {"bone-length", "bones that grow or shrink"},
      {"jump", "poses that leap from one frame to the next"},
      {"loop-seam", "a loop's end that does not meet its start"},
      {"joint-limit", "joints beyond their range"},
      {"joint-speed", "joints that turn too fast"},
      {"jerk", "jerkier hands, feet or head than the original's", true},
      {"self-intersection", "parts of the body in each other"},
      {"foot-skate", "planted feet that slide"},
      {"penetration", "feet below the floor"},
      {"floating", "a body that hangs above the floor"},
      {"contact-timing", "feet that come down or leave at other times than the original's", true},
      {"limb-phase", "limbs that come earlier or later than the original's", true},
      {"balance", "a body that would fall"},
      {"forces", "forces between feet and floor that there are not"},
      {"joint-torque", "torques that nobody's joints have"},
  };
  return checks;
}

std::vector<Finding> lint(const Clip& /*clip*/, const LintOptions& /*options*/,
                          const Clip* /*original*/) {
  return {};
}

}  // namespace mien::motion

#include "motion/biomechanics/body_on_floor.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mien::motion {

BodyOnFloor body_on_floor(const LintSubject& subject) {
  return {body_dynamics(subject), supports(subject)};
}

void mask_ends(const LintSubject& subject, std::vector<double>& values) {
  if (subject.was_loop) return;
  const long count = static_cast<long>(values.size());
  const long ends = std::min(count, std::lround(0.1 * subject.rate()) + 1);
  const double nothing = std::numeric_limits<double>::quiet_NaN();
  std::fill(values.begin(), values.begin() + ends, nothing);
  std::fill(values.end() - ends, values.end(), nothing);
}

}  // namespace mien::motion

#include "motion/measures/differences/motion_tolerance.h"

#include <algorithm>
#include <cmath>

namespace mien::motion {

namespace {

/// Seconds; a contact that is new or gone counts as shifted by its length.
double worst_contact_shift(const BodyDifference& body) {
  double worst = 0.0;
  for (const FootDifference& foot : body.feet) {
    for (const ContactChange& change : foot.changes) {
      const bool shifted = change.kind == ContactChange::Kind::shifted;
      worst = std::max(worst,
                       shifted ? std::max(std::abs(change.begin_shift), std::abs(change.end_shift))
                               : change.end_seconds - change.begin_seconds);
    }
  }
  return worst;
}

double worst_slide(const BodyDifference& body) {
  return std::max(body.feet[0].slide_m, body.feet[1].slide_m);
}

double new_errors(const MotionDifference& difference) {
  return static_cast<double>(std::ranges::count_if(difference.lint, [](const LintChange& change) {
    const bool is_new =
        change.kind == LintChange::Kind::appeared || change.kind == LintChange::Kind::worse;
    return is_new && change.finding.severity == Severity::error;
  }));
}

double rate_apart(const TimingDifference& timing) {
  if (same_rate(timing.before.frames_per_second, timing.now.frames_per_second)) return 0.0;
  return std::abs(timing.now.frames_per_second - timing.before.frames_per_second);
}

/// How far the longest of two motions goes on after the other.
double duration_apart(const TimingDifference& timing) {
  // Rounding of frame rates in files adds up over long motions.
  if (timing.before.frames == timing.now.frames && rate_apart(timing) == 0.0) return 0.0;
  return std::abs(timing.now.seconds - timing.before.seconds);
}

}  // namespace

std::vector<Excess> excesses(const MotionDifference& difference, const MotionTolerance& tolerance) {
  std::vector<Excess> result;
  if (difference.identical) return result;
  const auto judge = [&](const char* measure, double measured, double allowed, const char* unit) {
    // So that a tolerance that is no number allows nothing.
    if (!(measured <= allowed)) result.push_back({measure, measured, allowed, unit});
  };
  const auto worst = [&](std::vector<double> JointDifference::*curve) {
    return worst_joint(difference, curve).peak.value;
  };
  const TimingDifference& timing = difference.timing;
  judge("position", worst(&JointDifference::point_m), tolerance.position_m, "m");
  judge("rotation", worst(&JointDifference::turn_radians), tolerance.rotation_radians, "rad");
  judge("velocity", worst(&JointDifference::velocity_m_s), tolerance.velocity_m_s, "m/s");
  if (difference.body) {
    judge("contacts", worst_contact_shift(*difference.body), tolerance.contact_seconds, "s");
    judge("slide", worst_slide(*difference.body), tolerance.slide_m, "m");
  }
  judge("duration", duration_apart(timing), tolerance.duration_seconds, "s");
  if (!tolerance.any_rate) judge("frame-rate", rate_apart(timing), 0.0, "frames/s");
  judge("loop", timing.before.loops == timing.now.loops ? 0.0 : 1.0, 0.0, "");
  judge("joints",
        static_cast<double>(difference.only_before.size() + difference.only_now.size() +
                            difference.renamed.size()),
        0.0, "");
  if (!tolerance.any_lint) judge("lint", new_errors(difference), 0.0, "");
  return result;
}

}  // namespace mien::motion

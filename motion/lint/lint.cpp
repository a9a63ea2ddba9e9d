#include "motion/lint/lint.h"

#include <algorithm>
#include <tuple>

#include "motion/lint/checks.h"

namespace mien::motion {

const std::vector<LintCheck>& lint_checks() {
  static const std::vector<LintCheck> checks = {
      {"non-finite", "invalid numbers"},
      {"rotation-not-unit", "invalid rotations"},
      {"bone-length", "bones that grow or shrink"},
      {"calibration-pose", "a different pose before the motion, such as a T-pose"},
      {"frozen", "stretches in which nothing moves at all"},
      {"jump", "jumps from one frame to the next"},
      {"loop-seam", "loops that do not close"},
      {"joint-limit", "joints beyond their range"},
      {"joint-speed", "joints that rotate too fast"},
      {"jerk", "hands, feet or head jerkier than in the original", true},
      {"self-intersection", "interpenetrating body parts"},
      {"on-the-spot",
       "walking in place (not a fault); reports the speed of the belt on which the feet would not "
       "slide"},
      {"drift", "steady drift of the whole body"},
      {"foot-skate", "planted feet that slide"},
      {"penetration", "feet below the floor"},
      {"floating", "a body floating above the floor"},
      {"contact-timing", "foot contacts at other times than in the original", true},
      {"limb-phase", "limbs earlier or later than in the original", true},
      {"balance", "loss of balance"},
      {"forces", "impossible ground reaction forces"},
      {"joint-torque", "excessive joint torques"},
  };
  return checks;
}

namespace {

/// Feet that slide because the whole body does are no fault of their own.
Findings not_of_drift(Findings slips, const Findings& drift) {
  std::erase_if(slips, [&](const Finding& slip) {
    return std::any_of(drift.begin(), drift.end(), [&](const Finding& whole) {
      return slip.first <= whole.last && slip.last >= whole.first;
    });
  });
  return slips;
}

void check_motion(const LintSubject& subject, const LintOptions& options,
                  const LintSubject* original, Findings& findings) {
  const auto add = [&findings](const Findings& more) {
    findings.insert(findings.end(), more.begin(), more.end());
  };
  add(find_frozen(subject, original));
  add(find_jumps(subject, options));
  add(find_broken_seam(subject, options));
  if (!is_body(subject.clip.body)) return;
  add(find_joints_beyond_limits(subject, options, original));
  add(find_fast_joints(subject, options, original));
  add(find_self_intersections(subject, options, original));
  const Findings drift = find_drift(subject, options, original);
  add(find_walk_on_spot(subject, original));
  add(drift);
  add(find_rise(subject, original));
  add(not_of_drift(find_skating_feet(subject, options, original), drift));
  add(find_sunken_feet(subject, options, original));
  add(find_floating(subject, options, original));
  if (original) {
    add(find_jerks(subject, options, *original));
    add(find_shifted_contacts(subject, options, *original));
    add(find_shifted_limbs(subject, options, *original));
  }
  const BodyOnFloor body = body_on_floor(subject);
  const BodyOnFloor before = original ? body_on_floor(*original) : BodyOnFloor();
  const BodyOnFloor* original_body = original ? &before : nullptr;
  add(find_lost_balance(subject, body, options, original, original_body));
  add(find_unnatural_forces(subject, body, options, original, original_body));
  add(find_unnatural_torques(subject, body, options, original, original_body));
}

/// A motion from where it moves on: without the pose of a calibration at its start, which would be
/// found at fault by every check.
struct MovingPart {
  LintSubject subject;
  int first = 0;  ///< of its frames, in the motion
  std::optional<Finding> calibration;
};

MovingPart moving_part(const Clip& clip, const LintOptions& options) {
  LintSubject whole = lint_subject(clip);
  const Findings found = find_calibration_pose(whole, options);
  if (found.empty()) return {std::move(whole), 0, std::nullopt};
  const int first = found[0].last + 1;
  Clip rest = clip;
  rest.poses.erase(rest.poses.begin(), rest.poses.begin() + first);
  return {lint_subject(rest), first, found[0]};
}

size_t rank_of(const Finding& finding) {
  const auto& checks = lint_checks();
  const auto found = std::find_if(checks.begin(), checks.end(), [&](const LintCheck& check) {
    return check.id == finding.check;
  });
  return static_cast<size_t>(found - checks.begin());
}

void put_in_order(Findings& findings) {
  std::stable_sort(findings.begin(), findings.end(), [](const Finding& a, const Finding& b) {
    return std::tuple(rank_of(a), a.first, a.joint) < std::tuple(rank_of(b), b.first, b.joint);
  });
}

}  // namespace

std::vector<Finding> lint(const Clip& clip, const LintOptions& options, const Clip* original) {
  if (clip.poses.empty()) return {};
  Findings findings = find_broken_data(clip, options);
  if (is_calculable(clip)) {
    std::optional<LintSubject> before;
    if (original && is_body(original->body) && is_calculable(*original)) {
      before = moving_part(*original, options).subject;
    }
    const MovingPart part = moving_part(clip, options);
    Findings of_part;
    check_motion(part.subject, options, before ? &*before : nullptr, of_part);
    for (Finding& finding : of_part) {
      finding.first += part.first;
      finding.last += part.first;
    }
    findings.insert(findings.end(), of_part.begin(), of_part.end());
    if (part.calibration) findings.push_back(*part.calibration);
  }
  put_in_order(findings);
  return findings;
}

std::optional<Finding> calibration_pose(const Clip& clip) {
  if (clip.poses.empty() || !is_body(clip.body) || !is_calculable(clip)) return std::nullopt;
  const Findings found = find_calibration_pose(lint_subject(clip), LintOptions());
  if (found.empty()) return std::nullopt;
  return found[0];
}

std::vector<Finding> lint(const Recording& recording, const LintOptions& options) {
  Clip clip;
  clip.body = recording.skeleton;
  clip.frames_per_second = recording.frames_per_second;
  clip.poses = recording.poses;
  Findings findings = find_broken_data(clip, options);
  put_in_order(findings);
  return findings;
}

}  // namespace mien::motion

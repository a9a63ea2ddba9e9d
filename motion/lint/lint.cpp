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
      {"jitter", "hands, feet or head that tremble at random"},
      {"loop-seam", "loops that do not close"},
      {"joint-limit", "joints beyond their range"},
      {"finger-limit", "fingers beyond their range"},
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
      {"still-limb", "limbs that hardly move any more", true},
      {"balance", "loss of balance"},
      {"forces", "impossible ground reaction forces"},
      {"joint-torque", "excessive joint torques"},
      {"fit-residual", "recorded points far from the body fitted to them"},
  };
  return checks;
}

namespace {

/// Removes findings of sliding feet where the whole body slides.
Findings not_of_drift(Findings slips, const Findings& drift) {
  std::erase_if(slips, [&](const Finding& slip) {
    return std::any_of(drift.begin(), drift.end(), [&](const Finding& whole) {
      return slip.first <= whole.last && slip.last >= whole.first;
    });
  });
  return slips;
}

void check_motion(const LintMotion& motion, const LintOptions& options, const LintMotion* original,
                  Findings& findings) {
  const auto add = [&findings](const Findings& more) {
    findings.insert(findings.end(), more.begin(), more.end());
  };
  add(find_frozen(motion, original));
  const Findings jumps = find_jumps(motion, options);
  add(jumps);
  add(find_broken_seam(motion, options));
  if (!is_body(motion.clip.body)) return;
  add(find_limb_jumps(motion, options, jumps));
  add(find_jitter(motion, options, original));
  add(find_joints_beyond_limits(motion, options, original));
  add(find_backward_elbows(motion, options, original));
  add(find_fingers_beyond_limits(motion, options, original));
  add(find_fast_joints(motion, options, original));
  add(find_self_intersections(motion, options, original));
  const Findings drift = find_drift(motion, options, original);
  add(find_walk_on_spot(motion, original));
  add(drift);
  add(find_rise(motion, original));
  add(not_of_drift(find_skating_feet(motion, options, original), drift));
  add(find_sunken_feet(motion, options, original));
  add(find_floating(motion, options, original));
  if (original) {
    add(find_jerks(motion, options, *original));
    add(find_shifted_contacts(motion, options, *original));
    add(find_shifted_limbs(motion, options, *original));
    add(find_still_limbs(motion, options, *original));
  }
  const BodyOnFloor body = body_on_floor(motion);
  const BodyOnFloor before = original ? body_on_floor(*original) : BodyOnFloor();
  const BodyOnFloor* original_body = original ? &before : nullptr;
  add(find_lost_balance(motion, body, options, original, original_body));
  add(find_unnatural_forces(motion, body, options, original, original_body));
  add(find_unnatural_torques(motion, body, options, original, original_body));
}

/// A motion from where it moves on: without the pose of a calibration at its start, which would be
/// found at fault by every check.
struct MovingPart {
  LintMotion motion;
  int first = 0;  ///< of its frames, in the motion
  std::optional<Finding> calibration;
};

MovingPart moving_part(const Clip& clip, const LintOptions& options) {
  LintMotion whole = lint_motion(clip);
  const Findings found = find_calibration_pose(whole, options);
  if (found.empty()) return {std::move(whole), 0, std::nullopt};
  const int first = found[0].last + 1;
  Clip rest = clip;
  rest.poses.erase(rest.poses.begin(), rest.poses.begin() + first);
  return {lint_motion(rest), first, found[0]};
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
    std::optional<LintMotion> before;
    if (original && is_body(original->body) && is_calculable(*original)) {
      before = moving_part(*original, options).motion;
    }
    const MovingPart part = moving_part(clip, options);
    Findings of_part;
    check_motion(part.motion, options, before ? &*before : nullptr, of_part);
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
  const Findings found = find_calibration_pose(lint_motion(clip), LintOptions());
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

#include "motion/lint/lint.h"

#include <algorithm>
#include <optional>
#include <tuple>

#include "motion/lint/checks.h"

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

namespace {

void check_motion(const LintSubject& subject, const LintOptions& options,
                  const LintSubject* original, Findings& findings) {
  const auto add = [&findings](const Findings& more) {
    findings.insert(findings.end(), more.begin(), more.end());
  };
  add(find_jumps(subject, options));
  add(find_broken_seam(subject, options));
  if (!is_body(subject.clip.body)) return;
  add(find_joints_beyond_limits(subject, options, original));
  add(find_fast_joints(subject, options, original));
  add(find_self_intersections(subject, options, original));
  add(find_skating_feet(subject, options, original));
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
      before = lint_subject(*original);
    }
    check_motion(lint_subject(clip), options, before ? &*before : nullptr, findings);
  }
  put_in_order(findings);
  return findings;
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

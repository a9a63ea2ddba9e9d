#include "pipeline/production/synthesis/modified_motion.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "motion/animate/body_drive.h"
#include "motion/animate/constraints.h"
#include "motion/animate/keys.h"
#include "motion/animate/motion_ends.h"
#include "motion/formats/motion_file.h"
#include "motion/gait/contact.h"
#include "motion/gait/foot_slide.h"
#include "motion/lint/lint.h"
#include "motion/modify/modified_example.h"
#include "motion/rig/recording_clip.h"
#include "pipeline/base/documents/csv.h"
#include "pipeline/manifest/named_motions.h"
#include "pipeline/production/synthesis/style_transfer.h"

namespace mien::pipeline {

namespace {

constexpr int halvings = 6;  // a sixty-fourth of the strength is less than anyone sees

motion::Pose pose_of(const PoseSource& source, const Repertoire& repertoire) {
  motion::Clip clip;
  if (source.file.empty()) {
    const auto& examples = repertoire.examples.examples;
    const auto found = std::ranges::find(examples, source.example, &motion::Example::name);
    if (found == examples.end()) {
      throw Error(fmt::format("there is no example \"{}\" for the pose", source.example),
                  "name one of the examples, or a motion file");
    }
    clip = found->clip;
  } else {
    const motion::Recording recording = motion::read_motion(source.file, read_options(source.how));
    require_frame(recording, source.frame, source.file);
    clip = clip_of(recording);
  }
  if (source.frame >= clip.frame_count()) {
    throw Error(fmt::format("{} has {} frames, so frame {} does not exist", source.example,
                            clip.frame_count(), source.frame),
                fmt::format("name a frame from 0 to {}", clip.frame_count() - 1));
  }
  return clip.poses[static_cast<std::size_t>(source.frame)];
}

/// One step at a share of its strength.
void take_step(ModifiedMotion& result, const ModificationStep& step,
               const motion::Modification& modification, double share,
               const Repertoire& repertoire) {
  if (step.style) {
    RestyledMotion styled =
        restyled(result.motion, *step.style, share * step.strength, repertoire, result.times);
    result.times = std::move(styled.times);
    result.motion = std::move(styled.motion);
    result.planted_drift_m = styled.planted_drift_m;
    for (std::string& note : styled.notes) result.notes.push_back(std::move(note));
    return;
  }
  motion::Modification asked = motion::scaled(modification, share * step.strength);
  if (!step.edit.names("gesture"))
    asked = motion::without_idle_gesture(std::move(asked), result.motion.clip);
  motion::ModifiedExample modified =
      motion::modified_example(result.motion, asked, std::move(result.times));
  result.motion = std::move(modified.example);
  result.times = std::move(modified.times);
  if (!motion::is_identity(asked)) result.planted_drift_m = modified.report.drift_after_repair;
  for (std::string& remark : modified.report.remarks) result.notes.push_back(std::move(remark));
}

/// The modifications of a stimulus, with what they are made of.
struct Steps {
  const Stimulus& stimulus;
  const Repertoire& repertoire;
  std::vector<motion::Modification> modifications;
  motion::Clip shown_original;       ///< at the output's frame rate
  const std::vector<double>& times;  ///< of the original, moved with it
  double planted_drift_m;            ///< of the original
};

motion::Clip at_rate(const motion::Clip& clip, double frames_per_second) {
  if (clip.frames_per_second == frames_per_second) return clip;
  return motion::resampled(clip, frames_per_second);
}

/// The frozen parts, drives, keys and constraints of the last step, which come after everything
/// else, and a loop made of it.
void animate(ModifiedMotion& result, const ModificationStep& step) {
  const auto take = [&](motion::AnimatedClip made) {
    result.motion.clip = std::move(made.clip);
    for (std::string& remark : made.remarks) result.notes.push_back(std::move(remark));
  };
  if (!step.freeze.parts.empty()) take(motion::with_frozen(result.motion.clip, step.freeze));
  if (!step.drives.empty())
    result.motion.clip = motion::with_drives(result.motion.clip, step.drives);
  if (!step.keys.empty()) take(motion::with_keys(result.motion.clip, step.keys));
  if (!step.constraints.empty())
    take(motion::with_constraints(result.motion.clip, step.constraints));
  if (step.ends.loops) {
    take(motion::with_ends(result.motion.clip, step.ends));
    if (!result.motion.keytimes.empty())
      result.motion.keytimes.back() = result.motion.clip.duration_seconds();
  }
}

/// "frozen parts, 1 drive, 3 keys, 1 constraint, ends held"; empty for none.
std::string described_animation(const ModificationStep& step) {
  std::vector<std::string> parts;
  if (!step.freeze.parts.empty()) parts.emplace_back("frozen parts");
  const auto count = [&](std::size_t number, const char* one, const char* several) {
    if (number > 0) parts.push_back(fmt::format("{} {}", number, number == 1 ? one : several));
  };
  count(step.drives.size(), "drive", "drives");
  count(step.keys.size(), "key", "keys");
  count(step.constraints.size(), "constraint", "constraints");
  if (step.ends.loops) parts.emplace_back("made to loop");
  if (step.ends.hold_before > 0.0)
    parts.push_back(fmt::format("first pose held for {} s", shortest(step.ends.hold_before)));
  if (step.ends.hold_after > 0.0)
    parts.push_back(fmt::format("last pose held for {} s", shortest(step.ends.hold_after)));
  return fmt::format("{}", fmt::join(parts, ", "));
}

/// As `animate`, and measures how much farther planted feet slide by it.
void animate_and_measure(ModifiedMotion& result, const ModificationStep& step) {
  if (described_animation(step).empty()) return;
  std::vector<motion::FootPlant> plants;
  if (motion::is_body(result.motion.clip.body)) plants = motion::foot_plants(result.motion.clip);
  const double before = motion::planted_slide(result.motion.clip, plants);
  animate(result, step);
  const double after = motion::planted_slide(result.motion.clip, plants);
  result.planted_drift_m += std::max(0.0, after - before);
}

/// The poses that the last step holds at the ends. They come after the lint, because they are no
/// fault: nothing moves in them, and the motion begins and stops at once.
void hold_ends(ModifiedMotion& result, const motion::MotionEnds& ends) {
  if (ends.loops || ends.is_empty()) return;
  motion::Clip& clip = result.motion.clip;
  const double end = clip.duration_seconds();
  clip = motion::with_ends(clip, ends).clip;
  const int later = motion::frames_before(ends, clip.frames_per_second);
  const double later_s = later / clip.frames_per_second;
  for (motion::Finding& finding : result.findings) {
    finding.first += later;
    finding.last += later;
  }
  for (double& time : result.times) time += later_s;
  for (double& time : result.motion.keytimes)
    time = time <= 0.0 ? 0.0 : time >= end ? clip.duration_seconds() : time + later_s;
}

/// That a part which was frozen does not move is no fault.
void omit_frozen(std::vector<motion::Finding>& findings, const motion::Freezing& freeze) {
  std::erase_if(findings, [&](const motion::Finding& finding) {
    if (finding.check != "still-limb") return false;
    for (int joint = 0; joint < motion::body_joint_count; ++joint)
      if (finding.joint == motion::name_of(motion::BodyJoint(joint)) &&
          motion::is_frozen(freeze, motion::BodyJoint(joint)))
        return true;
    return false;
  });
}

/// Everything at a share of the requested strengths.
ModifiedMotion at_share(const motion::Example& original, const Steps& steps, double share) {
  ModifiedMotion result{original, share, steps.planted_drift_m};
  result.times = steps.times;
  for (std::size_t i = 0; i < steps.modifications.size(); ++i) {
    take_step(result, steps.stimulus.modify[i], steps.modifications[i], share, steps.repertoire);
  }
  // Last, so that a change does the same whatever the rate at which it is shown.
  result.motion.clip = at_rate(result.motion.clip, steps.stimulus.output.fps);
  if (share > 0.0 && !steps.stimulus.modify.empty())
    animate_and_measure(result, steps.stimulus.modify.back());
  result.findings = motion::lint(result.motion.clip, {}, &steps.shown_original);
  if (steps.stimulus.modify.empty()) return result;
  const ModificationStep& last = steps.stimulus.modify.back();
  omit_frozen(result.findings, last.freeze);
  if (share > 0.0) hold_ends(result, last.ends);
  return result;
}

/// Where something is broken (check and joint), and the worst that was measured there.
using Breakage = std::map<std::pair<std::string, std::string>, double>;

/// An error of the same kind in the same place counts as new when it is half as bad again.
constexpr double clearly_worse = 1.5;

void add_breakage(const std::vector<motion::Finding>& findings, Breakage& breakage) {
  for (const motion::Finding& finding : findings) {
    if (finding.severity != motion::Severity::error) continue;
    double& worst = breakage[{finding.check, finding.joint}];
    worst = std::max(worst, std::abs(finding.measured));
  }
}

/// What is broken in the original itself. What the repair of the feet breaks is none of it: what is
/// delivered is judged.
Breakage broken_before(const motion::Clip& original) {
  Breakage breakage;
  add_breakage(motion::lint(original), breakage);
  add_breakage(motion::lint(original, {}, &original), breakage);
  return breakage;
}

bool is_new(const motion::Finding& finding, const Breakage& own) {
  if (finding.severity != motion::Severity::error) return false;
  const auto known = own.find({finding.check, finding.joint});
  return known == own.end() || std::abs(finding.measured) > clearly_worse * known->second;
}

/// The first error that is not there anyway.
const motion::Finding* new_error(const ModifiedMotion& modified, const Breakage& own) {
  for (const motion::Finding& finding : modified.findings) {
    if (is_new(finding, own)) return &finding;
  }
  return nullptr;
}

/// The largest share without new errors, by bisection.
ModifiedMotion reduced(const motion::Example& original, const Steps& steps, const Breakage& own) {
  double clean = 0.0, broken = 1.0;
  ModifiedMotion best = at_share(original, steps, clean);
  for (int i = 0; i < halvings; ++i) {
    const double share = 0.5 * (clean + broken);
    ModifiedMotion tried = at_share(original, steps, share);
    if (new_error(tried, own) != nullptr) {
      broken = share;
    } else {
      clean = share;
      best = std::move(tried);
    }
  }
  return best;
}

ModifiedMotion dealt_with(ModifiedMotion whole, const motion::Finding& fault,
                          const motion::Example& original, const Steps& steps,
                          const Breakage& own) {
  const Stimulus& stimulus = steps.stimulus;
  const std::string what =
      fmt::format("{} ({}, frames {}–{})", fault.sentence, fault.check, fault.first, fault.last);
  switch (stimulus.on_fault) {
    case OnFault::warn:
      whole.warnings.push_back("the modification makes the motion faulty: " + what);
      return whole;
    case OnFault::fail:
      throw Error(fmt::format("{}: modified by {}, the motion is faulty: {}", stimulus.id,
                              described_modifications(stimulus), what),
                  "lower the strength, or choose on_fault: warn, revert or reduce");
    case OnFault::revert: {
      ModifiedMotion result = at_share(original, steps, 0.0);
      result.warnings.push_back("left unmodified, because the modification makes it faulty: " +
                                what);
      return result;
    }
    case OnFault::reduce:
      break;
  }
  ModifiedMotion result = reduced(original, steps, own);
  result.warnings.push_back(
      result.share == 0.0
          ? "left unmodified, because even the weakest modification makes it faulty; at full "
            "strength: " +
                what
          : fmt::format("modified at {:.0f} % of the requested strength; at full strength: {}",
                        100.0 * result.share, what));
  return result;
}

void append(std::vector<std::string>& parts, const std::string& name,
            const std::optional<double>& value, const char* unit = "") {
  if (value) parts.push_back(fmt::format("{} {}{}", name, shortest(*value), unit));
}

/// "gesture (height 1.3, speed 0.8)"
std::string described(const motion::GestureChange& gesture) {
  std::vector<std::string> parts;
  if (gesture.height != 1.0) append(parts, "height", gesture.height);
  if (gesture.width != 1.0) append(parts, "width", gesture.width);
  if (gesture.speed != 1.0) append(parts, "speed", gesture.speed);
  if (gesture.repetitions != 0) append(parts, "repetitions", gesture.repetitions);
  return parts.empty() ? "gesture" : fmt::format("gesture ({})", fmt::join(parts, ", "));
}

}  // namespace

std::vector<motion::Modification> modifications_of(const Stimulus& stimulus,
                                                   const Repertoire& repertoire) {
  std::vector<motion::Modification> modifications;
  for (const ModificationStep& step : stimulus.modify) {
    modifications.push_back(step.modification);
    if (!step.pose) continue;
    modifications.back().pose_difference = motion::pose_difference(
        pose_of(step.pose->neutral, repertoire), pose_of(step.pose->posed, repertoire));
  }
  return modifications;
}

ModifiedMotion modify_motion(const motion::Example& original, const Stimulus& stimulus,
                             const Repertoire& repertoire, const std::vector<double>& times,
                             double planted_drift_m) {
  const Steps steps{stimulus,
                    repertoire,
                    modifications_of(stimulus, repertoire),
                    at_rate(original.clip, stimulus.output.fps),
                    times,
                    planted_drift_m};
  ModifiedMotion whole = at_share(original, steps, 1.0);
  if (!motion::has_errors(whole.findings)) return whole;
  const Breakage own = broken_before(steps.shown_original);
  const motion::Finding* fault = new_error(whole, own);
  if (fault == nullptr) {
    whole.notes.push_back("the lint findings are present without the modification, too");
    return whole;
  }
  const motion::Finding worst = *fault;
  return dealt_with(std::move(whole), worst, original, steps, own);
}

std::vector<motion::Finding> new_errors(const std::vector<motion::Finding>& findings,
                                        const motion::Clip& original) {
  const Breakage own = broken_before(original);
  std::vector<motion::Finding> errors;
  for (const motion::Finding& finding : findings) {
    if (is_new(finding, own)) errors.push_back(finding);
  }
  return errors;
}

std::string described(const ModificationStep& step) {
  const ModificationEdit& edit = step.edit;
  std::vector<std::string> parts;
  if (!step.emotion.empty()) parts.push_back(step.emotion);
  if (step.style) {
    parts.push_back(fmt::format("{} → {} by {}", step.style->neutral, step.style->styled,
                                name_of(step.style->method)));
  }
  if (edit.names("paths")) append(parts, "paths", edit.values.paths);
  if (edit.names("gains")) parts.emplace_back("band gains");
  if (edit.names("hands") && edit.values.hands == motion::FingerPaths::scaled)
    parts.emplace_back("paths of fingers scaled");
  if (edit.names("acceleration")) append(parts, "acceleration", edit.values.acceleration);
  for (const motion::PostureChange& change : edit.values.posture) {
    append(parts, std::string(motion::name_of(change.unit)), change.degrees, "°");
  }
  if (edit.pose) parts.emplace_back("pose");
  const motion::RelativeChange& relative = edit.values.relative;
  if (edit.names("step_width")) append(parts, "step_width", relative.step_width);
  if (edit.names("step_length")) append(parts, "step_length", relative.step_length);
  if (edit.names("sway")) append(parts, "sway", relative.sway);
  if (edit.names("arm_swing")) append(parts, "arm_swing", relative.arm_swing);
  if (edit.names("trunk_swing")) append(parts, "trunk_swing", relative.trunk_swing);
  if (edit.names("gesture")) parts.push_back(described(edit.values.gesture));
  for (const motion::RangeShare& each : relative.range) {
    append(parts, std::string(motion::name_of(each.unit)), std::round(1e4 * each.share) / 100.0,
           " % of its range");
  }
  if (edit.names("tempo")) {
    const motion::Tempo& tempo = edit.values.tempo;
    if (tempo.curve.empty())
      append(parts, "tempo", tempo.factor);
    else
      parts.push_back("tempo " + motion::text_of(tempo));
  }
  if (edit.names("gravity") && edit.values.gravity == motion::TempoGravity::kept)
    parts.emplace_back("gravity kept");
  if (edit.names("stiffness") && !motion::is_unit(edit.values.stiffness))
    parts.push_back("stiffness of " + text_of(edit.values.stiffness));
  if (edit.names("weight")) append(parts, "weight", edit.values.weight);
  if (edit.names("variation")) append(parts, "variation", edit.values.variation);
  std::string text = fmt::format("{}", fmt::join(parts, ", "));
  const std::string animated = described_animation(step);
  if (text.empty()) return animated.empty() ? "nothing" : animated;
  if (step.strength != 1.0) text = fmt::format("{} × {}", text, shortest(step.strength));
  return animated.empty() ? text : text + ", " + animated;
}

std::string share_text(double share) {
  return share == 1.0 ? "" : fmt::format(" at {:.0f} % of that strength", 100.0 * share);
}

std::string described_modifications(const Stimulus& stimulus) {
  std::vector<std::string> steps;
  for (const ModificationStep& step : stimulus.modify) steps.push_back(described(step));
  const std::string text = fmt::format("{}", fmt::join(steps, "; then "));
  if (!stimulus.foil) return text;
  return fmt::format("{}, without its change of {}", text, name_of(stimulus.foil->differ));
}

}  // namespace mien::pipeline

#include "pipeline/regression/comparison.h"

#include <algorithm>
#include <functional>
#include <utility>

#include <fmt/format.h>

#include "motion/measures/differences/motion_tolerance.h"
#include "pipeline/regression/comparison/distinct_numbers.h"

namespace mien::pipeline {

namespace {

motion::MotionTolerance tolerance_of(const RegressionLimits& limits) {
  motion::MotionTolerance tolerance;
  tolerance.position_m = limits.position_mm / 1000.0;
  tolerance.rotation_radians = limits.turn_degrees * motion::radians_per_degree;
  tolerance.velocity_m_s = limits.speed_m_s;
  tolerance.contact_seconds = limits.contact_seconds;
  tolerance.slide_m = limits.slide_mm / 1000.0;
  tolerance.any_lint = limits.findings;
  return tolerance;
}

/// Three digits of a small length; of a large one whole millimetres, or metres.
std::string length_text(double metres) {
  const double mm = 1000.0 * metres;
  if (mm < 100.0) return fmt::format("{:.3g} mm", mm);
  return mm < 10'000.0 ? fmt::format("{:.0f} mm", mm) : fmt::format("{:.1f} m", metres);
}

/// The value as people read it.
std::string measured_text(const motion::Excess& excess, double value) {
  if (excess.unit == "m") return length_text(value);
  if (excess.unit == "rad") return fmt::format("{:.3g}°", value / motion::radians_per_degree);
  return fmt::format("{:.4g}{}{}", value, excess.unit.empty() ? "" : " ", excess.unit);
}

std::string place_text(const motion::MotionDifference& motion, const std::string& measure) {
  using Curve = std::vector<double> motion::JointDifference::*;
  std::optional<Curve> curve;
  if (measure == "position") curve = &motion::JointDifference::point_m;
  if (measure == "rotation") curve = &motion::JointDifference::turn_radians;
  if (measure == "velocity") curve = &motion::JointDifference::velocity_m_s;
  if (!curve) return "";
  const motion::WorstJoint worst = motion::worst_joint(motion, *curve);
  return fmt::format(", {} at {:.2f} s", motion.joints[static_cast<std::size_t>(worst.joint)].part,
                     worst.peak.frame / motion.frames_per_second());
}

std::string before_and_now(fmt::format_string<std::string, std::string> text,
                           std::pair<std::string, std::string> both) {
  return fmt::format(text, std::move(both.first), std::move(both.second));
}

/// What was and what is, where that says more than how far they are apart.
std::string excess_text(const motion::MotionDifference& motion, const motion::Excess& excess) {
  const motion::MotionLength& before = motion.timing.before;
  const motion::MotionLength& now = motion.timing.now;
  if (excess.measure == "frame-rate")
    return before_and_now("frame-rate: {} → {} frames per second",
                          distinct_numbers(before.frames_per_second, now.frames_per_second, 4));
  if (excess.measure == "duration")
    return before_and_now("duration: {} s → {} s; the limit is ",
                          distinct_numbers(before.seconds, now.seconds, 4)) +
           measured_text(excess, excess.tolerance) + " apart";
  return fmt::format("{}: {}{}; the limit is {}", excess.measure,
                     measured_text(excess, excess.measured), place_text(motion, excess.measure),
                     measured_text(excess, excess.tolerance));
}

/// A part of the body that is farther off than it may be.
struct PartExcess {
  const motion::JointDifference* joint = nullptr;
  motion::CurvePeak peak;
  double limit_mm = 0.0;

  /// Excess relative to the limit, so that a part with its own limit represents those it carries.
  double times_too_far() const { return 1000.0 * peak.value / std::max(limit_mm, 1e-6); }
};

std::vector<PartExcess> part_excesses(const motion::MotionDifference& motion,
                                      const RegressionLimits& limits) {
  std::vector<PartExcess> excesses;
  for (const motion::JointDifference& joint : motion.joints) {
    const auto own =
        std::ranges::find(limits.parts_mm, joint.part, &std::pair<std::string, double>::first);
    const double limit_mm = own == limits.parts_mm.end() ? limits.position_mm : own->second;
    const motion::CurvePeak peak = motion::peak_of(joint.point_m);
    if (1000.0 * peak.value > limit_mm) excesses.push_back({&joint, peak, limit_mm});
  }
  std::ranges::stable_sort(excesses, std::greater{}, &PartExcess::times_too_far);
  return excesses;
}

/// The part that is farthest beyond its limit, and how many more are.
void judge_parts(StimulusComparison& comparison, const RegressionLimits& limits) {
  const motion::MotionDifference& motion = *comparison.motion;
  if (limits.parts_mm.empty() || motion.identical) return;
  const std::vector<PartExcess> excesses = part_excesses(motion, limits);
  if (excesses.empty()) return;
  const PartExcess& worst = excesses.front();
  std::string text = fmt::format("position: {}, {} at {:.2f} s; the limit is {:g} mm",
                                 length_text(worst.peak.value), worst.joint->part,
                                 worst.peak.frame / motion.frames_per_second(), worst.limit_mm);
  if (excesses.size() > 1)
    text += fmt::format("; {} more {} beyond tolerance", excesses.size() - 1,
                        excesses.size() == 2 ? "part is" : "parts are");
  comparison.reasons.push_back(std::move(text));
}

void judge_motion(StimulusComparison& comparison, const RegressionLimits& limits) {
  const motion::MotionDifference& motion = *comparison.motion;
  for (const motion::Excess& excess : motion::excesses(motion, tolerance_of(limits))) {
    const bool is_of_parts = excess.measure == "position" && !limits.parts_mm.empty();
    if (!is_of_parts) comparison.reasons.push_back(excess_text(motion, excess));
  }
  judge_parts(comparison, limits);
}

/// Whether nothing but a motion within its limits makes the pictures others.
bool is_accepted_motion(const StimulusComparison& comparison) {
  return comparison.motion && comparison.reasons.empty() && !comparison.causes.empty() &&
         std::ranges::all_of(comparison.causes, [](const Attribution& one) {
           return one.cause == Cause::motion || one.cause == Cause::synthesis ||
                  one.cause == Cause::presentation;  // key frames do not show it
         });
}

/// Whether the scene's settings have changed, so that its picture differs with the same noise.
bool is_of_another_scene(const StimulusComparison& comparison) {
  return std::ranges::any_of(comparison.causes, [](const Attribution& one) {
    return one.cause == Cause::scene && one.share.value_or(0.0) > 0.0;
  });
}

/// Frames of one number are of two moments where the rates differ.
std::string moment_text(const StimulusComparison& comparison, int frame) {
  if (!comparison.motion) return fmt::format("in frame {}", frame);
  const motion::TimingDifference& timing = comparison.motion->timing;
  if (motion::same_rate(timing.before.frames_per_second, timing.now.frames_per_second))
    return fmt::format("in frame {}", frame);
  return fmt::format("at {:.2f} s", frame / timing.before.frames_per_second);
}

void judge_frames(StimulusComparison& comparison, const RegressionLimits& limits) {
  if (is_accepted_motion(comparison)) return;
  const bool is_no_noise = is_of_another_scene(comparison);
  const FrameComparison* worst = nullptr;
  for (const FrameComparison& frame : comparison.frames) {
    if (!frame.same_size) {
      comparison.reasons.push_back(fmt::format("picture: {} x {} pixels → {} x {}",
                                               frame.size_before.width, frame.size_before.height,
                                               frame.size_now.width, frame.size_now.height));
      return;
    }
    const bool may_differ = frame.same || !(frame.noise.is_bias || is_no_noise);
    if (may_differ || frame.perceived.mean <= limits.perceptual) continue;
    if (worst == nullptr || frame.perceived.mean > worst->perceived.mean) worst = &frame;
  }
  if (worst == nullptr) return;
  comparison.reasons.push_back(
      fmt::format("picture: mean ꟻLIP {:.4f} {}, more than noise; the limit is {:g}",
                  worst->perceived.mean, moment_text(comparison, worst->frame), limits.perceptual));
}

/// Whether the frames are others and their encoding is not: how well a video shows them is then
/// another thing too.
bool is_rendered_differently(const StimulusComparison& comparison) {
  const bool is_of_the_same = std::ranges::all_of(comparison.frames, &FrameComparison::same);
  return !is_of_the_same && std::ranges::none_of(comparison.settings, [](const auto& change) {
    return change.aspect == Aspect::video;
  });
}

/// Whether a video shows other pictures for another reason than noise, or a motion within its
/// limits, which the key frames show too.
bool shows_otherwise(const VideoChange& video, const StimulusComparison& comparison) {
  const bool is_presented_otherwise =
      std::ranges::any_of(comparison.settings, is_of_presentation, &SettingChange::path);
  if (!video.same_pictures) return is_presented_otherwise;
  const bool is_film_the_same =
      !comparison.motion && std::ranges::all_of(comparison.frames, &FrameComparison::same);
  return !*video.same_pictures && (is_presented_otherwise || is_film_the_same);
}

void judge_videos(StimulusComparison& comparison, const RegressionLimits& limits) {
  if (!comparison.reasons.empty()) return;
  const bool loses = !is_rendered_differently(comparison);
  const bool differ = std::ranges::any_of(comparison.videos, [&](const VideoChange& video) {
    return !video.same_frames || shows_otherwise(video, comparison) ||
           (loses && video.psnr_lost_db > limits.psnr_db);
  });
  for (const VideoChange& video : comparison.videos)
    if (differ) comparison.reasons.push_back(video.format + ": " + video.what.front());
}

}  // namespace

std::vector<ValueChange> value_changes(const NamedValues& before, const NamedValues& now) {
  const auto value_in = [](const NamedValues& values, const std::string& name) {
    const auto found = std::ranges::find(values, name, &NamedValues::value_type::first);
    return found == values.end() ? 0.0 : found->second;
  };
  std::vector<ValueChange> changes;
  for (const auto& [name, value] : before)
    if (const double today = value_in(now, name); today != value)
      changes.push_back({name, value, today});
  for (const auto& [name, value] : now) {
    const bool is_new =
        std::ranges::find(before, name, &NamedValues::value_type::first) == before.end();
    if (is_new && value != 0.0) changes.push_back({name, 0.0, value});
  }
  return changes;
}

void judge(StimulusComparison& comparison, const RegressionLimits& limits) {
  comparison.reasons.clear();
  if (comparison.motion) judge_motion(comparison, limits);
  judge_frames(comparison, limits);
  judge_videos(comparison, limits);
  const bool is_same = !comparison.motion && comparison.videos.empty() &&
                       std::ranges::all_of(comparison.frames, &FrameComparison::same);
  comparison.verdict = !comparison.reasons.empty() ? Verdict::differs
                       : is_same                   ? Verdict::same
                                                   : Verdict::alike;
}

}  // namespace mien::pipeline

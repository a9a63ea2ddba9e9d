#include "pipeline/regression/verdict.h"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "motion/math/rotation.h"
#include "motion/measures/motion_tolerance.h"

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

/// As people read it.
std::string measured_text(const motion::Excess& excess, double value) {
  if (excess.unit == "m") return fmt::format("{:.3g} mm", 1000.0 * value);
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

void judge_motion(StimulusComparison& comparison, const RegressionLimits& limits) {
  const motion::MotionDifference& motion = *comparison.motion;
  for (const motion::Excess& excess : motion::excesses(motion, tolerance_of(limits))) {
    const bool is_of_parts = excess.measure == "position" && !limits.parts_mm.empty();
    if (is_of_parts) continue;
    comparison.reasons.push_back(fmt::format(
        "{}: {}{}; the limit is {}", excess.measure, measured_text(excess, excess.measured),
        place_text(motion, excess.measure), measured_text(excess, excess.tolerance)));
  }
  if (limits.parts_mm.empty() || motion.identical) return;
  for (const motion::JointDifference& joint : motion.joints) {
    const auto own =
        std::ranges::find(limits.parts_mm, joint.part, &std::pair<std::string, double>::first);
    const double limit_mm = own == limits.parts_mm.end() ? limits.position_mm : own->second;
    const motion::Peak peak = motion::peak_of(joint.point_m);
    if (1000.0 * peak.value <= limit_mm) continue;
    comparison.reasons.push_back(fmt::format(
        "position: {:.3g} mm, {} at {:.2f} s; the limit is {:g} mm", 1000.0 * peak.value,
        joint.part, peak.frame / motion.frames_per_second(), limit_mm));
  }
}

/// Whether nothing but a motion within its limits makes the pictures others.
bool is_accepted_motion(const StimulusComparison& comparison) {
  return comparison.motion && comparison.reasons.empty() && !comparison.causes.empty() &&
         std::ranges::all_of(comparison.causes, [](const Attribution& one) {
           return one.cause == Cause::motion || one.cause == Cause::synthesis;
         });
}

/// Whether a scene was asked for otherwise, and its picture is another with the same noise.
bool is_of_another_scene(const StimulusComparison& comparison) {
  return std::ranges::any_of(comparison.causes, [](const Attribution& one) {
    return one.cause == Cause::scene && one.share.value_or(0.0) > 0.0;
  });
}

void judge_frames(StimulusComparison& comparison, const RegressionLimits& limits) {
  if (is_accepted_motion(comparison)) return;
  const bool is_no_noise = is_of_another_scene(comparison);
  const FrameComparison* worst = nullptr;
  for (const FrameComparison& frame : comparison.frames) {
    if (!frame.same_size) {
      comparison.reasons.emplace_back("picture: another size");
      return;
    }
    const bool may_differ = frame.same || !(frame.noise.is_bias || is_no_noise);
    if (may_differ || frame.perceived.mean <= limits.perceptual) continue;
    if (worst == nullptr || frame.perceived.mean > worst->perceived.mean) worst = &frame;
  }
  if (worst == nullptr) return;
  comparison.reasons.push_back(
      fmt::format("picture: mean ꟻLIP {:.4f} in frame {}, more than noise; the limit is {:g}",
                  worst->perceived.mean, worst->frame, limits.perceptual));
}

}  // namespace

void judge(StimulusComparison& comparison, const RegressionLimits& limits) {
  comparison.reasons.clear();
  if (comparison.motion) judge_motion(comparison, limits);
  judge_frames(comparison, limits);
  for (const VideoChange& video : comparison.videos) {
    const bool matters = !video.same_frames || video.psnr_lost_db > limits.psnr_db;
    if (matters && comparison.reasons.empty())
      comparison.reasons.push_back(video.format + ": " + video.what.front());
  }
  const bool is_same = !comparison.motion && comparison.videos.empty() &&
                       std::ranges::all_of(comparison.frames, &FrameComparison::same);
  comparison.verdict = !comparison.reasons.empty() ? Verdict::differs
                       : is_same                   ? Verdict::same
                                                   : Verdict::alike;
}

}  // namespace mien::pipeline

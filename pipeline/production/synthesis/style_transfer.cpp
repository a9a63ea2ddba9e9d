#include "pipeline/production/synthesis/style_transfer.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "motion/error.h"
#include "motion/gait/gait_plants.h"
#include "motion/modify/contacts_carried.h"
#include "motion/rig/retarget.h"
#include "motion/skeleton/recorded_hands.h"
#include "motion/style_transfer/displacement_map.h"
#include "motion/style_transfer/drives.h"
#include "motion/style_transfer/emotion_transform.h"
#include "motion/style_transfer/fourier_style.h"
#include "motion/style_transfer/lti_style.h"
#include "motion/style_transfer/motion_warp.h"
#include "motion/style_transfer/style_components.h"
#include "motion/style_transfer/style_timing.h"
#include "motion/style_transfer/waveshape.h"

namespace mien::pipeline {

namespace {

/// A cycle with less way than this is walked in place, metres; its feet cannot be locked.
constexpr double least_travel_m = 0.1;
constexpr double noticeable_slide_m = 0.005;

motion::Example example_like(const motion::Example& motion, const std::string& name,
                             const Repertoire& repertoire) {
  const auto& examples = repertoire.settled.examples;
  const auto found = std::ranges::find(examples, name, &motion::Example::name);
  if (found == examples.end()) {
    throw Error(fmt::format("there is no example \"{}\" for the style", name),
                "name one of the examples");
  }
  motion::Example example = *found;
  if (motion::leg_length(example.clip.body) != motion::leg_length(motion.clip.body)) {
    example.clip = motion::retarget(example.clip, motion.clip.body);
  }
  const double before = example.clip.duration_seconds();
  example.clip = motion::resampled(example.clip, motion.clip.frames_per_second);
  for (double& keytime : example.keytimes) {
    keytime *= example.clip.duration_seconds() / before;
  }
  return example;
}

motion::Clip displaced_through(const motion::Clip& clip, const motion::Clip& neutral,
                               const motion::Clip& styled, double strength) {
  const motion::DisplacementMapOptions window{
      .amount = strength, .start_seconds = 0.0, .end_seconds = clip.duration_seconds()};
  return motion::displaced(clip, motion::displacements_between(neutral, styled, window), window);
}

std::string components_note(const motion::StyleComponents& parts,
                            const motion::StyleComponentOptions& options) {
  std::string text = "style components swapped:";
  for (const int k : motion::swapped_components(parts, options)) {
    Eigen::Index joint = 0;
    parts.joint_shares.row(k).maxCoeff(&joint);
    text += fmt::format(" {} (energy {:.3g}, difference {:.3g}, mostly {})", k, parts.energy[k],
                        parts.difference[k], motion::name_of(motion::BodyJoint(joint)));
  }
  return text;
}

motion::Clip by_components(const motion::Clip& clip, const motion::Clip& neutral,
                           const motion::Clip& styled, const StyleStep& step, double strength,
                           std::vector<std::string>& notes) {
  const motion::StyleComponentOptions options{
      .amount = strength, .components = step.components, .seed = step.seed, .swapped = step.swap};
  const motion::StyleComponents parts = motion::style_components(neutral, styled, options);
  notes.push_back(components_note(parts, options));
  return motion::restyled(clip, parts, options);
}

/// A clip after style transfer.
struct RestyledClip {
  motion::Clip clip;
  /// The frame of the motion that corresponds to each frame; empty: the same share of its time.
  std::vector<double> source_frames = {};
};

RestyledClip by_system(const motion::Clip& clip, const motion::Clip& neutral,
                       const motion::Clip& styled, const StyleStep& step, double strength,
                       std::vector<std::string>& notes) {
  const motion::LtiStyleOptions options{
      .amount = strength, .order = step.order, .inputs = step.inputs};
  const motion::LtiStyleModel model = motion::fit_lti_style(neutral, styled, options);
  notes.push_back(
      fmt::format("the linear system has {} states and fits the styled motion to {:.1f}° (RMS)",
                  model.system.order(), model.error_radians / motion::radians_per_degree));
  motion::LtiTranslation made = motion::translation(clip, model, options);
  if (made.deviating_share > 0.0) {
    notes.push_back(fmt::format(
        "{:.0f} % of the frames deviate from the neutral motion and take less or none of the style",
        100.0 * made.deviating_share));
  }
  return {std::move(made.clip), std::move(made.source_frames)};
}

RestyledClip by_fourier_series(const motion::Example& motion, const motion::Example& neutral,
                               const motion::Example& styled, const StyleStep& step,
                               double strength) {
  RestyledClip made{motion::fourier_styled(motion.clip, neutral.clip, styled.clip,
                                           {.amount = strength, .harmonics = step.harmonics})};
  const std::vector<double> keytimes =
      motion::styled_keytimes(motion, neutral, styled, strength, made.clip.duration_seconds());
  made.source_frames = motion::corresponding_frames(motion, keytimes, made.clip.frame_count());
  return made;
}

RestyledClip restyled_clip(const motion::Example& motion, const motion::Example& neutral,
                           const motion::Example& styled, const StyleStep& step, double strength,
                           std::vector<std::string>& notes) {
  const motion::Clip& clip = motion.clip;
  switch (step.method) {
    case StyleMethod::amaya:
      return {motion::emotion_transformed(clip, neutral.clip, styled.clip, {.amount = strength})};
    case StyleMethod::unuma:
      return by_fourier_series(motion, neutral, styled, step, strength);
    case StyleMethod::hsu:
      return by_system(clip, neutral.clip, styled.clip, step, strength, notes);
    case StyleMethod::witkin:
      return {motion::warped_towards(motion, styled, {.amount = strength})};
    case StyleMethod::waveshape:
      return {motion::waveshaped(clip, motion::shapes_between(neutral.clip, styled.clip),
                                 {.amount = strength})};
    case StyleMethod::displacement:
      return {displaced_through(clip, neutral.clip, styled.clip, strength)};
    case StyleMethod::shapiro:
      return {by_components(clip, neutral.clip, styled.clip, step, strength, notes)};
    case StyleMethod::neff:
      break;
  }
  return {motion::driven(clip, motion::drives_towards(neutral.clip, styled.clip),
                         {.amount = strength})};
}

/// Says that a style of walks is applied to a run, or one of runs to another motion.
void note_other_gait(const motion::Clip& clip, const motion::Example& neutral,
                     std::vector<std::string>& notes) {
  const bool runs = motion::has_flights(clip);
  if (runs == motion::has_flights(neutral.clip)) return;
  notes.push_back(
      fmt::format("the motion {}, but the neutral example \"{}\" {}: what the style changes may "
                  "not suit it, and "
                  "feet may slide; use examples that {}",
                  runs ? "runs" : "does not run", neutral.name, runs ? "does not" : "runs",
                  runs ? "run" : "do not run"));
}

/// The time, seconds, at which a frame of the original occurs.
double time_of(double frame, const std::vector<double>& source_frames, const motion::Clip& clip) {
  std::size_t after = 1;
  while (after + 1 < source_frames.size() && source_frames[after] < frame) ++after;
  const double from = source_frames[after - 1];
  const double to = source_frames[after];
  const double share = to > from ? (frame - from) / (to - from) : 0.0;
  return std::clamp((static_cast<double>(after) - 1.0 + share) / clip.frames_per_second, 0.0,
                    clip.duration_seconds());
}

/// Times of a motion after a change of its timing, and the motion's own keytimes.
std::vector<double> timed(const std::vector<double>& times, const motion::Clip& before,
                          const motion::Clip& clip, const std::vector<double>& source_frames) {
  std::vector<double> moved;
  for (const double time : times)
    moved.push_back(time_of(time * before.frames_per_second, source_frames, clip));
  return moved;
}

/// Styles concern the body; fingers are those of the motion at the same moment.
void carry_fingers(const motion::Clip& from, const std::vector<double>& source_frames,
                   motion::Clip& to) {
  if (!motion::has_fingers(from)) return;
  for (std::size_t f = 0; f < to.poses.size(); ++f) {
    const double seconds = source_frames[f] / from.frames_per_second;
    to.poses[f].fingers = motion::pose_at(from, seconds).fingers;
  }
}

std::vector<double> timed_keytimes(const motion::Example& motion, const motion::Clip& clip,
                                   const std::vector<double>& source_frames) {
  std::vector<double> keytimes = timed(motion.keytimes, motion.clip, clip, source_frames);
  keytimes.back() = clip.duration_seconds();
  return keytimes;
}

}  // namespace

RestyledMotion restyled(const motion::Example& motion, const StyleStep& step, double strength,
                        const Repertoire& repertoire, const std::vector<double>& times) {
  RestyledMotion result{motion};
  result.times = times;
  if (strength == 0.0) return result;
  const motion::Example neutral = example_like(motion, step.neutral, repertoire);
  const motion::Example styled = example_like(motion, step.styled, repertoire);
  RestyledClip made = restyled_clip(motion, neutral, styled, step, strength, result.notes);
  motion::Clip& clip = result.motion.clip;
  clip = std::move(made.clip);
  if (made.source_frames.empty()) {
    made.source_frames = motion::even_source_frames(motion.clip, clip.frame_count());
  }
  carry_fingers(motion.clip, made.source_frames, clip);
  const bool travels = !clip.loops || clip.cycle_displacement.norm() > least_travel_m;
  if (travels) note_other_gait(motion.clip, neutral, result.notes);
  if (step.feet && travels) {
    const motion::TimedOriginal original = motion::timed_original(motion.clip, made.source_frames);
    clip = motion::with_contacts_carried(clip, original);
    result.planted_drift_m = motion::contact_slide(clip, original);
    if (result.planted_drift_m > noticeable_slide_m) {
      result.notes.push_back(fmt::format("planted feet still slide by up to {:.0f} mm",
                                         1000.0 * result.planted_drift_m));
    }
  }
  result.motion.keytimes = timed_keytimes(motion, clip, made.source_frames);
  result.times = timed(times, motion.clip, clip, made.source_frames);
  return result;
}

}  // namespace mien::pipeline

#include "pipeline/production/synthesis/synthesis.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "motion/error.h"
#include "motion/formats/fitted_file.h"
#include "motion/gait/contact.h"
#include "motion/gait/foot_lock.h"
#include "motion/gait/foot_slide.h"
#include "motion/interpolation/interpolation.h"
#include "motion/lint/fit_residuals.h"
#include "motion/lint/lint.h"
#include "motion/live/synthesis.h"
#include "motion/rig/body_mapping.h"
#include "motion/rig/recording_clip.h"
#include "motion/skeleton/recorded_hands.h"
#include "pipeline/manifest/named_motions.h"
#include "pipeline/production/synthesis/modified_motion.h"
#include "pipeline/production/synthesis/slider_interface.h"
#include "pipeline/production/synthesis/walked_path.h"

namespace mien::pipeline {

namespace {

/// Deviations from a requested value above these are reported: of adjectives, which are weighted
/// sums, and of features, which are measured on the synthesized motion.
constexpr double reported_difference = 0.02;
constexpr double reported_feature_difference = 0.1;

/// A motion that is nearly one example: its weight is above this, or fewer examples than this would
/// be mixed if they had equal weights.
constexpr double nearly_one = 0.8;
constexpr double nearly_one_example = 1.5;

Eigen::VectorXd given_weights(const NamedValues& weights, const Repertoire& repertoire) {
  Eigen::VectorXd result =
      Eigen::VectorXd::Zero(static_cast<Eigen::Index>(repertoire.names.size()));
  for (const auto& [name, value] : weights) {
    const auto found = std::ranges::find(repertoire.names, name, &RatedExample::name);
    if (found == repertoire.names.end()) {
      throw Error(fmt::format("there is no example \"{}\"", name), "name one of the examples");
    }
    result[found - repertoire.names.begin()] = value;
  }
  return motion::direct_weights(result);
}

NamedValues blended(const NamedValues& requests, const ParameterTable& table,
                    const Eigen::VectorXd& weights) {
  NamedValues values;
  for (const auto& request : requests) {
    const Eigen::Index row = parameter_row(request.first, table);
    values.emplace_back(request.first, table.values.row(row).dot(weights));
  }
  return values;
}

/// Features are measured on the motion; ratings can only be estimated as a weighted sum.
NamedValues reached_parameters(const Stimulus& stimulus, const Repertoire& repertoire,
                               const motion::SynthesizedMotion& made) {
  const NamedValues& requests = requested_values(stimulus);
  if (stimulus.features.empty())
    return blended(requests, repertoire.parameters, made.found.weights);
  std::vector<std::string> names;
  for (const auto& request : requests) names.push_back(request.first);
  const Eigen::RowVectorXd measured = motion::measured_parameters(
      names, made, {repertoire.features.scale, repertoire.features.table});
  NamedValues reached;
  for (std::size_t i = 0; i < names.size(); ++i)
    reached.emplace_back(names[i], measured[static_cast<Eigen::Index>(i)]);
  return reached;
}

void warn_of_missed_features(const ParameterTable& table, Synthesis& synthesis) {
  for (size_t i = 0; i < synthesis.requested.size(); ++i) {
    const auto& [name, value] = synthesis.requested[i];
    const double reached = synthesis.reached[i].second;
    if (std::abs(reached - value) <= reported_feature_difference) continue;
    const auto row = table.values.row(parameter_row(name, table));
    synthesis.warnings.push_back(
        fmt::format("{} {:.2f} requested, {:.2f} reached; the examples range from {:.2f} to {:.2f}",
                    name, value, reached, row.minCoeff(), row.maxCoeff()));
  }
}

void warn_of_missed_adjectives(const Stimulus& stimulus, Synthesis& synthesis) {
  const auto method = stimulus.interpolation.weights.method;
  for (size_t i = 0; i < synthesis.requested.size(); ++i) {
    const auto& [name, value] = synthesis.requested[i];
    const double reached = synthesis.reached[i].second;
    if (std::abs(reached - value) <= reported_difference) continue;
    std::string text = fmt::format("{} {:.2f} requested, {:.2f} reached", name, value, reached);
    if (i < synthesis.feasible.size()) {
      const FeasibleParameter& feasible = synthesis.feasible[i];
      text += "; " + to_sentence(feasible);
      if (feasible.is_feasible() && method != motion::InterpolationMethod::reach)
        text += "; interpolation: {method: reach} reaches it";
    }
    synthesis.warnings.push_back(std::move(text));
  }
}

void warn_of_missed_holds(Synthesis& synthesis) {
  std::size_t missed = 0, worst = 0;
  const auto miss = [&](std::size_t i) {
    return std::abs(synthesis.held_reached[i].second - synthesis.held[i].second);
  };
  for (std::size_t i = 0; i < synthesis.held.size(); ++i) {
    if (miss(i) > reported_difference) ++missed;
    if (miss(i) > miss(worst)) worst = i;
  }
  if (missed == 0) return;
  synthesis.warnings.push_back(fmt::format(
      "{} of {} held parameters missed; largest deviation: {}, {:.2f} instead of {:.2f}", missed,
      synthesis.held.size(), synthesis.held[worst].first, synthesis.held_reached[worst].second,
      synthesis.held[worst].second));
}

/// Several examples were to be mixed, and hardly were.
void note_single_example(const Repertoire& repertoire, Synthesis& synthesis) {
  Eigen::Index largest = 0;
  const double weight = synthesis.weights.maxCoeff(&largest);
  const double count = motion::effective_examples(synthesis.weights);
  if (weight <= nearly_one && count >= nearly_one_example) return;
  synthesis.notes.push_back(fmt::format(
      "nearly a copy of one example: {:.0f} % is {}; effective number of examples {:.1f}",
      100.0 * weight, repertoire.names[static_cast<std::size_t>(largest)].name, count));
}

/// Some of the examples have fingers, but the motion has none.
void note_lost_fingers(const motion::ExampleSet& examples, Synthesis& synthesis) {
  if (motion::has_fingers(synthesis.motion.clip)) return;
  const bool any = std::ranges::any_of(examples.examples, [](const motion::Example& example) {
    return motion::has_fingers(example.clip);
  });
  if (any)
    synthesis.notes.push_back(
        "the fingers of its examples are left out: blends have fingers if all of their examples "
        "have, and motions of a statistical model have none");
}

motion::SynthesisContext synthesis_context(const Interpolation& interpolation, const Output& output,
                                           const Repertoire& repertoire) {
  return {examples_for(interpolation, repertoire), interpolation, output.fps};
}

Synthesis as_synthesis(motion::SynthesizedMotion made) {
  Synthesis result;
  result.planted_drift_m = motion::planted_drift(made.motion.clip, made.plants);
  result.motion = std::move(made.motion);
  result.weights = std::move(made.found.weights);
  result.expected_error_m = made.found.expected_error_m;
  return result;
}

Synthesis from_weights(const Eigen::VectorXd& weights, const Output& output,
                       const Interpolation& interpolation, const Repertoire& repertoire) {
  const motion::SynthesisContext context = synthesis_context(interpolation, output, repertoire);
  Synthesis result = as_synthesis(motion::synthesize_from_weights(weights, context));
  note_lost_fingers(context.examples, result);
  return result;
}

/// Records requested and held values, the values reached, and warnings about the deviations.
void record_request(const Stimulus& stimulus, const ParameterRequest& request,
                    const Repertoire& repertoire, NamedValues reached, Synthesis& made) {
  const ParameterTable& table = table_of(stimulus, repertoire);
  const bool by_features = !stimulus.features.empty();
  made.requested = requested_values(stimulus);
  made.reached = std::move(reached);
  for (Eigen::Index i = request.settings.size() - request.held; i < request.settings.size(); ++i)
    made.held.emplace_back(request.sliders.sliders[static_cast<std::size_t>(i)],
                           request.settings[i]);
  made.held_reached = blended(made.held, table, made.weights);
  const bool is_blend = stimulus.interpolation.weights.method != motion::InterpolationMethod::pca;
  if (by_features) {
    warn_of_missed_features(table, made);
  } else {
    if (is_blend) made.feasible = feasible_parameters(request, table);
    warn_of_missed_adjectives(stimulus, made);
    warn_of_missed_holds(made);
  }
  if (is_blend) note_single_example(repertoire, made);
}

Synthesis from_parameters(const Stimulus& stimulus, const Repertoire& repertoire) {
  const Interpolation& how = stimulus.interpolation;
  const ParameterRequest request = request_of(stimulus, repertoire);
  const FittedInterface sliders = fit_interface(request.sliders, how, repertoire, request.held);
  motion::SynthesizedMotion made = motion::synthesize_for(
      sliders, request.settings, synthesis_context(how, stimulus.output, repertoire),
      {repertoire.features.scale, repertoire.features.table});
  std::vector<std::string> warnings = sliders.interpolator.remarks;
  warnings.insert(warnings.end(), made.found.remarks.begin(), made.found.remarks.end());
  NamedValues reached = reached_parameters(stimulus, repertoire, made);
  Synthesis result = as_synthesis(std::move(made));
  result.warnings = std::move(warnings);
  note_lost_fingers(examples_for(how, repertoire), result);
  record_request(stimulus, request, repertoire, std::move(reached), result);
  return result;
}

motion::Clip excerpt(motion::Clip clip, const ClipSource& source) {
  if (!source.frames) return clip;
  const auto [first, last] = *source.frames;
  return motion::cut(clip, first, last);
}

/// Warns of files with several takes where none was chosen. The reader of a clip reports its own.
void warn_of_default_takes(const Stimulus& stimulus, std::vector<std::string>& warnings) {
  for (const NamedMotion& motion : named_motions(stimulus)) {
    if (stimulus.clip && motion.path == member_path(stimulus.path, "clip")) continue;
    const std::string note = default_take_note(motion);
    const std::string warning = motion.file.filename().string() + ": " + note;
    if (!note.empty() && std::ranges::find(warnings, warning) == warnings.end())
      warnings.push_back(warning);
  }
}

Synthesis as_captured(const Stimulus& stimulus) {
  Synthesis result;
  const ClipSource& source = *stimulus.clip;
  motion::FittedFile file = motion::read_fitted(source.file, read_options(source.how));
  const motion::Recording& recording = file.recording;
  result.fit = std::move(file.fit);
  if (source.frames) {
    require_frame(recording, (*source.frames)[1], source.file);
    result.clip_start_s = (*source.frames)[0] / recording.frames_per_second;
  }
  const bool has_body = !recording.markers || motion::is_body(recording.skeleton);
  motion::Clip whole;
  if (has_body) {
    const motion::BodyMapping mapping = motion::recognise(recording);
    result.warnings = mapping.warnings;
    whole = motion::to_body(recording, mapping);
  } else {  // markers that could not be fitted
    result.warnings = recording.notes;
    whole = motion::clip_of(recording);
  }
  const motion::Clip clip = excerpt(whole, source);
  result.motion.name = stimulus.id;
  // What is modified stays at its own rate until then.
  result.motion.clip =
      stimulus.modify.empty() ? motion::resampled(clip, stimulus.output.fps) : clip;
  result.motion.keytimes = {0.0, result.motion.clip.duration_seconds()};
  if (has_body)
    result.planted_drift_m =
        motion::planted_drift(result.motion.clip, motion::foot_plants(result.motion.clip));
  return result;
}

Synthesis as_walked(const Stimulus& stimulus) {
  Synthesis result;
  result.motion.name = stimulus.id;
  motion::WalkedClip walk = walked(stimulus);
  result.planted_drift_m = motion::planted_slide(walk.clip, walk.plants);
  result.motion.clip = std::move(walk.clip);
  result.motion.keytimes = {0.0, result.motion.clip.duration_seconds()};
  result.moods = moods_in_order(*stimulus.walk, walk.segment_starts);
  std::erase_if(result.moods, [&](const ShownMood& mood) {
    return mood.from_s > 0.0 && mood.from_s >= result.motion.clip.duration_seconds();
  });
  return result;
}

Synthesis unmodified(const Stimulus& stimulus, const Repertoire& repertoire) {
  if (stimulus.clip) return as_captured(stimulus);
  if (stimulus.walk) return as_walked(stimulus);
  if (!requested_values(stimulus).empty()) return from_parameters(stimulus, repertoire);
  return from_weights(given_weights(stimulus.weights, repertoire), stimulus.output,
                      stimulus.interpolation, repertoire);
}

/// Adds the findings about recorded points that are far from the fitted body.
void add_fit_residuals(Synthesis& synthesis) {
  if (!synthesis.fit) return;
  for (motion::Finding& finding :
       motion::find_fit_residuals(*synthesis.fit, synthesis.motion.clip, synthesis.clip_start_s))
    synthesis.findings.push_back(std::move(finding));
}

/// `synthesis` has only findings that concern the recording; they come after those of the result.
void apply_modifications(const Stimulus& stimulus, const Repertoire& repertoire,
                         Synthesis& synthesis) {
  std::vector<double> times;
  for (const ShownMood& mood : synthesis.moods) times.push_back(mood.from_s);
  const double recorded_rate = synthesis.motion.clip.frames_per_second;
  for (const motion::Finding& finding : synthesis.findings)
    times.insert(times.end(), {finding.first / recorded_rate, finding.last / recorded_rate});
  ModifiedMotion modified =
      modify_motion(synthesis.motion, stimulus, repertoire, times, synthesis.planted_drift_m);
  auto moved = modified.times.begin();
  for (ShownMood& mood : synthesis.moods) mood.from_s = *moved++;
  const motion::Clip& clip = modified.motion.clip;
  const auto frame_at = [&](double seconds) {
    return std::clamp(static_cast<int>(std::lround(seconds * clip.frames_per_second)), 0,
                      clip.frame_count() - 1);
  };
  for (motion::Finding& finding : synthesis.findings) {
    finding.first = frame_at(*moved++);
    finding.last = frame_at(*moved++);
    modified.findings.push_back(std::move(finding));
  }
  synthesis.motion = std::move(modified.motion);
  synthesis.planted_drift_m = modified.planted_drift_m;
  synthesis.modified = described_modifications(stimulus);
  synthesis.modified_share = modified.share;
  synthesis.findings = std::move(modified.findings);
  synthesis.notes.insert(synthesis.notes.end(), modified.notes.begin(), modified.notes.end());
  synthesis.warnings.insert(synthesis.warnings.end(), modified.warnings.begin(),
                            modified.warnings.end());
}

}  // namespace

Eigen::VectorXd weights_of(const Stimulus& stimulus, const Repertoire& repertoire) {
  assert(is_blend(stimulus));
  if (requested_values(stimulus).empty()) return given_weights(stimulus.weights, repertoire);
  // Features are met by trial (synthesize_with_features).
  if (!stimulus.features.empty()) return from_parameters(stimulus, repertoire).weights;
  const ParameterRequest request = request_of(stimulus, repertoire);
  const FittedInterface sliders =
      fit_interface(request.sliders, stimulus.interpolation, repertoire, request.held);
  return motion::weights_at(sliders.interpolator, request.settings).weights;
}

NamedValues rated_values(const Synthesis& synthesis, const Repertoire& repertoire) {
  NamedValues values;
  const ParameterTable& table = repertoire.parameters;
  if (!synthesis.modified.empty() || synthesis.weights.size() != table.values.cols()) return values;
  const Eigen::VectorXd blend = table.values * synthesis.weights;
  for (std::size_t i = 0; i < table.names.size(); ++i)
    values.emplace_back(table.names[i], blend[static_cast<Eigen::Index>(i)]);
  return values;
}

Synthesis synthesize(const Stimulus& stimulus, const Repertoire& repertoire) {
  Synthesis result = unmodified(stimulus, repertoire);
  result.motion.name = stimulus.id;
  result.motion.clip.name = stimulus.id;
  warn_of_default_takes(stimulus, result.warnings);
  if (stimulus.modify.empty()) result.findings = motion::lint(result.motion.clip);
  add_fit_residuals(result);
  if (!stimulus.modify.empty()) apply_modifications(stimulus, repertoire, result);
  return result;
}

Synthesis synthesize_example(const std::string& name, const Output& output,
                             const Interpolation& interpolation, const Repertoire& repertoire) {
  Synthesis result =
      from_weights(given_weights({{name, 1.0}}, repertoire), output, interpolation, repertoire);
  result.motion.name = name;
  result.motion.clip.name = name;
  return result;
}

}  // namespace mien::pipeline

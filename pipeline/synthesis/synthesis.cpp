#include "pipeline/synthesis/synthesis.h"

#include <algorithm>
#include <cassert>

#include <fmt/format.h>

#include "motion/error.h"
#include "motion/formats/motion_file.h"
#include "motion/gait/contact.h"
#include "motion/gait/foot_lock.h"
#include "motion/interpolation/blend.h"
#include "motion/interpolation/interpolation.h"
#include "motion/lint/lint.h"
#include "motion/rig/body_mapping.h"
#include "motion/skeleton/straighten.h"
#include "pipeline/synthesis/modified_motion.h"
#include "pipeline/synthesis/slider_interface.h"

namespace mien::pipeline {

namespace {

/// A wish that the blend misses by more than this is told to the user.
constexpr double told_difference = 0.1;

Eigen::VectorXd given_weights(const NamedValues& weights, const Repertoire& repertoire) {
  Eigen::VectorXd result =
      Eigen::VectorXd::Zero(static_cast<Eigen::Index>(repertoire.names.size()));
  for (const auto& [name, value] : weights) {
    const auto found =
        std::find_if(repertoire.names.begin(), repertoire.names.end(),
                     [&wanted = name](const RatedExample& e) { return e.name == wanted; });
    if (found == repertoire.names.end()) {
      throw Error(fmt::format("there is no example \"{}\"", name),
                  "name one of the set's examples");
    }
    result[found - repertoire.names.begin()] = value;
  }
  return motion::direct_weights(result);
}

/// What a stimulus asks for, as settings of sliders.
struct Wish {
  SliderInterface sliders;
  Eigen::RowVectorXd settings;
};

/// Its features, or else its adjectives.
const NamedValues& wishes_of(const Stimulus& stimulus) {
  return stimulus.features.empty() ? stimulus.adjectives : stimulus.features;
}

Wish wish_of(const Stimulus& stimulus) {
  const NamedValues& values = wishes_of(stimulus);
  Wish wish;
  wish.sliders.kind =
      stimulus.features.empty() ? InterfaceKind::adjectives : InterfaceKind::features;
  wish.settings.resize(static_cast<Eigen::Index>(values.size()));
  for (const auto& [name, value] : values) {
    wish.settings[static_cast<Eigen::Index>(wish.sliders.sliders.size())] = value;
    wish.sliders.sliders.push_back(name);
  }
  return wish;
}

/// Where the examples lie on the parameters that a stimulus names.
const ParameterTable& table_of(const Stimulus& stimulus, const Repertoire& repertoire) {
  return stimulus.features.empty() ? repertoire.parameters : repertoire.features.table;
}

/// Features are measured of the motion; what people would say of it can only be summed.
NamedValues reached_parameters(const Stimulus& stimulus, const Repertoire& repertoire,
                               const Synthesis& made) {
  const ParameterTable& table = table_of(stimulus, repertoire);
  NamedValues reached;
  std::optional<motion::FeatureValues> features;
  if (!stimulus.features.empty()) {
    features = motion::scaled(repertoire.features.scale, motion::measure_features(made.motion));
  }
  for (const auto& [name, value] : made.asked) {
    const auto measured = features ? feature_parameter(name, *features) : std::nullopt;
    const auto row = table.values.row(parameter_row(name, table));
    reached.emplace_back(name, measured ? *measured : row.dot(made.weights));
  }
  return reached;
}

void warn_of_missed_parameters(const ParameterTable& table, Synthesis& synthesis) {
  for (size_t i = 0; i < synthesis.asked.size(); ++i) {
    const auto& [name, value] = synthesis.asked[i];
    const double reached = synthesis.reached[i].second;
    if (std::abs(reached - value) <= told_difference) continue;
    const auto row = table.values.row(parameter_row(name, table));
    synthesis.warnings.push_back(
        fmt::format("{} {:.2f} was asked for and the blend has {:.2f}; the examples lie between "
                    "{:.2f} and {:.2f}",
                    name, value, reached, row.minCoeff(), row.maxCoeff()));
  }
}

void lock_feet(const Interpolation& interpolation, Synthesis& synthesis) {
  motion::Clip& clip = synthesis.motion.clip;
  const std::vector<motion::FootPlant> plants = motion::foot_plants(clip);
  if (interpolation.foot_lock) clip = motion::foot_locked(clip, plants);
  synthesis.planted_drift_m = motion::planted_drift(clip, plants);
}

Synthesis from_weights(const Eigen::VectorXd& weights, const Output& output,
                       const Interpolation& interpolation, const Repertoire& repertoire) {
  Synthesis result;
  result.weights = weights;
  const motion::ExampleSet& examples = examples_for(interpolation, repertoire);
  const motion::BlendOptions options = {.frames_per_second = output.fps,
                                        .rotations = interpolation.rotations,
                                        .warp = interpolation.time_warp};
  if (examples.blendable) {
    result.motion = motion::blend(examples, weights, options);
  } else {
    Eigen::Index only = 0;
    weights.maxCoeff(&only);
    const motion::ExampleSet alone{"", {examples.examples[static_cast<std::size_t>(only)]}};
    result.motion = motion::blend(alone, Eigen::VectorXd::Ones(1), options);
  }
  lock_feet(interpolation, result);
  return result;
}

Synthesis from_parameters(const Stimulus& stimulus, const Repertoire& repertoire) {
  const Interpolation& how = stimulus.interpolation;
  const Wish wish = wish_of(stimulus);
  const FittedInterface sliders = fit_interface(wish.sliders, how, repertoire);
  const motion::InterpolatedWeights found = motion::weights_at(sliders.interpolator, wish.settings);
  Synthesis result;
  result.weights = found.weights;
  result.expected_error_m = found.expected_error_m;
  result.warnings = sliders.interpolator.remarks;
  result.warnings.insert(result.warnings.end(), found.remarks.begin(), found.remarks.end());
  result.motion = motion_of(sliders, wish.settings, how, repertoire, stimulus.output.fps);
  lock_feet(how, result);
  result.asked = wishes_of(stimulus);
  result.reached = reached_parameters(stimulus, repertoire, result);
  warn_of_missed_parameters(table_of(stimulus, repertoire), result);
  return result;
}

motion::Clip excerpt(motion::Clip clip, const ClipSource& source) {
  if (!source.frames) return clip;
  const auto [first, last] = *source.frames;
  if (last >= clip.frame_count()) {
    throw Error(Place{source.file.string(), 0, 0},
                fmt::format("has {} frames, so frame {} does not exist", clip.frame_count(), last),
                fmt::format("name frames from 0 to {}", clip.frame_count() - 1));
  }
  clip.poses = {clip.poses.begin() + first, clip.poses.begin() + last + 1};
  return clip;
}

Synthesis as_captured(const Stimulus& stimulus) {
  Synthesis result;
  const motion::Recording recording = motion::read_motion(stimulus.clip->file);
  const motion::BodyMapping mapping = motion::recognise(recording);
  result.warnings = mapping.warnings;
  const motion::Clip clip = excerpt(motion::to_body(recording, mapping), *stimulus.clip);
  result.motion.name = stimulus.id;
  // What is modified stays at its own rate until then.
  result.motion.clip =
      stimulus.modify.empty() ? motion::resampled(clip, stimulus.output.fps) : clip;
  result.motion.keytimes = {0.0, result.motion.clip.duration_seconds()};
  result.planted_drift_m =
      motion::planted_drift(result.motion.clip, motion::foot_plants(result.motion.clip));
  return result;
}

Synthesis unmodified(const Stimulus& stimulus, const Repertoire& repertoire) {
  if (stimulus.clip) return as_captured(stimulus);
  if (!wishes_of(stimulus).empty()) return from_parameters(stimulus, repertoire);
  return from_weights(given_weights(stimulus.weights, repertoire), stimulus.output,
                      stimulus.interpolation, repertoire);
}

void apply_modifications(const Stimulus& stimulus, const Repertoire& repertoire,
                         Synthesis& synthesis) {
  ModifiedMotion modified = modify_motion(synthesis.motion, stimulus, repertoire);
  synthesis.motion = std::move(modified.motion);
  synthesis.planted_drift_m = modified.planted_drift_m;
  synthesis.modified = described_modifications(stimulus);
  synthesis.modified_share = modified.share;
  synthesis.findings = std::move(modified.findings);
  synthesis.notes = std::move(modified.notes);
  synthesis.warnings.insert(synthesis.warnings.end(), modified.warnings.begin(),
                            modified.warnings.end());
}

}  // namespace

Eigen::VectorXd weights_of(const Stimulus& stimulus, const Repertoire& repertoire) {
  assert(!stimulus.clip);
  if (wishes_of(stimulus).empty()) return given_weights(stimulus.weights, repertoire);
  const Wish wish = wish_of(stimulus);
  const FittedInterface sliders = fit_interface(wish.sliders, stimulus.interpolation, repertoire);
  return motion::weights_at(sliders.interpolator, wish.settings).weights;
}

Synthesis synthesize(const Stimulus& stimulus, const Repertoire& repertoire) {
  Synthesis result = unmodified(stimulus, repertoire);
  result.motion.name = stimulus.id;
  result.motion.clip.name = stimulus.id;
  if (stimulus.modify.empty()) {
    result.findings = motion::lint(result.motion.clip);
  } else {
    apply_modifications(stimulus, repertoire, result);
  }
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

motion::Clip shown_clip(const Synthesis& synthesis, const Output& output) {
  const motion::Clip& clip = synthesis.motion.clip;
  if (!clip.loops) return output.in_place ? motion::kept_in_place(clip) : clip;
  return motion::repeated(output.in_place ? motion::in_place(clip) : clip, output.cycles);
}

}  // namespace mien::pipeline

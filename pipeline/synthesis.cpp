#include "pipeline/synthesis.h"

#include <algorithm>
#include <cassert>

#include <fmt/format.h>

#include "motion/blend.h"
#include "motion/body_mapping.h"
#include "motion/cardinal_basis.h"
#include "motion/contact.h"
#include "motion/error.h"
#include "motion/foot_lock.h"
#include "motion/motion_file.h"
#include "motion/straighten.h"

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
  return motion::clipped_and_normalised(result / result.sum());
}

Eigen::Index parameter_row(const std::string& name, const ParameterTable& table) {
  const int row = table.find(name);
  if (row >= 0) return row;
  throw Error(fmt::format("the examples have no parameter \"{}\"", name),
              "name a scale that was rated, or a feature that all examples have");
}

Eigen::VectorXd parameter_weights(const Wish& wanted) {
  const auto& values = wanted.table.values;
  const auto dimensions = static_cast<Eigen::Index>(wanted.values.size());
  Eigen::MatrixXd examples(values.cols(), dimensions);
  Eigen::RowVectorXd wish(dimensions);
  for (Eigen::Index d = 0; d < dimensions; ++d) {
    const auto& [name, value] = wanted.values[static_cast<size_t>(d)];
    examples.col(d) = values.row(parameter_row(name, wanted.table)).transpose();
    wish[d] = value;
  }
  return motion::weights(motion::fit_cardinal_basis(examples), wish);
}

/// Features are measured of the motion; what people would say of it can only be summed.
NamedValues reached_parameters(const Stimulus& stimulus, const Wish& wanted,
                               const Repertoire& repertoire, const Synthesis& made) {
  NamedValues reached;
  std::optional<motion::FeatureValues> features;
  if (!stimulus.features.empty()) {
    features = motion::scaled(repertoire.features.scale, motion::measure_features(made.motion));
  }
  for (const auto& [name, value] : wanted.values) {
    const auto measured = features ? feature_parameter(name, *features) : std::nullopt;
    const auto row = wanted.table.values.row(parameter_row(name, wanted.table));
    reached.emplace_back(name, measured ? *measured : row.dot(made.weights));
  }
  return reached;
}

void warn_of_missed_parameters(const Wish& wanted, Synthesis& synthesis) {
  for (size_t i = 0; i < wanted.values.size(); ++i) {
    const auto& [name, value] = wanted.values[i];
    const double reached = synthesis.reached[i].second;
    if (std::abs(reached - value) <= told_difference) continue;
    const auto row = wanted.table.values.row(parameter_row(name, wanted.table));
    synthesis.warnings.push_back(
        fmt::format("{} {:.2f} was asked for and the blend has {:.2f}; the examples lie between "
                    "{:.2f} and {:.2f}",
                    name, value, reached, row.minCoeff(), row.maxCoeff()));
  }
}

/// Blends, and locks the feet of what travels.
void make_motion(const Output& output, const Interpolation& interpolation,
                 const Repertoire& repertoire, Synthesis& synthesis) {
  synthesis.motion = motion::blend(repertoire.examples, synthesis.weights,
                                   {.frames_per_second = output.fps,
                                    .rotations = interpolation.rotations,
                                    .warp = interpolation.time_warp});
  motion::Clip& clip = synthesis.motion.clip;
  const std::vector<motion::FootPlant> plants = motion::foot_plants(clip);
  if (interpolation.foot_lock) clip = motion::foot_locked(clip, plants);
  synthesis.planted_drift_m = motion::planted_drift(clip, plants);
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
  result.motion.clip = motion::resampled(clip, stimulus.output.fps);
  result.motion.keytimes = {0.0, result.motion.clip.duration_seconds()};
  result.planted_drift_m =
      motion::planted_drift(result.motion.clip, motion::foot_plants(result.motion.clip));
  return result;
}

}  // namespace

Wish wish_of(const Stimulus& stimulus, const Repertoire& repertoire) {
  if (!stimulus.features.empty()) return {stimulus.features, repertoire.features.table};
  return {stimulus.adjectives, repertoire.parameters};
}

Eigen::VectorXd weights_of(const Stimulus& stimulus, const Repertoire& repertoire) {
  assert(!stimulus.clip);
  const Wish wanted = wish_of(stimulus, repertoire);
  return wanted.values.empty() ? given_weights(stimulus.weights, repertoire)
                               : parameter_weights(wanted);
}

Synthesis synthesize(const Stimulus& stimulus, const Repertoire& repertoire) {
  if (stimulus.clip) return as_captured(stimulus);
  Synthesis result;
  result.weights = weights_of(stimulus, repertoire);
  make_motion(stimulus.output, stimulus.interpolation, repertoire, result);
  const Wish wanted = wish_of(stimulus, repertoire);
  result.asked = wanted.values;
  result.reached = reached_parameters(stimulus, wanted, repertoire, result);
  warn_of_missed_parameters(wanted, result);
  result.motion.name = stimulus.id;
  result.motion.clip.name = stimulus.id;
  return result;
}

Synthesis synthesize_example(const std::string& name, const Output& output,
                             const Interpolation& interpolation, const Repertoire& repertoire) {
  Synthesis result;
  result.weights = given_weights({{name, 1.0}}, repertoire);
  make_motion(output, interpolation, repertoire, result);
  result.motion.name = name;
  result.motion.clip.name = name;
  return result;
}

motion::Clip shown_clip(const Synthesis& synthesis, const Output& output) {
  const motion::Clip& clip = synthesis.motion.clip;
  if (!clip.loops) return clip;
  return motion::repeated(output.in_place ? motion::in_place(clip) : clip, output.cycles);
}

}  // namespace mien::pipeline

#include "pipeline/synthesis.h"

#include <algorithm>
#include <cassert>

#include <fmt/format.h>

#include "motion/blend.h"
#include "motion/body_mapping.h"
#include "motion/contact.h"
#include "motion/error.h"
#include "motion/foot_lock.h"
#include "motion/interpolation.h"
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
  return motion::direct_weights(result);
}

Eigen::Index parameter_row(const std::string& name, const Repertoire& repertoire) {
  const int row = repertoire.parameters.find(name);
  if (row >= 0) return row;
  throw Error(fmt::format("there is no parameter \"{}\"", name),
              "name a scale that was rated, or a group of such scales");
}

const motion::ExampleSet& examples_for(const Interpolation& interpolation,
                                       const Repertoire& repertoire) {
  return interpolation.foot_lock ? repertoire.settled : repertoire.examples;
}

/// What a stimulus asks of the examples, as numbers.
struct Wish {
  Eigen::MatrixXd examples;   ///< N × M: the examples' values of the named parameters
  Eigen::RowVectorXd values;  ///< M
  std::vector<std::string> names;
};

Wish wish_of(const NamedValues& adjectives, const Repertoire& repertoire) {
  const auto& values = repertoire.parameters.values;
  const auto dimensions = static_cast<Eigen::Index>(adjectives.size());
  Wish wish{Eigen::MatrixXd(values.cols(), dimensions), Eigen::RowVectorXd(dimensions), {}};
  for (Eigen::Index d = 0; d < dimensions; ++d) {
    const auto& [name, value] = adjectives[static_cast<size_t>(d)];
    wish.examples.col(d) = values.row(parameter_row(name, repertoire)).transpose();
    wish.values[d] = value;
    wish.names.push_back(name);
  }
  return wish;
}

motion::Interpolator interpolator_of(const Stimulus& stimulus, const Wish& wish,
                                     const Repertoire& repertoire) {
  return motion::fit_interpolator(examples_for(stimulus.interpolation, repertoire), wish.examples,
                                  stimulus.interpolation.weights, wish.names);
}

void report_parameters(const NamedValues& adjectives, const Repertoire& repertoire,
                       Synthesis& synthesis) {
  synthesis.asked = adjectives;
  for (const auto& [name, value] : adjectives) {
    const double reached =
        repertoire.parameters.values.row(parameter_row(name, repertoire)).dot(synthesis.weights);
    synthesis.reached.emplace_back(name, reached);
    if (std::abs(reached - value) <= told_difference) continue;
    const auto row = repertoire.parameters.values.row(parameter_row(name, repertoire));
    synthesis.warnings.push_back(
        fmt::format("{} {:.2f} was asked for and the blend has {:.2f}; the examples lie between "
                    "{:.2f} and {:.2f}",
                    name, value, reached, row.minCoeff(), row.maxCoeff()));
  }
}

motion::BlendOptions blend_options(const Output& output, const Interpolation& interpolation) {
  return {.frames_per_second = output.fps,
          .rotations = interpolation.rotations,
          .warp = interpolation.time_warp};
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
  result.motion = motion::blend(examples_for(interpolation, repertoire), weights,
                                blend_options(output, interpolation));
  lock_feet(interpolation, result);
  return result;
}

Synthesis from_adjectives(const Stimulus& stimulus, const Repertoire& repertoire) {
  const Interpolation& how = stimulus.interpolation;
  const Wish wish = wish_of(stimulus.adjectives, repertoire);
  const motion::Interpolator interpolator = interpolator_of(stimulus, wish, repertoire);
  const motion::InterpolatedWeights found = motion::weights_at(interpolator, wish.values);
  Synthesis result;
  result.weights = found.weights;
  result.expected_error_m = found.expected_error_m;
  result.warnings = interpolator.remarks;
  result.warnings.insert(result.warnings.end(), found.remarks.begin(), found.remarks.end());
  report_parameters(stimulus.adjectives, repertoire, result);
  result.motion = motion::motion_at(interpolator, examples_for(how, repertoire), wish.values,
                                    blend_options(stimulus.output, how));
  lock_feet(how, result);
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
  result.motion.clip = motion::resampled(clip, stimulus.output.fps);
  result.motion.keytimes = {0.0, result.motion.clip.duration_seconds()};
  result.planted_drift_m =
      motion::planted_drift(result.motion.clip, motion::foot_plants(result.motion.clip));
  return result;
}

}  // namespace

Eigen::VectorXd weights_of(const Stimulus& stimulus, const Repertoire& repertoire) {
  assert(!stimulus.clip);
  if (stimulus.adjectives.empty()) return given_weights(stimulus.weights, repertoire);
  const Wish wish = wish_of(stimulus.adjectives, repertoire);
  return motion::weights_at(interpolator_of(stimulus, wish, repertoire), wish.values).weights;
}

Synthesis synthesize(const Stimulus& stimulus, const Repertoire& repertoire) {
  if (stimulus.clip) return as_captured(stimulus);
  Synthesis result = stimulus.adjectives.empty()
                         ? from_weights(given_weights(stimulus.weights, repertoire),
                                        stimulus.output, stimulus.interpolation, repertoire)
                         : from_adjectives(stimulus, repertoire);
  result.motion.name = stimulus.id;
  result.motion.clip.name = stimulus.id;
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
  if (!clip.loops) return clip;
  return motion::repeated(output.in_place ? motion::in_place(clip) : clip, output.cycles);
}

}  // namespace mien::pipeline

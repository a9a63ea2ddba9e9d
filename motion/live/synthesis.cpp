#include "motion/live/synthesis.h"

#include <optional>
#include <utility>
#include <variant>

#include "motion/gait/foot_lock.h"
#include "motion/gait/gait_plants.h"

namespace mien::motion {

namespace {

constexpr int feature_trials = 8;
constexpr double feature_met = 0.005;

void lock_feet(const SynthesisContext& context, SynthesizedMotion& made) {
  Clip& clip = made.motion.clip;
  made.plants = gait_plants(clip);
  if (context.how.foot_lock) clip = foot_locked(clip, made.plants);
}

BlendOptions blend_options(const SynthesisContext& context) {
  return {.frames_per_second = context.frames_per_second,
          .rotations = context.how.rotations,
          .warp = context.how.time_warp};
}

}  // namespace

SynthesizedMotion synthesize_from_weights(const Eigen::VectorXd& weights,
                                          const SynthesisContext& context) {
  SynthesizedMotion made;
  made.found.weights = weights;
  if (context.examples.blendable) {
    made.motion = blend(context.examples, weights, blend_options(context));
  } else {
    Eigen::Index only = 0;
    weights.maxCoeff(&only);
    const ExampleSet alone{"", {context.examples.examples[static_cast<std::size_t>(only)]}};
    made.motion = blend(alone, Eigen::VectorXd::Ones(1), blend_options(context));
  }
  lock_feet(context, made);
  return made;
}

SynthesizedMotion synthesize_at(const FittedInterface& interface,
                                const Eigen::RowVectorXd& settings,
                                const SynthesisContext& context) {
  SynthesizedMotion made;
  made.found = weights_at(interface.interpolator, settings);
  const bool is_blend = !std::holds_alternative<StatisticalModel>(interface.interpolator.method);
  made.motion = is_blend ? blend(context.examples, made.found.weights, blend_options(context))
                         : motion_of(interface, settings, context.how, context.examples,
                                     context.frames_per_second);
  lock_feet(context, made);
  return made;
}

Eigen::RowVectorXd measured_parameters(const std::vector<std::string>& names,
                                       const SynthesizedMotion& made,
                                       const FeatureTable& features) {
  const FeatureValues values = scaled(features.scale, measure_features(made.motion));
  Eigen::RowVectorXd measured(static_cast<Eigen::Index>(names.size()));
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto value = feature_parameter(names[i], values);
    const auto row = features.table.values.row(parameter_row(names[i], features.table));
    measured[static_cast<Eigen::Index>(i)] = value ? *value : row.dot(made.found.weights);
  }
  return measured;
}

SynthesizedMotion synthesize_with_features(const FittedInterface& interface,
                                           const Eigen::RowVectorXd& requested,
                                           const SynthesisContext& context,
                                           const FeatureTable& features) {
  Eigen::RowVectorXd settings = requested;
  std::optional<SynthesizedMotion> best;
  double least = 0.0;
  for (int trial = 0; trial < feature_trials; ++trial) {
    SynthesizedMotion made = synthesize_at(interface, settings, context);
    const Eigen::RowVectorXd missed =
        requested - measured_parameters(interface.sliders.sliders, made, features);
    const double worst = missed.lpNorm<Eigen::Infinity>();
    if (!best || worst < least) {
      best = std::move(made);
      least = worst;
    }
    if (least < feature_met) break;
    settings += missed;
  }
  return std::move(*best);
}

SynthesizedMotion synthesize_for(const FittedInterface& interface,
                                 const Eigen::RowVectorXd& requested,
                                 const SynthesisContext& context, const FeatureTable& features) {
  const bool is_met = interface.sliders.kind == InterfaceKind::features &&
                      context.how.weights.method == InterpolationMethod::reach;
  return is_met ? synthesize_with_features(interface, requested, context, features)
                : synthesize_at(interface, requested, context);
}

}  // namespace mien::motion

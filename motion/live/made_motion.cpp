#include "motion/live/made_motion.h"

#include <optional>
#include <utility>
#include <variant>

#include "motion/gait/contact.h"
#include "motion/gait/foot_lock.h"
#include "motion/measures/features/feature_parameter.h"

namespace mien::motion {

namespace {

constexpr int feature_trials = 8;
constexpr double feature_met = 0.005;

void lock_feet(const Making& making, MadeMotion& made) {
  Clip& clip = made.motion.clip;
  made.plants = foot_plants(clip);
  if (making.how.foot_lock) clip = foot_locked(clip, made.plants);
}

BlendOptions blend_options(const Making& making) {
  return {.frames_per_second = making.frames_per_second,
          .rotations = making.how.rotations,
          .warp = making.how.time_warp};
}

}  // namespace

MadeMotion made_of_weights(const Eigen::VectorXd& weights, const Making& making) {
  MadeMotion made;
  made.found.weights = weights;
  if (making.examples.blendable) {
    made.motion = blend(making.examples, weights, blend_options(making));
  } else {
    Eigen::Index only = 0;
    weights.maxCoeff(&only);
    const ExampleSet alone{"", {making.examples.examples[static_cast<std::size_t>(only)]}};
    made.motion = blend(alone, Eigen::VectorXd::Ones(1), blend_options(making));
  }
  lock_feet(making, made);
  return made;
}

MadeMotion made_at(const FittedInterface& interface, const Eigen::RowVectorXd& settings,
                   const Making& making) {
  MadeMotion made;
  made.found = weights_at(interface.interpolator, settings);
  const bool is_blend = !std::holds_alternative<StatisticalModel>(interface.interpolator.method);
  made.motion = is_blend ? blend(making.examples, made.found.weights, blend_options(making))
                         : motion_of(interface, settings, making.how, making.examples,
                                     making.frames_per_second);
  lock_feet(making, made);
  return made;
}

Eigen::RowVectorXd measured_parameters(const std::vector<std::string>& names,
                                       const MadeMotion& made, const FeatureTable& features) {
  const FeatureValues values = scaled(features.scale, measure_features(made.motion));
  Eigen::RowVectorXd measured(static_cast<Eigen::Index>(names.size()));
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto value = feature_parameter(names[i], values);
    const auto row = features.table.values.row(parameter_row(names[i], features.table));
    measured[static_cast<Eigen::Index>(i)] = value ? *value : row.dot(made.found.weights);
  }
  return measured;
}

MadeMotion with_met_features(const FittedInterface& interface, const Eigen::RowVectorXd& wished,
                             const Making& making, const FeatureTable& features) {
  Eigen::RowVectorXd settings = wished;
  std::optional<MadeMotion> best;
  double least = 0.0;
  for (int trial = 0; trial < feature_trials; ++trial) {
    MadeMotion made = made_at(interface, settings, making);
    const Eigen::RowVectorXd missed =
        wished - measured_parameters(interface.sliders.sliders, made, features);
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

MadeMotion made_for(const FittedInterface& interface, const Eigen::RowVectorXd& wished,
                    const Making& making, const FeatureTable& features) {
  const bool is_met = interface.sliders.kind == InterfaceKind::features &&
                      making.how.weights.method == InterpolationMethod::reach;
  return is_met ? with_met_features(interface, wished, making, features)
                : made_at(interface, wished, making);
}

}  // namespace mien::motion

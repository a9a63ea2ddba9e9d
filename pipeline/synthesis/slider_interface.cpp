#include "pipeline/synthesis/slider_interface.h"

#include <algorithm>

#include "motion/interpolation/blend.h"

namespace mien::pipeline {

const char* name_of(InterfaceKind kind) {
  switch (kind) {
    case InterfaceKind::adjectives:
      return "adjectives";
    case InterfaceKind::features:
      return "features";
    case InterfaceKind::weights:
      break;
  }
  return "weights";
}

const motion::ExampleSet& examples_for(const Interpolation& interpolation,
                                       const Repertoire& repertoire) {
  return interpolation.foot_lock ? repertoire.settled : repertoire.examples;
}

FittedInterface fit_interface(const SliderInterface& interface, const Interpolation& interpolation,
                              const Repertoire& repertoire, Eigen::Index held) {
  const motion::ExampleSet& examples = examples_for(interpolation, repertoire);
  if (interface.kind == InterfaceKind::weights) {
    const auto count = static_cast<Eigen::Index>(interface.sliders.size());
    return {interface, motion::fit_interpolator(examples, Eigen::MatrixXd::Identity(count, count),
                                                {.method = motion::InterpolationMethod::direct})};
  }
  const ParameterTable& table =
      interface.kind == InterfaceKind::features ? repertoire.features.table : repertoire.parameters;
  return {interface,
          motion::fit_interpolator(examples, places_of_examples(interface.sliders, table),
                                   interpolation.weights, interface.sliders, held)};
}

motion::Example motion_of(const FittedInterface& interface, const Eigen::RowVectorXd& settings,
                          const Interpolation& interpolation, const Repertoire& repertoire,
                          double frames_per_second) {
  return motion::motion_at(interface.interpolator, examples_for(interpolation, repertoire),
                           settings,
                           {.frames_per_second = frames_per_second,
                            .rotations = interpolation.rotations,
                            .warp = interpolation.time_warp});
}

Eigen::RowVectorXd ideal_settings(const SliderInterface& interface, const motion::Example& target,
                                  const Eigen::VectorXd& weights, const Repertoire& repertoire) {
  if (interface.kind == InterfaceKind::weights) {
    return weights.cwiseMax(0.0).transpose() / weights.maxCoeff();
  }
  const bool by_features = interface.kind == InterfaceKind::features;
  const motion::FeatureValues features =
      motion::scaled(repertoire.features.scale, motion::measure_features(target));
  Eigen::RowVectorXd settings(static_cast<Eigen::Index>(interface.sliders.size()));
  for (std::size_t i = 0; i < interface.sliders.size(); ++i) {
    const std::string& slider = interface.sliders[i];
    const double value =
        by_features
            ? feature_parameter(slider, features).value_or(0.5)
            : repertoire.parameters.values.row(repertoire.parameters.find(slider)).dot(weights);
    settings[static_cast<Eigen::Index>(i)] = std::clamp(value, 0.0, 1.0);
  }
  return settings;
}

Eigen::RowVectorXd rounded(const Eigen::RowVectorXd& settings, double step) {
  return (settings / step).array().round().matrix() * step;
}

}  // namespace mien::pipeline

#include "pipeline/production/synthesis/slider_interface.h"

#include <algorithm>

namespace mien::pipeline {

const motion::ExampleSet& examples_for(const Interpolation& interpolation,
                                       const Repertoire& repertoire) {
  return interpolation.foot_lock ? repertoire.settled : repertoire.examples;
}

FittedInterface fit_interface(const SliderInterface& interface, const Interpolation& interpolation,
                              const Repertoire& repertoire, Eigen::Index held) {
  const ParameterTable& table =
      interface.kind == InterfaceKind::features ? repertoire.features.table : repertoire.parameters;
  return motion::fit_interface(interface, interpolation, examples_for(interpolation, repertoire),
                               table, held);
}

motion::Example motion_of(const FittedInterface& interface, const Eigen::RowVectorXd& settings,
                          const Interpolation& interpolation, const Repertoire& repertoire,
                          double frames_per_second) {
  return motion::motion_of(interface, settings, interpolation,
                           examples_for(interpolation, repertoire), frames_per_second);
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

#include "motion/live/slider_interface.h"

namespace mien::motion {

FittedInterface fit_interface(const SliderInterface& interface, const SynthesisOptions& how,
                              const ExampleSet& examples, const ParameterTable& table,
                              Eigen::Index held) {
  if (interface.kind == InterfaceKind::weights) {
    const auto count = static_cast<Eigen::Index>(interface.sliders.size());
    return {interface, fit_interpolator(examples, Eigen::MatrixXd::Identity(count, count),
                                        {.method = InterpolationMethod::direct})};
  }
  return {interface, fit_interpolator(examples, places_of_examples(interface.sliders, table),
                                      how.weights, interface.sliders, held)};
}

Example motion_of(const FittedInterface& interface, const Eigen::RowVectorXd& settings,
                  const SynthesisOptions& how, const ExampleSet& examples,
                  double frames_per_second) {
  return motion_at(
      interface.interpolator, examples, settings,
      {.frames_per_second = frames_per_second, .rotations = how.rotations, .warp = how.time_warp});
}

}  // namespace mien::motion

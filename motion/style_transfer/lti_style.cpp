#include "motion/style_transfer/lti_style.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "motion/error.h"
#include "motion/math/singular_values.h"

namespace mien::motion {

namespace {

void require_options(const LtiStyleOptions& options) {
  if (options.order < 1 || options.order > 10) {
    throw Error("an order of " + std::to_string(options.order) + " states is out of range",
                "give 1 to 10");
  }
  if (options.inputs < 1 || options.inputs > curve_count) {
    throw Error(
        "a style model with " + std::to_string(options.inputs) + " inputs cannot be",
        "give 1 to " + std::to_string(curve_count) + ", as many as there are frames at most");
  }
}

/// Logarithm of the styled motion's seconds per second of the neutral one, frame by frame.
Eigen::VectorXd log_rates(const std::vector<double>& times, const MotionCurves& neutral,
                          const MotionCurves& styled) {
  const auto frames = static_cast<int>(times.size());
  const bool loops = neutral.timing.loops;
  const double unit = neutral.timing.frames_per_second / styled.timing.frames_per_second;
  Eigen::VectorXd rates(frames);
  for (int i = 0; i < frames; ++i) {
    const int before = loops ? i - 1 : std::max(i - 1, 0);
    const int after = loops ? i + 1 : std::min(i + 1, frames - 1);
    const auto time = [&](int frame) {
      return times[(frame + frames) % frames] + (frame < 0         ? -frame_span(styled)
                                                 : frame >= frames ? frame_span(styled)
                                                                   : 0.0);
    };
    const double rate = unit * (time(after) - time(before)) / (after - before);
    rates[i] = std::log(std::max(rate, 0.1));
  }
  return rates;
}

Eigen::MatrixXd principal_components(const Eigen::MatrixXd& centred, int count) {
  const Eigen::MatrixXd directions = singular_values(centred).v;
  return directions.leftCols(std::min<Eigen::Index>(count, directions.cols()));
}

Eigen::MatrixXd about_mean(const Eigen::MatrixXd& values) {
  return values.rowwise() - values.colwise().mean();
}

InitialState initial_state(bool loops) {
  return loops ? InitialState::periodic : InitialState::settled;
}

/// Every frame lasting exp(log_rates) frames; the way stays even.
MotionCurves with_rates(const MotionCurves& curves, const Eigen::VectorXd& log_rates) {
  const int frames = curves.frame_count();
  const bool loops = curves.timing.loops;
  std::vector<double> starts = {0.0};
  for (int i = 0; i < (loops ? frames : frames - 1); ++i) {
    starts.push_back(starts.back() +
                     0.5 * (std::exp(log_rates[i]) + std::exp(log_rates[(i + 1) % frames])));
  }
  const int steps = std::max(4, static_cast<int>(std::lround(starts.back())));
  MotionCurves result = curves;
  result.values.resize(loops ? steps : steps + 1, curve_count);
  size_t k = 0;
  for (int i = 0; i < result.frame_count(); ++i) {
    const double time = i * (starts.back() / steps);
    while (k + 2 < starts.size() && time >= starts[k + 1]) ++k;
    const double frame = static_cast<double>(k) + (time - starts[k]) / (starts[k + 1] - starts[k]);
    result.values.row(i) = curves_at(curves, frame / frame_span(curves));
  }
  return result;
}

double joint_error(const Eigen::MatrixXd& differences) {
  const auto joints = differences.middleCols(3, 3 * body_joint_count);
  return std::sqrt(joints.squaredNorm() /
                   static_cast<double>(differences.rows() * body_joint_count));
}

}  // namespace

LtiStyleModel fit_lti_style(const Clip& neutral, const Clip& styled,
                            const LtiStyleOptions& options) {
  require_options(options);
  if (neutral.loops != styled.loops) {
    throw Error("of \"" + neutral.name + "\" and \"" + styled.name + "\" only one is cyclic",
                "learn a style from two motions of one kind");
  }
  LtiStyleModel model;
  model.means = mean_rotations(neutral);
  model.loops = neutral.loops;
  model.frames_per_second = neutral.frames_per_second;
  const MotionCurves from = to_curves(neutral, model.means);
  const MotionCurves to = to_curves(styled, model.means);
  IterativeMotionWarpingOptions warping = options.warping;
  // Second differences over frames: the same stiffness over seconds at every frame rate.
  warping.smoothness *= std::pow(neutral.frames_per_second / 30.0, 4);
  model.correspondence =
      iterative_motion_warping(with_closing_frame(from), with_closing_frame(to), warping);
  const std::vector<double> times = smoothed_times(model.correspondence.times, from, to);

  Eigen::MatrixXd outputs(from.frame_count(), curve_count + 1);
  for (int i = 0; i < from.frame_count(); ++i) {
    outputs.row(i).head(curve_count) =
        curves_at(to, times[i] / frame_span(to)) - from.values.row(i);
  }
  outputs.col(curve_count) = log_rates(times, from, to);
  model.mean_difference = outputs.colwise().mean();
  model.displacement_difference = to.way - from.way;

  const Eigen::MatrixXd centred = about_mean(from.values);
  model.components = principal_components(centred, options.inputs);
  const Eigen::MatrixXd inputs = centred * model.components;
  model.system = identified(inputs, about_mean(outputs), options.order, initial_state(model.loops));
  model.error_radians = joint_error(simulated(model.system, inputs, initial_state(model.loops)) -
                                    about_mean(outputs));
  return model;
}

Clip translated(const Clip& motion, const LtiStyleModel& model, const LtiStyleOptions& options) {
  MotionCurves curves = to_curves(resampled(motion, model.frames_per_second), model.means);
  const Eigen::MatrixXd inputs = about_mean(curves.values) * model.components;
  Eigen::MatrixXd outputs = simulated(model.system, inputs, initial_state(motion.loops));
  outputs.rowwise() += model.mean_difference;
  curves.values += options.amount * outputs.leftCols(curve_count);
  if (motion.loops && model.loops) curves.way += options.amount * model.displacement_difference;
  if (options.timing) curves = with_rates(curves, options.amount * outputs.col(curve_count));
  return resampled(to_clip(curves), motion.frames_per_second);
}

}  // namespace mien::motion

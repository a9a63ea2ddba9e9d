#include "motion/style_transfer/lti_style.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "motion/error.h"
#include "motion/math/filter.h"
#include "motion/math/singular_values.h"

namespace mien::motion {

namespace {

constexpr double largest_pole = 0.97;
// Keeps walks unlike the neutral one from being thrown about.
constexpr double output_ridge = 1e-3;
// Differences from the inputs learnt, as a share of these (RMS).
constexpr double known_inputs = 0.1;
constexpr double new_inputs = 0.4;
constexpr double style_fades = 1.5;  // deviation, in that of the farthest frame learnt
constexpr double style_ends = 3.0;
constexpr double share_cutoff_hz = 2.0;
constexpr double least_residual = 0.05;  // of the largest input, squared
constexpr double most_output = 1.5;      // of the largest output learnt

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

/// `value` up to `from`; beyond, it approaches `to` (both positive; the sign is kept).
double softly_limited(double value, double from, double to) {
  const double size = std::abs(value);
  if (size <= from || to <= from) return std::clamp(value, -from, from);
  const double room = to - from;
  return std::copysign(from + room * (1.0 - std::exp(-(size - from) / room)), value);
}

LtiStyleRange range_of(const Eigen::MatrixXd& centred, const Eigen::MatrixXd& inputs,
                       const Eigen::MatrixXd& components, const Eigen::MatrixXd& outputs) {
  LtiStyleRange range;
  const double frames = static_cast<double>(inputs.rows());
  range.input_variance = inputs.cwiseAbs2().colwise().sum() / frames;
  range.input_variance = range.input_variance.cwiseMax(1e-12);
  range.largest_score = (inputs.cwiseAbs2().array().rowwise() / range.input_variance.array())
                            .rowwise()
                            .sum()
                            .maxCoeff();
  const double residual =
      (centred - inputs * components.transpose()).rowwise().squaredNorm().maxCoeff();
  // A little of the inputs themselves, so that a model which explains all tolerates some noise.
  range.largest_residual = residual + least_residual * inputs.rowwise().squaredNorm().maxCoeff();
  range.largest_output = outputs.cwiseAbs().colwise().maxCoeff();
  return range;
}

/// How far each frame is from the mean, as a multiple of the farthest frame learnt.
Eigen::VectorXd deviations(const Eigen::MatrixXd& centred, const Eigen::MatrixXd& inputs,
                           const LtiStyleModel& model) {
  const LtiStyleRange& range = model.range;
  const Eigen::VectorXd scores =
      (inputs.cwiseAbs2().array().rowwise() / range.input_variance.array()).rowwise().sum();
  const Eigen::VectorXd residuals =
      (centred - inputs * model.components.transpose()).rowwise().squaredNorm();
  const auto share = [](double value, double largest) {
    return largest > 0.0 ? value / largest : (value > 0.0 ? HUGE_VAL : 0.0);
  };
  Eigen::VectorXd result(scores.size());
  for (Eigen::Index i = 0; i < scores.size(); ++i) {
    result[i] = std::sqrt(std::max(share(scores[i], range.largest_score),
                                   share(residuals[i], range.largest_residual)));
  }
  return result;
}

/// The share of the style that each frame takes, 0 … 1.
std::vector<double> style_shares(const Eigen::VectorXd& deviations, const Clip& motion) {
  std::vector<double> shares;
  for (const double deviation : deviations) {
    const double x = (deviation - style_fades) / (style_ends - style_fades);
    shares.push_back(1.0 - smooth_step(std::clamp(x, 0.0, 1.0)));
  }
  if (*std::min_element(shares.begin(), shares.end()) == 1.0) return shares;
  shares = low_pass(shares, share_cutoff_hz, motion.frames_per_second,
                    motion.loops ? SignalEnds::periodic : SignalEnds::open);
  for (double& share : shares) share = std::clamp(share, 0.0, 1.0);
  return shares;
}

/// Curves and the frames that they have in the curves before.
struct TimedCurves {
  MotionCurves curves;
  std::vector<double> source_frames;
};

/// Every frame lasting exp(log_rates) frames; the way stays even.
TimedCurves with_rates(const MotionCurves& curves, const Eigen::VectorXd& log_rates) {
  const int frames = curves.frame_count();
  const bool loops = curves.timing.loops;
  std::vector<double> starts = {0.0};
  for (int i = 0; i < (loops ? frames : frames - 1); ++i) {
    starts.push_back(starts.back() +
                     0.5 * (std::exp(log_rates[i]) + std::exp(log_rates[(i + 1) % frames])));
  }
  const int steps = std::max(4, static_cast<int>(std::lround(starts.back())));
  TimedCurves result{curves, {}};
  result.curves.values.resize(loops ? steps : steps + 1, curve_count);
  size_t k = 0;
  for (int i = 0; i < result.curves.frame_count(); ++i) {
    const double time = i * (starts.back() / steps);
    while (k + 2 < starts.size() && time >= starts[k + 1]) ++k;
    const double frame = static_cast<double>(k) + (time - starts[k]) / (starts[k + 1] - starts[k]);
    result.curves.values.row(i) = curves_at(curves, frame / frame_span(curves));
    result.source_frames.push_back(frame);
  }
  return result;
}

/// Outputs about their mean, limited to what was learnt.
Eigen::MatrixXd limited(Eigen::MatrixXd outputs, const Eigen::RowVectorXd& largest) {
  for (Eigen::Index c = 0; c < outputs.cols(); ++c) {
    for (Eigen::Index i = 0; i < outputs.rows(); ++i) {
      outputs(i, c) = softly_limited(outputs(i, c), largest[c], most_output * largest[c]);
    }
  }
  return outputs;
}

/// Logarithms of the rates of time, limited.
Eigen::VectorXd limited_rates(const Eigen::VectorXd& log_rates, const LtiStyleModel& model) {
  const double learnt =
      std::abs(model.mean_difference[curve_count]) + model.range.largest_output[curve_count];
  const double from = std::max(std::log(2.0), learnt);
  return log_rates.unaryExpr(
      [&](double rate) { return softly_limited(rate, from, from + std::log(1.5)); });
}

/// What the style adds to curves.
struct StyleOutputs {
  Eigen::MatrixXd values;  ///< frames × (curve_count + 1)
  double deviating_share = 0.0;
  double mean_share = 1.0;  ///< of the style that the frames take
};

/// How unlike the inputs learnt others are at the same share of time: 0 … 1.
double novelty(const Eigen::MatrixXd& inputs, const Eigen::MatrixXd& learnt) {
  double squares = 0.0;
  for (Eigen::Index i = 0; i < inputs.rows(); ++i) {
    squares += (inputs.row(i) - learnt.row(i * learnt.rows() / inputs.rows())).squaredNorm();
  }
  const double size = learnt.squaredNorm() / static_cast<double>(learnt.rows());
  const double mean = squares / static_cast<double>(inputs.rows());
  const double difference = size > 0.0 ? std::sqrt(mean / size) : 0.0;
  return smooth_step(
      std::clamp((difference - known_inputs) / (new_inputs - known_inputs), 0.0, 1.0));
}

Eigen::MatrixXd simulated_by_both(const Eigen::MatrixXd& inputs, const LtiStyleModel& model,
                                  InitialState initial) {
  const double share = novelty(inputs, model.inputs);
  Eigen::MatrixXd outputs = simulated(model.system, inputs, initial);
  if (share == 0.0) return outputs;
  return (1.0 - share) * outputs + share * simulated(model.robust_system, inputs, initial);
}

StyleOutputs outputs_for(const MotionCurves& curves, const LtiStyleModel& model) {
  const Eigen::MatrixXd centred = about_mean(curves.values);
  const Eigen::MatrixXd inputs = centred * model.components;
  StyleOutputs outputs;
  outputs.values = limited(simulated_by_both(inputs, model, initial_state(curves.timing.loops)),
                           model.range.largest_output);
  outputs.values.rowwise() += model.mean_difference;
  const Eigen::VectorXd far = deviations(centred, inputs, model);
  const std::vector<double> shares = style_shares(far, curves.timing);
  const auto frames = static_cast<double>(shares.size());
  outputs.mean_share = 0.0;
  for (size_t i = 0; i < shares.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    outputs.values.row(row) *= shares[i];
    outputs.mean_share += shares[i] / frames;
    if (far[row] > style_fades) outputs.deviating_share += 1.0 / frames;
  }
  return outputs;
}

double span_of(const Clip& clip) { return clip.frame_count() - (clip.loops ? 0 : 1); }

/// `source` (frames of `before` for each frame of `restyled`; empty: the same frames) for the
/// frames of `resampled_clip`, in frames of `motion`.
std::vector<double> source_frames_at(const std::vector<double>& source, const Clip& restyled,
                                     const Clip& resampled_clip, const Clip& before,
                                     const Clip& motion) {
  std::vector<double> frames;
  const double scale = span_of(motion) / span_of(before);
  for (int i = 0; i < resampled_clip.frame_count(); ++i) {
    const double at = i * span_of(restyled) / span_of(resampled_clip);
    const auto k = static_cast<size_t>(at);
    const auto known = [&](size_t index) {
      if (source.empty()) return static_cast<double>(index);
      return index < source.size() ? source[index] : span_of(before);
    };
    frames.push_back(scale *
                     (known(k) + (at - static_cast<double>(k)) * (known(k + 1) - known(k))));
  }
  return frames;
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
  model.frames = neutral.frame_count();
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
  model.inputs = inputs;
  const InitialState initial = initial_state(model.loops);
  model.system = identified(inputs, about_mean(outputs), options.order, initial, largest_pole);
  model.robust_system =
      identified(inputs, about_mean(outputs), options.order, initial, largest_pole, output_ridge);
  model.error_radians = joint_error(simulated(model.system, inputs, initial) - about_mean(outputs));
  model.range = range_of(centred, inputs, model.components, about_mean(outputs));
  return model;
}

LtiTranslation translation(const Clip& motion, const LtiStyleModel& model,
                           const LtiStyleOptions& options) {
  const Clip at_rate = resampled(motion, model.frames_per_second);
  MotionCurves curves = to_curves(at_rate, model.means);
  const bool is_cycle = motion.loops && model.loops;
  const StyleOutputs style =
      outputs_for(is_cycle ? resampled(curves, model.frames) : curves, model);
  LtiTranslation result;
  result.deviating_share = style.deviating_share;
  MotionCurves added = curves;  // one column more, for the rate of time
  added.values = style.values;
  added = resampled(added, curves.frame_count());
  curves.values += options.amount * added.values.leftCols(curve_count);
  if (is_cycle) curves.way += options.amount * style.mean_share * model.displacement_difference;
  TimedCurves timed{curves, {}};
  if (options.timing) {
    timed =
        with_rates(curves, limited_rates(options.amount * added.values.col(curve_count), model));
  }
  const Clip restyled = to_clip(timed.curves);
  result.clip = resampled(restyled, motion.frames_per_second);
  result.source_frames =
      source_frames_at(timed.source_frames, restyled, result.clip, at_rate, motion);
  return result;
}

Clip translated(const Clip& motion, const LtiStyleModel& model, const LtiStyleOptions& options) {
  return translation(motion, model, options).clip;
}

}  // namespace mien::motion

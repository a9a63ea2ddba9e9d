#include "motion/interpolation/statistical_model.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <Eigen/Eigenvalues>

#include "motion/interpolation/time_warp.h"
#include "motion/math/linear_system.h"
#include "motion/math/rotation.h"

namespace mien::motion {

namespace {

/// Numbers at one moment: six a joint, then the root.
constexpr Eigen::Index numbers_per_moment = 6 * body_joint_count + 3;

/// Share of the duration at each sample. The last moment of a loop is its first.
double share_of(int sample, int samples, bool loops) {
  return static_cast<double>(sample) / (loops ? samples : samples - 1);
}

void write_pose(const Pose& pose, const Vec3& travelled, Eigen::Ref<Eigen::VectorXd> moment) {
  for (Eigen::Index j = 0; j < body_joint_count; ++j) {
    const DirectionVectors d = to_direction_vectors(pose.rotations[static_cast<size_t>(j)]);
    moment.segment<3>(6 * j) = d.d1;
    moment.segment<3>(6 * j + 3) = d.d2;
  }
  moment.tail<3>() = pose.root_position - travelled;
}

Pose read_pose(const Eigen::VectorXd& moment, const Vec3& travelled, const Pose& previous) {
  Pose pose;
  for (Eigen::Index j = 0; j < body_joint_count; ++j) {
    const DirectionVectors d{moment.segment<3>(6 * j), moment.segment<3>(6 * j + 3)};
    const Quat& before = previous.rotations[static_cast<size_t>(j)];
    pose.rotations.push_back(in_hemisphere_of(before, to_rotation(d, before)));
  }
  pose.root_position = moment.tail<3>() + travelled;
  return pose;
}

Eigen::VectorXd registered(const Example& example, const std::vector<double>& keytimes, int samples,
                           WarpShape shape) {
  const auto intervals = static_cast<Eigen::Index>(keytimes.size()) - 1;
  Eigen::VectorXd vector(samples * numbers_per_moment + intervals + 3);
  const TimeWarp warp = make_time_warp(keytimes, example.keytimes, shape, example.clip.loops);
  for (int s = 0; s < samples; ++s) {
    const double share = share_of(s, samples, example.clip.loops);
    write_pose(pose_at(example.clip, warped(warp, share * keytimes.back())),
               share * example.clip.cycle_displacement,
               vector.segment(s * numbers_per_moment, numbers_per_moment));
  }
  for (Eigen::Index k = 0; k < intervals; ++k) {
    const auto at = static_cast<size_t>(k);
    vector[samples * numbers_per_moment + k] =
        std::log(example.keytimes[at + 1] - example.keytimes[at]);
  }
  vector.tail<3>() = example.clip.cycle_displacement;
  return vector;
}

/// Principal components by the N × N matrix of inner products, which is the smaller one.
void find_components(StatisticalModel& model, const Eigen::MatrixXd& centred, double share) {
  const Eigen::MatrixXd inner = centred.transpose() * centred;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(inner);
  const Eigen::VectorXd values = solver.eigenvalues().reverse().cwiseMax(0.0);
  const Eigen::MatrixXd vectors = solver.eigenvectors().rowwise().reverse();
  const double total = values.sum();
  Eigen::Index count = 0;
  double kept = 0.0;
  while (count < values.size() && kept < share * total && values[count] > 1e-12 * total) {
    kept += values[count++];
  }
  model.kept_variance = total > 0.0 ? kept / total : 1.0;
  model.variances = values.head(count) / static_cast<double>(centred.cols());
  model.components = centred * vectors.leftCols(count);
  for (Eigen::Index c = 0; c < count; ++c) {
    // A component and its negative are the same; the sign is fixed by the largest number.
    Eigen::Index largest = 0;
    model.components.col(c).cwiseAbs().maxCoeff(&largest);
    const double sign = model.components(largest, c) < 0.0 ? -1.0 : 1.0;
    model.components.col(c) *= sign / std::sqrt(values[c]);
  }
  model.example_coordinates = model.components.transpose() * centred;
}

/// Coordinates by parameters, both less their means. The most likely ones follow from the expected
/// ones' formula when the parameters vary by what the components explain and the noise.
Eigen::MatrixXd regression_of(const StatisticalModel& model, const Eigen::MatrixXd& centred,
                              const StatisticalModelOptions& options) {
  const auto count = static_cast<double>(centred.rows());
  const Eigen::MatrixXd joint = model.example_coordinates * centred / count;  // q × M
  Eigen::MatrixXd covariance = centred.transpose() * centred / count;
  double added = options.ridge;
  if (options.estimate == ModelEstimate::most_likely) {
    covariance = joint.transpose() * model.variances.cwiseInverse().asDiagonal() * joint;
    added = options.noise * options.noise;
  }
  covariance.diagonal().array() += added;
  return solve_symmetric(covariance, joint.transpose()).transpose();
}

Eigen::VectorXd moment_at(const StatisticalModel& model, const Eigen::VectorXd& x, double share) {
  const auto at = [&](int sample) {
    const int wrapped = model.loops ? sample % model.samples : std::min(sample, model.samples - 1);
    return x.segment(wrapped * numbers_per_moment, numbers_per_moment);
  };
  const double place = share * (model.loops ? model.samples : model.samples - 1);
  const auto whole = static_cast<int>(std::floor(place));
  const double t = place - whole;
  return (1.0 - t) * at(whole) + t * at(whole + 1);
}

}  // namespace

StatisticalModel fit_statistical_model(const ExampleSet& set, const Eigen::MatrixXd& parameters,
                                       const StatisticalModelOptions& options, WarpShape warp) {
  assert(!set.examples.empty() && options.samples > 1);
  assert(parameters.rows() == static_cast<Eigen::Index>(set.examples.size()));
  StatisticalModel model;
  model.body = set.examples.front().clip.body;
  model.loops = set.examples.front().clip.loops;
  model.samples = options.samples;
  model.keytimes = mean_keytimes(
      set,
      Eigen::VectorXd::Constant(parameters.rows(), 1.0 / static_cast<double>(parameters.rows())));
  model.warp = warp;
  Eigen::MatrixXd vectors;
  for (Eigen::Index i = 0; i < parameters.rows(); ++i) {
    const Eigen::VectorXd vector =
        registered(set.examples[static_cast<size_t>(i)], model.keytimes, model.samples, warp);
    if (i == 0) vectors.resize(vector.size(), parameters.rows());
    vectors.col(i) = vector;
  }
  model.mean = vectors.rowwise().mean();
  vectors.colwise() -= model.mean;
  find_components(model, vectors, options.variance_share);

  model.parameter_mean = parameters.colwise().mean();
  model.regression = regression_of(model, parameters.rowwise() - model.parameter_mean, options);
  return model;
}

Eigen::VectorXd coordinates_at(const StatisticalModel& model,
                               const Eigen::RowVectorXd& parameters) {
  return model.regression * (parameters - model.parameter_mean).transpose();
}

Example motion_of(const StatisticalModel& model, const Eigen::VectorXd& coordinates,
                  double frames_per_second) {
  const Eigen::VectorXd x = model.mean + model.components * coordinates;
  Example result;
  result.clip.body = model.body;
  result.clip.loops = model.loops;
  result.clip.frames_per_second = frames_per_second;
  if (model.loops) result.clip.cycle_displacement = x.tail<3>();
  result.keytimes = {0.0};
  const auto intervals = static_cast<Eigen::Index>(model.keytimes.size()) - 1;
  for (Eigen::Index k = 0; k < intervals; ++k) {
    const double seconds = std::exp(x[model.samples * numbers_per_moment + k]);
    result.keytimes.push_back(result.keytimes.back() + seconds);
  }
  const TimeWarp warp = make_time_warp(result.keytimes, model.keytimes, model.warp, model.loops);
  const double duration = result.keytimes.back();
  const int steps = std::max(1, static_cast<int>(std::lround(duration * frames_per_second)));
  const int frames = model.loops ? steps : steps + 1;
  Pose previous;
  previous.rotations.assign(body_joint_count, Quat::Identity());
  for (int f = 0; f < frames; ++f) {
    const double share = warped(warp, f * duration / steps) / model.keytimes.back();
    const Vec3 travelled = share * result.clip.cycle_displacement;
    result.clip.poses.push_back(read_pose(moment_at(model, x, share), travelled, previous));
    previous = result.clip.poses.back();
  }
  for (double& keytime : result.keytimes) keytime *= steps / frames_per_second / duration;
  return result;
}

Eigen::VectorXd equivalent_weights(const StatisticalModel& model,
                                   const Eigen::RowVectorXd& parameters) {
  // Component c is the sum of the examples' deviations by their coordinates over N·variance_c.
  const auto count = static_cast<double>(model.example_coordinates.cols());
  const Eigen::VectorXd scaled =
      coordinates_at(model, parameters).cwiseQuotient(model.variances * count);
  const Eigen::VectorXd deviations = model.example_coordinates.transpose() * scaled;
  return deviations.array() - deviations.mean() + 1.0 / count;
}

}  // namespace mien::motion

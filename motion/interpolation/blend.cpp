#include "motion/interpolation/blend.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <Eigen/Eigenvalues>

#include "motion/math/rotation.h"

namespace mien::motion {

namespace {

constexpr int most_iterations = 20;
constexpr double converged_radians = 1e-13;

Quat karcher_mean(std::span<const Quat> rotations, std::span<const double> weights) {
  const auto heaviest = std::max_element(weights.begin(), weights.end()) - weights.begin();
  Quat mean = rotations[static_cast<size_t>(heaviest)];
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    Vec3 step = Vec3::Zero();
    for (size_t i = 0; i < rotations.size(); ++i) {
      step += weights[i] * log(mean.conjugate() * rotations[i]);
    }
    mean = (mean * exp(step)).normalized();
    if (step.norm() < converged_radians) break;
  }
  return mean;
}

Quat direction_vector_mean(std::span<const Quat> rotations, std::span<const double> weights) {
  DirectionVectors sum{Vec3::Zero(), Vec3::Zero()};
  for (size_t i = 0; i < rotations.size(); ++i) {
    const DirectionVectors directions = to_direction_vectors(rotations[i]);
    sum.d1 += weights[i] * directions.d1;
    sum.d2 += weights[i] * directions.d2;
  }
  const auto heaviest = std::max_element(weights.begin(), weights.end()) - weights.begin();
  return to_rotation(sum, rotations[static_cast<size_t>(heaviest)]);
}

Quat markley_mean(std::span<const Quat> rotations, std::span<const double> weights) {
  Eigen::Matrix4d sum = Eigen::Matrix4d::Zero();
  for (size_t i = 0; i < rotations.size(); ++i) {
    sum += weights[i] * rotations[i].coeffs() * rotations[i].coeffs().transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> solver(sum);
  const auto heaviest = std::max_element(weights.begin(), weights.end()) - weights.begin();
  return in_hemisphere_of(rotations[static_cast<size_t>(heaviest)],
                          Quat(Eigen::Vector4d(solver.eigenvectors().col(3))).normalized());
}

/// An example that takes part, and how time runs in it.
struct Voice {
  const Example* example;
  double weight;
  TimeWarp warp;
};

std::vector<Voice> voices_of(const ExampleSet& set, const Eigen::VectorXd& weights,
                             const std::vector<double>& keytimes, WarpShape shape) {
  std::vector<Voice> voices;
  for (size_t i = 0; i < set.examples.size(); ++i) {
    const double weight = weights[static_cast<Eigen::Index>(i)];
    if (weight <= 0.0) continue;
    const Example& example = set.examples[i];
    voices.push_back(
        {&example, weight, make_time_warp(keytimes, example.keytimes, shape, example.clip.loops)});
  }
  return voices;
}

/// The weighted mean of each joint in one of the lists of rotations that a pose has.
std::vector<Quat> blended(const std::vector<Pose>& poses, std::vector<Quat> Pose::*joints,
                          const std::vector<double>& weights, RotationBlend how) {
  std::vector<Quat> mean;
  std::vector<Quat> rotations(poses.size());
  for (size_t j = 0; j < (poses.front().*joints).size(); ++j) {
    for (size_t i = 0; i < poses.size(); ++i) rotations[i] = (poses[i].*joints)[j];
    mean.push_back(blend_rotations(rotations, weights, how));
  }
  return mean;
}

Pose blended_pose(const std::vector<Voice>& voices, double seconds, RotationBlend how) {
  std::vector<Pose> poses;
  std::vector<double> weights;
  for (const Voice& voice : voices) {
    poses.push_back(pose_at(voice.example->clip, warped(voice.warp, seconds)));
    weights.push_back(voice.weight);
  }
  Pose pose;
  for (size_t i = 0; i < poses.size(); ++i) {
    pose.root_position += weights[i] * poses[i].root_position;
  }
  pose.rotations = blended(poses, &Pose::rotations, weights, how);
  const bool all_have_fingers =
      std::all_of(poses.begin(), poses.end(), [](const Pose& one) { return !one.fingers.empty(); });
  if (all_have_fingers) pose.fingers = blended(poses, &Pose::fingers, weights, how);
  return pose;
}

/// Puts neighbouring rotations in the same hemisphere, so that interpolation takes the shorter arc.
void make_continuous(std::vector<Pose>& poses) {
  for (size_t f = 1; f < poses.size(); ++f) {
    for (const auto joints : {&Pose::rotations, &Pose::fingers}) {
      std::vector<Quat>& now = poses[f].*joints;
      for (size_t j = 0; j < now.size(); ++j)
        now[j] = in_hemisphere_of((poses[f - 1].*joints)[j], now[j]);
    }
  }
}

}  // namespace

std::vector<double> mean_keytimes(const ExampleSet& set, const Eigen::VectorXd& weights) {
  std::vector<double> mean(set.examples.front().keytimes.size(), 0.0);
  for (size_t i = 0; i < set.examples.size(); ++i) {
    for (size_t k = 0; k < mean.size(); ++k) {
      mean[k] += weights[static_cast<Eigen::Index>(i)] * set.examples[i].keytimes[k];
    }
  }
  return mean;
}

Quat blend_rotations(std::span<const Quat> rotations, std::span<const double> weights,
                     RotationBlend how) {
  assert(!rotations.empty() && rotations.size() == weights.size());
  if (rotations.size() == 1) return rotations[0];
  switch (how) {
    case RotationBlend::karcher_mean:
      return karcher_mean(rotations, weights);
    case RotationBlend::direction_vectors:
      return direction_vector_mean(rotations, weights);
    case RotationBlend::markley_mean:
      break;
  }
  return markley_mean(rotations, weights);
}

Example blend(const ExampleSet& set, const Eigen::VectorXd& weights, const BlendOptions& options) {
  assert(!set.examples.empty());
  assert(weights.size() == static_cast<Eigen::Index>(set.examples.size()));
  const Clip& first = set.examples.front().clip;

  Example result;
  result.clip.body = first.body;
  result.clip.loops = first.loops;
  result.clip.frames_per_second = options.frames_per_second;
  result.keytimes = mean_keytimes(set, weights);
  for (size_t i = 0; i < set.examples.size(); ++i) {
    result.clip.cycle_displacement +=
        weights[static_cast<Eigen::Index>(i)] * set.examples[i].clip.cycle_displacement;
  }

  const std::vector<Voice> voices = voices_of(set, weights, result.keytimes, options.warp);
  const double duration = result.keytimes.back();
  const int steps =
      std::max(1, static_cast<int>(std::lround(duration * options.frames_per_second)));
  const int frames = first.loops ? steps : steps + 1;
  for (int f = 0; f < frames; ++f) {
    result.clip.poses.push_back(blended_pose(voices, f * duration / steps, options.rotations));
  }
  make_continuous(result.clip.poses);

  const double stretch = steps / options.frames_per_second / duration;
  for (double& keytime : result.keytimes) keytime *= stretch;
  return result;
}

}  // namespace mien::motion

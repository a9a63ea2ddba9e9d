#include "motion/style_transfer/style_components.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "motion/error.h"
#include "motion/math/dynamic_time_warp.h"
#include "motion/math/fast_ica.h"
#include "motion/math/singular_values.h"

namespace mien::motion {

namespace {

using Matrix = Eigen::MatrixXd;

/// Principal components weaker than this, against the strongest, are noise.
constexpr double least_direction = 1e-9;

/// The styled motion's curves at the moments that correspond to the neutral one's frames.
Matrix aligned(const MotionCurves& neutral, const MotionCurves& styled) {
  const std::vector<double> times = smoothed_times(
      dynamic_time_warp(with_closing_frame(neutral), with_closing_frame(styled)), neutral, styled);
  Matrix result(neutral.frame_count(), curve_count);
  for (int i = 0; i < neutral.frame_count(); ++i) {
    result.row(i) = curves_at(styled, times[i] / frame_span(styled));
  }
  return result;
}

/// The strongest directions of the centred curves: white · spread ≈ centred.
struct Whitened {
  Matrix white;
  Matrix spread;
};

Whitened whitened(const Matrix& centred, int components) {
  const SingularValues svd = singular_values(centred);
  const Eigen::Index kept = std::min<Eigen::Index>(components, svd.rank(least_direction));
  const double root = std::sqrt(static_cast<double>(centred.rows()));
  return {svd.u.leftCols(kept) * root,
          (svd.values.head(kept) / root).asDiagonal() * svd.v.leftCols(kept).transpose()};
}

/// Strongest first, largest number of each mixing row positive.
void sort_by_energy(Matrix& series, Matrix& mixing) {
  const Eigen::VectorXd energy = mixing.rowwise().squaredNorm();
  std::vector<Eigen::Index> order(static_cast<size_t>(mixing.rows()));
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](Eigen::Index a, Eigen::Index b) { return energy[a] > energy[b]; });
  const Matrix unsorted_series = series;
  const Matrix unsorted_mixing = mixing;
  for (Eigen::Index k = 0; k < mixing.rows(); ++k) {
    Eigen::Index largest = 0;
    unsorted_mixing.row(order[k]).cwiseAbs().maxCoeff(&largest);
    const double sign = unsorted_mixing(order[k], largest) < 0.0 ? -1.0 : 1.0;
    series.col(k) = sign * unsorted_series.col(order[k]);
    mixing.row(k) = sign * unsorted_mixing.row(order[k]);
  }
}

Matrix joint_shares(const Matrix& mixing) {
  Matrix shares = Matrix::Zero(mixing.rows(), body_joint_count);
  for (Eigen::Index k = 0; k < mixing.rows(); ++k) {
    const double all = mixing.row(k).squaredNorm();
    shares(k, Pelvis) = mixing.row(k).head<3>().squaredNorm() / all;
    for (int joint = 0; joint < body_joint_count; ++joint) {
      shares(k, joint) += mixing.row(k).segment<3>(first_curve(joint)).squaredNorm() / all;
    }
  }
  return shares;
}

void require_pair(const Clip& neutral, const Clip& styled, const StyleComponentOptions& options) {
  if (neutral.loops != styled.loops) {
    throw Error("of \"" + neutral.name + "\" and \"" + styled.name + "\" only one is cyclic",
                "take style components from two motions of one kind");
  }
  if (options.components < 1) {
    throw Error("a motion has at least one component", "give components of 1 or more");
  }
}

}  // namespace

StyleComponents style_components(const Clip& neutral, const Clip& styled,
                                 const StyleComponentOptions& options) {
  require_pair(neutral, styled, options);
  StyleComponents result;
  const std::vector<Quat> means = mean_rotations(neutral);
  result.neutral = to_curves(neutral, means);
  const int frames = result.neutral.frame_count();
  Matrix both(2 * frames, curve_count);
  both << result.neutral.values, aligned(result.neutral, to_curves(styled, means));
  result.mean = both.colwise().mean();
  const Matrix centred = both.rowwise() - result.mean;
  const Whitened white = whitened(centred, options.components);
  const FastIca ica = fast_ica(white.white, options.seed);
  Matrix series = white.white * ica.rotation;
  result.mixing = ica.rotation.transpose() * white.spread;
  sort_by_energy(series, result.mixing);
  result.iterations = ica.iterations;
  result.converged = ica.converged;
  result.neutral_series = series.topRows(frames);
  result.styled_series = series.bottomRows(frames);
  result.neutral_residual = centred.topRows(frames) - result.neutral_series * result.mixing;
  result.energy = result.mixing.rowwise().squaredNorm();
  const Eigen::RowVectorXd squares =
      (result.styled_series - result.neutral_series).cwiseAbs2().colwise().mean();
  result.difference = result.energy.cwiseProduct(squares.transpose());
  result.joint_shares = joint_shares(result.mixing);
  return result;
}

std::vector<int> swapped_components(const StyleComponents& components,
                                    const StyleComponentOptions& options) {
  const auto count = static_cast<int>(components.energy.size());
  for (const int chosen : options.swapped) {
    if (chosen < 0 || chosen >= count) {
      throw Error("there is no style component " + std::to_string(chosen),
                  "the motions have " + std::to_string(count) + ", counted from 0");
    }
  }
  if (!options.swapped.empty()) return options.swapped;
  std::vector<int> order(static_cast<size_t>(count));
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
    return components.difference[a] > components.difference[b];
  });
  order.resize(static_cast<size_t>(std::clamp(options.most_different, 0, count)));
  std::sort(order.begin(), order.end());
  return order;
}

Clip restyled(const Clip& motion, const StyleComponents& components,
              const StyleComponentOptions& options) {
  MotionCurves change = components.neutral;
  change.values.setZero();
  for (const int k : swapped_components(components, options)) {
    change.values += (components.styled_series.col(k) - components.neutral_series.col(k)) *
                     components.mixing.row(k);
  }
  MotionCurves curves = to_curves(motion, components.neutral.means);
  curves.values += options.amount * resampled(change, curves.frame_count()).values;
  return to_clip(curves);
}

}  // namespace mien::motion

#include "pipeline/study/chains/experiment/sample_density.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>

#include "pipeline/study/chains/experiment/sample_quantile.h"

namespace mien::pipeline {

namespace {

double deviation_of(const Eigen::Ref<const Eigen::ArrayXd>& values) {
  const auto n = static_cast<double>(values.size());
  return n < 2.0 ? 0.0 : std::sqrt((values - values.mean()).square().sum() / (n - 1.0));
}

double silverman_width(const std::vector<double>& samples, double effective) {
  const double deviation =
      deviation_of(Eigen::Map<const Eigen::ArrayXd>(samples.data(), std::ssize(samples)));
  std::vector<double> sorted = samples;
  std::ranges::sort(sorted);
  const double quartiles = (quantile_of(sorted, 0.75) - quantile_of(sorted, 0.25)) / 1.34;
  const double spread = quartiles > 0.0 ? std::min(deviation, quartiles) : deviation;
  const double count = effective >= 1.0 ? effective : static_cast<double>(samples.size());
  return 0.9 * spread * std::pow(count, -0.2);
}

/// Weights of a normal kernel at 0, 1, 2 … steps from its middle, up to four deviations.
std::vector<double> kernel_of(double deviation, double step) {
  std::vector<double> kernel;
  const auto reach = static_cast<int>(std::ceil(4.0 * deviation / step));
  for (int i = 0; i <= reach; ++i)
    kernel.push_back(std::exp(-0.5 * std::pow(static_cast<double>(i) * step / deviation, 2)));
  return kernel;
}

/// The index that a walk beyond either end of 0 … last comes to when it turns there.
Eigen::Index turned(Eigen::Index i, Eigen::Index last) {
  const Eigen::Index round = 2 * last;
  i = ((i % round) + round) % round;
  return i <= last ? i : round - i;
}

}  // namespace

SampleDensity sample_density(const std::vector<double>& samples, double effective,
                             const DimensionRange& range, int places) {
  const double width = range.high - range.low;
  const double step = width / static_cast<double>(places - 1);
  const Eigen::Index last = places - 1;
  Eigen::ArrayXd counts = Eigen::ArrayXd::Zero(places);
  for (const double sample : samples) {
    const double at = std::clamp((sample - range.low) / step, 0.0, static_cast<double>(last));
    const auto below = std::min(static_cast<Eigen::Index>(at), last - 1);
    counts[below + 1] += at - static_cast<double>(below);
    counts[below] += 1.0 - (at - static_cast<double>(below));
  }
  const std::vector<double> kernel =
      kernel_of(std::max(silverman_width(samples, effective), 0.01 * width), step);
  Eigen::ArrayXd density = Eigen::ArrayXd::Zero(places);
  for (Eigen::Index from = 0; from <= last; ++from) {
    if (counts[from] == 0.0) continue;
    for (Eigen::Index i = 0; i < std::ssize(kernel); ++i) {
      const double weight = counts[from] * kernel[static_cast<std::size_t>(i)];
      density[turned(from + i, last)] += weight;
      if (i > 0) density[turned(from - i, last)] += weight;
    }
  }
  // The places at the ends stand for half a step, onto which both halves of kernels fall.
  density[0] *= 2.0;
  density[last] *= 2.0;
  const double integral = step * (density.sum() - 0.5 * (density[0] + density[last]));
  SampleDensity result;
  for (Eigen::Index i = 0; i <= last; ++i) {
    result.places.push_back(i == last ? range.high : range.low + step * static_cast<double>(i));
    result.density.push_back(density[i] / integral);
  }
  return result;
}

Eigen::Vector2d SamplePlane::at(const Eigen::VectorXd& sample) const {
  return axes.transpose() * (sample - centre);
}

SamplePlane sample_plane(const Eigen::MatrixXd& samples) {
  SamplePlane plane{.centre = samples.rowwise().mean()};
  const Eigen::MatrixXd apart = samples.colwise() - plane.centre;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(apart * apart.transpose());
  const Eigen::Index dimensions = samples.rows();
  const double all = solver.eigenvalues().sum();
  plane.axes.resize(dimensions, 2);
  for (Eigen::Index i = 0; i < 2; ++i) {
    Eigen::VectorXd axis = solver.eigenvectors().col(dimensions - 1 - i);
    Eigen::Index largest = 0;
    axis.cwiseAbs().maxCoeff(&largest);
    plane.axes.col(i) = axis[largest] < 0.0 ? -axis : axis;
    plane.shares[static_cast<std::size_t>(i)] =
        all > 0.0 ? std::max(0.0, solver.eigenvalues()[dimensions - 1 - i]) / all : 0.0;
  }
  return plane;
}

DensityMap density_map(const Eigen::Matrix2Xd& points, double low_x, double low_y, double width,
                       int cells) {
  DensityMap map{.low_x = low_x, .low_y = low_y, .width = width};
  const double cell = width / static_cast<double>(cells);
  Eigen::MatrixXd counts = Eigen::MatrixXd::Zero(cells, cells);
  const auto place = [&](double at, double low) {
    return std::clamp(static_cast<Eigen::Index>(std::floor((at - low) / cell)), Eigen::Index{0},
                      static_cast<Eigen::Index>(cells) - 1);
  };
  for (const auto& point : points.colwise())
    counts(place(point.y(), low_y), place(point.x(), low_x)) += 1.0;
  const double shrink = std::pow(static_cast<double>(points.cols()), -1.0 / 6.0);
  const auto smoothed = [&](const Eigen::MatrixXd& from, Eigen::Index along) {
    const double deviation =
        std::max(deviation_of(points.row(along).transpose().array()), 0.02 * width) * shrink;
    const std::vector<double> kernel = kernel_of(std::max(deviation, 0.5 * cell), cell);
    Eigen::MatrixXd to = Eigen::MatrixXd::Zero(cells, cells);
    for (Eigen::Index i = 0; i < cells; ++i)
      for (Eigen::Index j = 0; j < cells; ++j) {
        const auto steps = static_cast<std::size_t>(std::abs(i - j));
        if (steps >= kernel.size()) continue;
        if (along == 0)
          to.col(j) += kernel[steps] * from.col(i);
        else
          to.row(j) += kernel[steps] * from.row(i);
      }
    return to;
  };
  map.density = smoothed(smoothed(counts, 0), 1);
  map.density /= map.density.sum() * cell * cell;
  return map;
}

}  // namespace mien::pipeline

#include "motion/interpolation/nearest_neighbours.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <vector>

#include "motion/math/random_number.h"

namespace mien::motion {

namespace {

constexpr double at_the_place = 1e-9;

/// The n-th number of a seed, in (0, 1).
double drawn_number(std::uint64_t seed, std::uint64_t n) {
  return open_unit_number(random_bits(seed * 0xD1342543DE82EF95u, n));
}

/// Examples from the middle outwards: an order that does not depend on how they are listed.
std::vector<Eigen::Index> outwards(const Eigen::MatrixXd& places) {
  const Eigen::RowVectorXd middle = places.colwise().mean();
  std::vector<Eigen::Index> order(static_cast<size_t>(places.rows()));
  std::iota(order.begin(), order.end(), 0);
  const auto distance = [&](Eigen::Index i) {
    // Rounded, so that the last bit of a sum in another order decides nothing.
    return std::round((places.row(i) - middle).norm() * 1e9);
  };
  const auto before = [&](Eigen::Index a, Eigen::Index b) {
    if (distance(a) != distance(b)) return distance(a) < distance(b);
    for (Eigen::Index m = 0; m < places.cols(); ++m) {
      if (places(a, m) != places(b, m)) return places(a, m) < places(b, m);
    }
    return false;
  };
  std::sort(order.begin(), order.end(), before);
  return order;
}

/// Random weights of a few random examples; evenly spread over the simplex between them.
Eigen::VectorXd random_blend(const std::vector<Eigen::Index>& order, size_t members,
                             std::uint64_t seed, std::uint64_t trial) {
  std::uint64_t draw = trial * 4096;
  std::vector<Eigen::Index> left = order;
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(order.size()));
  for (size_t member = 0; member < members; ++member) {
    const double where = drawn_number(seed, draw++) * static_cast<double>(left.size());
    const auto chosen = left.begin() + static_cast<long>(where);
    weights[*chosen] = -std::log(drawn_number(seed, draw++));
    left.erase(chosen);
  }
  return weights / weights.sum();
}

double nearest_distance(const NearestNeighbours& samples, Eigen::Index count,
                        const Eigen::RowVectorXd& parameters) {
  return (samples.parameters.topRows(count).rowwise() - parameters).rowwise().norm().minCoeff();
}

void densify(NearestNeighbours& samples, const Eigen::MatrixXd& places,
             const NearestNeighboursOptions& options, const MeasureBlend& measure) {
  const std::vector<Eigen::Index> order = outwards(places);
  const auto members = static_cast<size_t>(std::min(places.rows(), places.cols() + 1));
  Eigen::Index count = places.rows();
  samples.parameters.conservativeResize(count + options.trials, Eigen::NoChange);
  samples.weights.conservativeResize(count + options.trials, Eigen::NoChange);
  for (int trial = 0; trial < options.trials; ++trial) {
    const Eigen::VectorXd weights =
        random_blend(order, members, options.seed, static_cast<std::uint64_t>(trial));
    const Eigen::RowVectorXd found =
        measure ? measure(weights) : Eigen::RowVectorXd(weights.transpose() * places);
    if (nearest_distance(samples, count, found) <= options.least_distance) continue;
    samples.parameters.row(count) = found;
    samples.weights.row(count) = weights.transpose();
    ++count;
  }
  samples.parameters.conservativeResize(count, Eigen::NoChange);
  samples.weights.conservativeResize(count, Eigen::NoChange);
}

}  // namespace

NearestNeighbours fit_nearest_neighbours(const Eigen::MatrixXd& places,
                                         const NearestNeighboursOptions& options,
                                         const MeasureBlend& measure) {
  assert(places.rows() > 0);
  NearestNeighbours samples;
  samples.parameters = places;
  samples.weights = Eigen::MatrixXd::Identity(places.rows(), places.rows());
  if (places.rows() > 1 && options.trials > 0) densify(samples, places, options, measure);
  const auto count = static_cast<int>(samples.parameters.rows());
  const int wanted =
      options.neighbours > 0 ? options.neighbours : static_cast<int>(places.cols()) + 2;
  samples.neighbours = std::clamp(wanted, std::min(3, count), count);
  return samples;
}

Eigen::VectorXd weights(const NearestNeighbours& samples, const Eigen::RowVectorXd& parameters) {
  assert(parameters.size() == samples.parameters.cols());
  const Eigen::VectorXd distances = (samples.parameters.rowwise() - parameters).rowwise().norm();
  std::vector<Eigen::Index> order(static_cast<size_t>(distances.size()));
  std::iota(order.begin(), order.end(), 0);
  const auto k = static_cast<size_t>(samples.neighbours);
  std::partial_sort(order.begin(), order.begin() + static_cast<long>(k), order.end(),
                    [&](Eigen::Index a, Eigen::Index b) {
                      return distances[a] != distances[b] ? distances[a] < distances[b] : a < b;
                    });
  if (distances[order[0]] < at_the_place) return samples.weights.row(order[0]).transpose();

  const double cut = k > 2 ? 1.0 / distances[order[k - 1]] : 0.0;
  Eigen::VectorXd result = Eigen::VectorXd::Zero(samples.weights.cols());
  double sum = 0.0;
  for (size_t i = 0; i < k; ++i) {
    const double share = 1.0 / distances[order[i]] - cut;
    result += share * samples.weights.row(order[i]).transpose();
    sum += share;
  }
  if (sum > 1e-12 * cut) return result / sum;
  // All neighbours are equally far: none has a claim before another.
  for (size_t i = 0; i < k; ++i) result += samples.weights.row(order[i]).transpose();
  return result / result.sum();
}

Eigen::VectorXd inverse_distance_weights(const Eigen::MatrixXd& places,
                                         const Eigen::RowVectorXd& parameters, double power) {
  assert(places.rows() > 0 && parameters.size() == places.cols());
  const Eigen::VectorXd distances = (places.rowwise() - parameters).rowwise().norm();
  Eigen::Index nearest = 0;
  const double least = distances.minCoeff(&nearest);
  if (least < at_the_place) return Eigen::VectorXd::Unit(places.rows(), nearest);
  // Relative to the nearest, so that no power overflows.
  const Eigen::VectorXd shares = (distances / least).array().pow(-power);
  return shares / shares.sum();
}

}  // namespace mien::motion

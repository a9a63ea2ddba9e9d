#pragma once

#include <random>

#include <Eigen/Core>

namespace mien::test {

/// Places evenly spread over the unit cube of parameters, one a row.
inline Eigen::MatrixXd random_places(std::mt19937_64& random, Eigen::Index count,
                                     Eigen::Index parameters) {
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  return Eigen::MatrixXd::NullaryExpr(count, parameters, [&] { return uniform(random); });
}

}  // namespace mien::test

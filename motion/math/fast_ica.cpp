#include "motion/math/fast_ica.h"

#include <cmath>

#include "motion/math/random_number.h"
#include "motion/math/singular_values.h"

namespace mien::motion {

namespace {

constexpr double converged_change = 1e-10;
constexpr int steps_of_one_length = 100;

/// The nearest orthonormal matrix: (M Mᵀ)^−½ M.
Eigen::MatrixXd decorrelated(const Eigen::MatrixXd& matrix) {
  const SingularValues svd = singular_values(matrix);
  return svd.u * svd.v.transpose();
}

}  // namespace

FastIca fast_ica(const Eigen::MatrixXd& white, std::uint64_t seed, int most_iterations) {
  const Eigen::Index count = white.cols();
  const auto samples = static_cast<double>(white.rows());
  Eigen::MatrixXd guess(count, count);
  for (Eigen::Index i = 0; i < guess.size(); ++i) {
    guess.data()[i] = centred_number(random_bits(seed, static_cast<std::uint64_t>(i)));
  }
  FastIca found;
  found.rotation = decorrelated(guess);
  while (found.iterations < most_iterations && !found.converged) {
    ++found.iterations;
    const Eigen::ArrayXXd bent = (white * found.rotation).array().tanh();
    const Eigen::RowVectorXd slope = (1.0 - bent.square()).colwise().mean();
    const Eigen::MatrixXd step = decorrelated(white.transpose() * bent.matrix() / samples -
                                              found.rotation * slope.asDiagonal());
    // A source may turn round from step to step, which means nothing.
    const Eigen::VectorXd turned = (step.transpose() * found.rotation).diagonal();
    found.converged = (1.0 - turned.array().abs()).abs().maxCoeff() < converged_change;
    const Eigen::VectorXd signs = turned.unaryExpr([](double t) { return t < 0.0 ? -1.0 : 1.0; });
    // Steps that go to and fro are shortened.
    const double share = std::pow(0.5, found.iterations / steps_of_one_length);
    found.rotation =
        decorrelated((1.0 - share) * found.rotation + share * step * signs.asDiagonal());
  }
  return found;
}

}  // namespace mien::motion

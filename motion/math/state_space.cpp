#include "motion/math/state_space.h"

#include <algorithm>

#include <Eigen/Eigenvalues>

#include "motion/math/linear_system.h"
#include "motion/math/singular_values.h"

namespace mien::motion {

namespace {

using Matrix = Eigen::MatrixXd;

/// Directions of a regression weaker than this, against the strongest, are noise.
constexpr double least_direction = 1e-7;
/// Ridge of the final regression, as a share of the regressors' mean square.

/// B in Y ≈ B·X, of the smallest norm.
Matrix regression(const Matrix& y, const Matrix& x) {
  return singular_values(x.transpose()).solve(y.transpose(), least_direction).transpose();
}

/// Block Hankel matrix: block row k holds moments first + k, first + k + 1, … as columns.
Matrix hankel(const Matrix& signal, Eigen::Index first, Eigen::Index blocks, Eigen::Index columns) {
  const Eigen::Index width = signal.cols();
  Matrix result(blocks * width, columns);
  for (Eigen::Index k = 0; k < blocks; ++k) {
    for (Eigen::Index t = 0; t < columns; ++t) {
      result.block(k * width, t, width, 1) =
          signal.row((first + k + t) % signal.rows()).transpose();
    }
  }
  return result;
}

/// The strongest principal components of the outputs, columns orthonormal in time.
Matrix strongest(const Matrix& outputs, Eigen::Index count) {
  const SingularValues svd = singular_values(outputs);
  const Eigen::Index kept = std::min(count, svd.values.size());
  return svd.u.leftCols(kept) * svd.values.head(kept).asDiagonal();
}

/// Row t: the state before input `blocks` + t; of open data there are fewer of them than of inputs.
Matrix states_by_projection(const Matrix& inputs, const Matrix& outputs, Eigen::Index blocks,
                            Eigen::Index order, bool periodic) {
  const Eigen::Index moments = inputs.rows();
  const Eigen::Index columns = periodic ? moments : moments - 2 * blocks + 1;
  const Matrix past_inputs = hankel(inputs, 0, blocks, columns);
  const Matrix past_outputs = hankel(outputs, 0, blocks, columns);
  const Matrix future_inputs = hankel(inputs, blocks, blocks, columns);
  const Matrix future_outputs = hankel(outputs, blocks, blocks, columns);
  Matrix known(past_inputs.rows() + past_outputs.rows() + future_inputs.rows(), columns);
  known << past_inputs, past_outputs, future_inputs;
  const Matrix by_known = regression(future_outputs, known);
  const Eigen::Index past = past_inputs.rows() + past_outputs.rows();
  const Matrix oblique = by_known.leftCols(past) * known.topRows(past);
  const SingularValues svd = singular_values(oblique);
  const Eigen::Index kept = std::min(order, svd.rank(least_direction));
  return svd.v.leftCols(kept) * std::sqrt(static_cast<double>(columns));
}

double largest_pole_of(const Matrix& a) {
  return a.size() == 0 ? 0.0 : a.eigenvalues().cwiseAbs().maxCoeff();
}

/// A and B from a sequence of states that begins before input `first`.
StateSpace transitions(const Matrix& states, const Matrix& inputs, Eigen::Index first,
                       bool periodic, double largest_pole) {
  const Eigen::Index count = periodic ? states.rows() : states.rows() - 1;
  const Eigen::Index order = states.cols();
  Matrix known(order + inputs.cols(), count);
  Matrix next(order, count);
  for (Eigen::Index t = 0; t < count; ++t) {
    known.col(t) << states.row(t).transpose(), inputs.row((first + t) % inputs.rows()).transpose();
    next.col(t) = states.row((t + 1) % states.rows()).transpose();
  }
  StateSpace system;
  system.a = regression(next, known).leftCols(order);
  const double pole = largest_pole_of(system.a);
  if (pole > largest_pole) system.a *= largest_pole / pole;
  system.b = regression(next - system.a * known.topRows(order), known.bottomRows(inputs.cols()));
  return system;
}

Matrix simulated_states(const StateSpace& system, const Matrix& inputs, InitialState initial) {
  const Eigen::Index order = system.order();
  const Matrix identity = Matrix::Identity(order, order);
  Eigen::VectorXd state = Eigen::VectorXd::Zero(order);
  Matrix still = identity - system.a;
  Eigen::VectorXd right = system.b * inputs.row(0).transpose();
  if (initial == InitialState::periodic) {
    Matrix power = identity;
    for (Eigen::Index t = 0; t < inputs.rows(); ++t) {
      state = system.a * state + system.b * inputs.row(t).transpose();
      power = system.a * power;
    }
    still = identity - power;
    right = state;
  }
  if (order > 0) state = LinearSystem(still).solve(right);
  Matrix states(inputs.rows(), order);
  for (Eigen::Index t = 0; t < inputs.rows(); ++t) {
    states.row(t) = state.transpose();
    state = system.a * state + system.b * inputs.row(t).transpose();
  }
  return states;
}

/// C and D that reproduce the outputs best in a simulation, and how far they fail.
double fit_outputs(StateSpace& system, const Matrix& inputs, const Matrix& outputs,
                   InitialState initial, double ridge) {
  const Eigen::Index order = system.order();
  Matrix known(inputs.rows(), order + inputs.cols());
  known << simulated_states(system, inputs, initial), inputs;
  Matrix normal = known.transpose() * known;
  normal.diagonal().array() += ridge * normal.trace() / static_cast<double>(normal.rows());
  const Matrix both = solve_symmetric(normal, known.transpose() * outputs).transpose();
  system.c = both.leftCols(order);
  system.d = both.rightCols(inputs.cols());
  return (known * both.transpose() - outputs).squaredNorm();
}

}  // namespace

Eigen::MatrixXd simulated(const StateSpace& system, const Eigen::MatrixXd& inputs,
                          InitialState initial) {
  return simulated_states(system, inputs, initial) * system.c.transpose() +
         inputs * system.d.transpose();
}

StateSpace identified(const Eigen::MatrixXd& inputs, const Eigen::MatrixXd& outputs, int order,
                      InitialState initial, double largest_pole, double ridge) {
  const bool periodic = initial == InitialState::periodic;
  const Eigen::Index moments = inputs.rows();
  StateSpace best;
  best.a.resize(0, 0);
  best.b.resize(0, inputs.cols());
  best.c.resize(outputs.cols(), 0);
  best.d = Matrix::Zero(outputs.cols(), inputs.cols());
  if (outputs.squaredNorm() == 0.0) return best;
  double least = fit_outputs(best, inputs, outputs, initial, ridge);
  // How far past and future reach must suit the richness of the data, which is not known: short
  // cycles allow little. What simulates best is taken.
  const Eigen::Index longest = std::max<Eigen::Index>(2, order + 1);
  for (Eigen::Index blocks = 2; blocks <= longest; ++blocks) {
    const Eigen::Index columns = periodic ? moments : moments - 2 * blocks + 1;
    // No more equations than moments: a short cycle has fewer outputs, or a shorter reach.
    const Eigen::Index room = columns / blocks - 2 * inputs.cols();
    if (room < 1) break;
    const Eigen::Index needed = std::max<Eigen::Index>(1, (order + blocks - 2) / (blocks - 1));
    const Matrix main = strongest(outputs, std::min(needed, room));
    const Matrix states = states_by_projection(inputs, main, blocks, order, periodic);
    StateSpace system = transitions(states, inputs, blocks, periodic, largest_pole);
    const double error = fit_outputs(system, inputs, outputs, initial, ridge);
    if (error >= least) continue;
    least = error;
    best = system;
  }
  return best;
}

}  // namespace mien::motion

#include "motion/math/state_space.h"

#include <random>

#include <Eigen/LU>
#include <gtest/gtest.h>

namespace mien::motion {
namespace {

/// A stable system of three states, two inputs and two outputs.
StateSpace known_system() {
  StateSpace system;
  system.a.resize(3, 3);
  system.a << 0.8, 0.3, 0.0, -0.3, 0.8, 0.0, 0.0, 0.1, 0.5;
  system.b.resize(3, 2);
  system.b << 1.0, 0.0, 0.2, 0.5, -0.4, 1.0;
  system.c.resize(2, 3);
  system.c << 1.0, 0.0, 0.5, 0.3, -1.0, 0.2;
  system.d.resize(2, 2);
  system.d << 0.1, 0.0, 0.0, -0.2;
  return system;
}

Eigen::MatrixXd noise(int rows, int columns, unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  Eigen::MatrixXd result(rows, columns);
  for (int i = 0; i < rows; ++i) {
    for (int c = 0; c < columns; ++c) result(i, c) = normal(random);
  }
  return result;
}

TEST(StateSpace, IsPeriodicInItsPeriodicState) {
  const Eigen::MatrixXd cycle = noise(20, 2, 1);
  Eigen::MatrixXd long_run(200, 2);
  for (int k = 0; k < 10; ++k) long_run.middleRows(20 * k, 20) = cycle;
  const Eigen::MatrixXd once = simulated(known_system(), cycle, InitialState::periodic);
  const Eigen::MatrixXd settled = simulated(known_system(), long_run, InitialState::settled);
  EXPECT_LT((once - settled.bottomRows(20)).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(StateSpace, StaysSettledUnderAConstantInput) {
  const Eigen::MatrixXd constant = Eigen::RowVector2d(0.7, -1.0).replicate(30, 1);
  const Eigen::MatrixXd outputs = simulated(known_system(), constant, InitialState::settled);
  EXPECT_LT((outputs.row(29) - outputs.row(0)).norm(), 1e-12);
}

TEST(Identified, SystemIsTheOneThatMadeTheData) {
  for (const InitialState initial : {InitialState::periodic, InitialState::settled}) {
    const Eigen::MatrixXd inputs = noise(300, 2, 2);
    const Eigen::MatrixXd outputs = simulated(known_system(), inputs, initial);
    const StateSpace found = identified(inputs, outputs, 3, initial);
    EXPECT_EQ(found.order(), 3);
    EXPECT_LT((simulated(found, inputs, initial) - outputs).cwiseAbs().maxCoeff(), 1e-3);
    const Eigen::MatrixXd others = noise(100, 2, 3);
    EXPECT_LT((simulated(found, others, initial) - simulated(known_system(), others, initial))
                  .cwiseAbs()
                  .maxCoeff(),
              1e-3);
    // Poles do not depend on the choice of states.
    EXPECT_NEAR(found.a.trace(), known_system().a.trace(), 1e-4);
    EXPECT_NEAR(found.a.determinant(), known_system().a.determinant(), 1e-4);
  }
}

TEST(Identified, SystemOfFewerStatesFitsLess) {
  const Eigen::MatrixXd inputs = noise(300, 2, 2);
  const Eigen::MatrixXd outputs = simulated(known_system(), inputs, InitialState::periodic);
  const StateSpace found = identified(inputs, outputs, 1, InitialState::periodic);
  EXPECT_LE(found.order(), 1);
  EXPECT_GT((simulated(found, inputs, InitialState::periodic) - outputs).cwiseAbs().maxCoeff(),
            0.1);
}

TEST(Identified, SystemOfNoOutputIsNothing) {
  const Eigen::MatrixXd inputs = noise(50, 2, 2);
  const StateSpace found =
      identified(inputs, Eigen::MatrixXd::Zero(50, 3), 5, InitialState::periodic);
  EXPECT_EQ(simulated(found, inputs, InitialState::periodic), Eigen::MatrixXd::Zero(50, 3));
}

}  // namespace
}  // namespace mien::motion

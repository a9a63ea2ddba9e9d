#pragma once

#include <Eigen/Core>

namespace mien::motion {

/// A linear time-invariant system: x(t+1) = A x(t) + B u(t), y(t) = C x(t) + D u(t).
struct StateSpace {
  Eigen::MatrixXd a;
  Eigen::MatrixXd b;
  Eigen::MatrixXd c;
  Eigen::MatrixXd d;

  int order() const { return static_cast<int>(a.rows()); }
};

/// The state before the first input.
enum class InitialState {
  settled,   ///< the steady state under the first input
  periodic,  ///< equal to the state after the last input: the inputs are one cycle
};

/// The system's outputs (T × q) for the inputs (T × p); rows are time steps.
Eigen::MatrixXd simulated(const StateSpace& system, const Eigen::MatrixXd& inputs,
                          InitialState initial);

/// Identifies a system of at most `order` states from inputs and outputs of mean zero by the
/// subspace method N4SID (Van Overschee and De Moor 1994): states from the oblique projection of
/// future outputs, A and B by least squares on these states, poles reduced to a magnitude of at
/// most `largest_pole`, then C and D by least squares on the simulated states. With
/// InitialState::periodic the data are one cycle. `ridge` is the weight of the squared C and D,
/// relative to the mean squared state or input: more of it fits the data less closely and
/// extrapolates less wildly to inputs unlike them.
StateSpace identified(const Eigen::MatrixXd& inputs, const Eigen::MatrixXd& outputs, int order,
                      InitialState initial, double largest_pole = 0.97, double ridge = 1e-8);

}  // namespace mien::motion

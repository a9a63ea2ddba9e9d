#include "motion/math/nonnegative_least_squares.h"

#include <algorithm>
#include <cassert>
#include <vector>

#include "motion/math/linear_system.h"

namespace mien::motion {

namespace {

/// Slopes and unknowns below this share of the problem's size are taken for 0.
constexpr double slope_rounding = 1e-12;

/// Which unknowns are not bound to 0.
using FreeSet = std::vector<Eigen::Index>;

/// Least squares over the free unknowns alone, of any sign; 0 elsewhere.
Eigen::VectorXd unbounded(const Eigen::MatrixXd& a, const Eigen::VectorXd& b, const FreeSet& free) {
  Eigen::VectorXd x = Eigen::VectorXd::Zero(a.cols());
  x(free) = least_squares(a(Eigen::all, free), b);
  return x;
}

/// How far one may go from x, where all free unknowns are ≥ 0, to `target` until one reaches 0.
double share_of_way(const Eigen::VectorXd& x, const Eigen::VectorXd& target, const FreeSet& free) {
  double share = 1.0;
  for (const Eigen::Index i : free) {
    if (target[i] <= 0.0) share = std::min(share, x[i] / (x[i] - target[i]));
  }
  return share;
}

/// The unknown bound to 0 whose growth lowers the squares fastest, or −1 when none does.
Eigen::Index steepest(const Eigen::VectorXd& descent, const FreeSet& free, double tolerance) {
  Eigen::Index best = -1;
  for (Eigen::Index i = 0; i < descent.size(); ++i) {
    if (std::find(free.begin(), free.end(), i) != free.end()) continue;
    if (descent[i] > tolerance && (best < 0 || descent[i] > descent[best])) best = i;
  }
  return best;
}

/// Least squares over the free unknowns, of which some become bound until none is below 0.
Eigen::VectorXd settled(const Eigen::MatrixXd& a, const Eigen::VectorXd& b, Eigen::VectorXd x,
                        FreeSet& free) {
  for (;;) {
    const Eigen::VectorXd target = unbounded(a, b, free);
    const double share = share_of_way(x, target, free);
    if (share >= 1.0) return target;
    x += share * (target - x);
    std::erase_if(free, [&](Eigen::Index i) {
      const bool has_arrived = target[i] <= 0.0 && x[i] <= slope_rounding;
      if (has_arrived) x[i] = 0.0;
      return has_arrived;
    });
  }
}

}  // namespace

Eigen::VectorXd nonnegative_least_squares(const Eigen::MatrixXd& a, const Eigen::VectorXd& b) {
  assert(a.rows() == b.size() && a.cols() > 0);
  const double tolerance = slope_rounding * a.colwise().norm().maxCoeff() * b.norm();
  FreeSet free;
  Eigen::VectorXd x = Eigen::VectorXd::Zero(a.cols());
  // No set of free unknowns comes twice, for the squares fall; the bound is there for rounding.
  for (Eigen::Index steps = 10 * a.cols(); steps > 0; --steps) {
    const Eigen::Index entering = steepest(a.transpose() * (b - a * x), free, tolerance);
    if (entering < 0) break;
    free.push_back(entering);
    x = settled(a, b, x, free);
  }
  return x;
}

}  // namespace mien::motion

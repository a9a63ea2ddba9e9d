#include "motion/math/convex_weights.h"

#include <algorithm>
#include <cassert>
#include <utility>
#include <vector>

#include "motion/math/linear_system.h"
#include "motion/math/singular_values.h"

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

/// Weights and slopes (by the size of the largest) below this are taken for 0.
constexpr double rounding = 1e-11;

/// Directions that spread less than this share of the widest count as none.
constexpr double least_spread = 1e-9;

using Indices = std::vector<Eigen::Index>;

bool contains(const Indices& set, Eigen::Index i) {
  return std::find(set.begin(), set.end(), i) != set.end();
}

/// Orthonormal rows that span what fixes a mean: the points' coordinates and the sum of weights.
Eigen::MatrixXd mean_rows(const Eigen::MatrixXd& points) {
  Eigen::MatrixXd rows(points.rows() + 1, points.cols());
  rows << Eigen::RowVectorXd::Ones(points.cols()), points;
  const SingularValues values = singular_values(rows);
  return values.v.leftCols(values.rank(least_spread)).transpose();
}

/// The component of a vector orthogonal to the columns.
Eigen::VectorXd rest(const Eigen::MatrixXd& orthonormal, Eigen::VectorXd vector) {
  for (int pass = 0; pass < 2; ++pass) vector -= orthonormal * (orthonormal.transpose() * vector);
  return vector;
}

/// The points with a weight and, until their columns span all rows, those that add most.
Indices spanning_set(const Eigen::MatrixXd& rows, const Eigen::VectorXd& weights) {
  Indices set;
  Eigen::MatrixXd span(rows.rows(), 0);
  const auto add = [&](Eigen::Index i, const Eigen::VectorXd& direction) {
    set.push_back(i);
    span.conservativeResize(Eigen::NoChange, span.cols() + 1);
    span.rightCols<1>() = direction.normalized();
  };
  for (Eigen::Index i = 0; i < weights.size(); ++i) {
    if (weights[i] > 0.0) add(i, rest(span, rows.col(i)));
  }
  while (span.cols() < rows.rows()) {
    Eigen::Index best = -1;
    Eigen::VectorXd longest = Eigen::VectorXd::Zero(rows.rows());
    for (Eigen::Index i = 0; i < weights.size(); ++i) {
      if (contains(set, i)) continue;
      const Eigen::VectorXd direction = rest(span, rows.col(i));
      if (best < 0 || direction.norm() > longest.norm()) {
        best = i;
        longest = direction;
      }
    }
    add(best, longest);
  }
  return set;
}

/// A quadratic programme with what an active set method looks at.
class Programme {
 public:
  Programme(const Eigen::MatrixXd& points, const Eigen::VectorXd& start, const Eigen::MatrixXd& c,
            const Eigen::VectorXd& d)
      : rows_(mean_rows(points)),
        c_(c),
        d_(d),
        weights_(start),
        free_(spanning_set(rows_, start)) {}

  Eigen::VectorXd solve() {
    // No set of free weights comes twice; the bound is there for rounding.
    for (Eigen::Index steps = 100 * weights_.size(); steps > 0; --steps) {
      const Eigen::VectorXd way = way_to_least();
      const auto [share, blocking] = share_of_way(way);
      weights_(free_) += share * way;
      if (blocking >= 0) {
        weights_[blocking] = 0.0;
        std::erase(free_, blocking);
        stands_ = share <= 0.0;
        continue;
      }
      const Eigen::Index released = best_release();
      if (released < 0) break;
      free_.push_back(released);
    }
    const Eigen::VectorXd weights = weights_.cwiseMax(0.0);  // without roundings below 0
    return weights / weights.sum();
  }

 private:
  /// From the free weights as they are to where the squares are least, at the same mean.
  Eigen::VectorXd way_to_least() const {
    const auto count = static_cast<Eigen::Index>(free_.size());
    if (count == rows_.rows()) return Eigen::VectorXd::Zero(count);
    const Eigen::MatrixXd ways = null_space(rows_(Eigen::all, free_));
    return ways * least_squares(c_(Eigen::all, free_) * ways, d_ - c_ * weights_);
  }

  /// How far one may go until a weight reaches 0, and that weight; −1 when none does.
  std::pair<double, Eigen::Index> share_of_way(const Eigen::VectorXd& way) const {
    double share = 1.0;
    Eigen::Index blocking = -1;
    for (std::size_t i = 0; i < free_.size(); ++i) {
      const double change = way[static_cast<Eigen::Index>(i)];
      if (change >= -rounding) continue;
      const double until = std::max(0.0, weights_[free_[i]]) / -change;
      if (until < share || (until == share && blocking >= 0 && free_[i] < blocking)) {
        share = until;
        blocking = free_[i];
      }
    }
    return {share, blocking};
  }

  /// The weight that is 0 and whose growth lowers the squares most; after a step of no length the
  /// first that lowers them, so that sets do not come round in circles. −1 when none does.
  Eigen::Index best_release() {
    const Eigen::VectorXd slopes = c_.transpose() * (c_ * weights_ - d_);
    const Eigen::VectorXd prices =
        least_squares(rows_(Eigen::all, free_).transpose(), slopes(free_));
    const Eigen::VectorXd reduced = slopes - rows_.transpose() * prices;
    const double tolerance =
        rounding * (c_.colwise().squaredNorm().maxCoeff() + (c_.transpose() * d_).norm());
    Eigen::Index best = -1;
    for (Eigen::Index i = 0; i < reduced.size(); ++i) {
      if (contains(free_, i) || reduced[i] >= -tolerance) continue;
      if (best < 0 || reduced[i] < reduced[best]) best = i;
      if (stands_) break;
    }
    return best;
  }

  Eigen::MatrixXd rows_;
  const Eigen::MatrixXd& c_;
  const Eigen::VectorXd& d_;
  Eigen::VectorXd weights_;
  Indices free_;
  bool stands_ = false;
};

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

Eigen::VectorXd weights_nearest_to(const Eigen::MatrixXd& points, const Eigen::VectorXd& target) {
  assert(points.rows() == target.size() && points.cols() > 0);
  // The nearest point of a cone over the hull: its weights, scaled to a sum of 1, are the hull's.
  Eigen::MatrixXd cone(points.rows() + 1, points.cols());
  cone << Eigen::RowVectorXd::Ones(points.cols()), points.colwise() - target;
  const Eigen::VectorXd weights =
      nonnegative_least_squares(cone, Eigen::VectorXd::Unit(cone.rows(), 0));
  return weights / weights.sum();
}

Eigen::VectorXd least_squares_at_mean(const Eigen::MatrixXd& points, const Eigen::VectorXd& start,
                                      const Eigen::MatrixXd& c, const Eigen::VectorXd& d) {
  return Programme(points, start, c, d).solve();
}

}  // namespace mien::motion

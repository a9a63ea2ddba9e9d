#include "motion/animate/displacement_curve.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Core>

#include "motion/math/linear_system.h"

namespace mien::motion {

namespace {

constexpr double same_moment = 1e-9;  // seconds

using Form = Eigen::Matrix<double, 6, 6>;

/// The integral of the squared jerk of a quintic as a quadratic form in value, slope and curvature
/// at its start and its end, `width` seconds later.
Form jerk_form(double width) {
  // Coefficients of s³, s⁴ and s⁵ (s from 0 to 1) by value, slope and curvature at both ends.
  Eigen::Matrix<double, 3, 6> coefficients;
  coefficients << -10, -6, -1.5, 10, -4, 0.5,  //
      15, 8, 1.5, -15, 7, -1,                  //
      -6, -3, -0.5, 6, -3, 0.5;
  Eigen::Matrix3d squared;
  squared << 36, 72, 120, 72, 192, 360, 120, 360, 720;
  Eigen::Matrix<double, 6, 1> scale;
  scale << 1, width, width * width, 1, width, width * width;
  const Eigen::Matrix<double, 3, 6> scaled = coefficients * scale.asDiagonal();
  return scaled.transpose() * squared * scaled / std::pow(width, 5);
}

double middle(const CurveKey& key) { return 0.5 * (key.from + key.to); }

}  // namespace

DisplacementCurve::DisplacementCurve(std::vector<CurveKey> keys, std::optional<double> period)
    : period_(period) {
  if (keys.empty()) return;
  std::sort(keys.begin(), keys.end(),
            [](const CurveKey& a, const CurveKey& b) { return middle(a) < middle(b); });
  if (period_) {
    for (CurveKey& key : keys) {
      const double most = 0.5 * (*period_ - (key.to - key.from));
      key.before = std::min(key.before, most);
      key.after = std::min(key.after, most);
    }
  }
  connect(keys);
  minimize_jerk();
}

void DisplacementCurve::add(const CurveKey& key) {
  const bool holds = key.to > key.from;
  knots_.push_back({key.from, key.value});
  knots_.back().is_level = holds;
  if (!holds) return;
  knots_.push_back({key.to, key.value});
  segments_.push_back({knots_.size() - 2, knots_.size() - 1, key.to - key.from});
}

void DisplacementCurve::connect(const std::vector<CurveKey>& keys) {
  const std::size_t count = keys.size();
  std::vector<std::size_t> first, last;  // knots of each key
  for (const CurveKey& key : keys) {
    first.push_back(knots_.size());
    add(key);
    last.push_back(knots_.size() - 1);
  }
  const auto fade = [&](std::size_t from, std::size_t to, double width) {
    segments_.push_back({from, to, width});
  };
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t next = (k + 1) % count;
    const bool is_last = next == 0;
    const double gap = keys[next].from + (is_last ? period_.value_or(0.0) : 0.0) - keys[k].to;
    const bool meets = !is_last || period_;
    if (meets && count > 1 && gap < keys[k].after + keys[next].before) {
      fade(last[k], first[next], gap);
      continue;
    }
    knots_.push_back({keys[k].to + keys[k].after, Vec3::Zero()});
    fade(last[k], knots_.size() - 1, keys[k].after);
    knots_.push_back({keys[next].from - keys[next].before, Vec3::Zero()});
    fade(knots_.size() - 1, first[next], keys[next].before);
  }
}

void DisplacementCurve::minimize_jerk() {
  std::vector<Eigen::Index> place(knots_.size(), -1);  // of its slope among the unknowns
  Eigen::Index unknowns = 0;
  for (std::size_t k = 0; k < knots_.size(); ++k) {
    if (knots_[k].is_level) continue;
    place[k] = unknowns;
    unknowns += 2;
  }
  if (unknowns == 0) return;
  // In units of the mean width, for the sake of precision.
  double unit = 0.0;
  for (const Segment& segment : segments_) unit += segment.width / double(segments_.size());
  Eigen::MatrixXd system = Eigen::MatrixXd::Zero(unknowns, unknowns);
  Eigen::MatrixXd right = Eigen::MatrixXd::Zero(unknowns, 3);
  for (const Segment& segment : segments_) {
    const Form form = jerk_form(segment.width / unit);
    const std::size_t ends[] = {segment.first, segment.last};
    for (int a = 0; a < 2; ++a) {
      const Eigen::Index row = place[ends[a]];
      if (row < 0) continue;
      for (int b = 0; b < 2; ++b) {
        right.middleRows(row, 2) -=
            form.block<2, 1>(3 * a + 1, 3 * b) * knots_[ends[b]].value.transpose();
        const Eigen::Index column = place[ends[b]];
        if (column >= 0) system.block<2, 2>(row, column) += form.block<2, 2>(3 * a + 1, 3 * b + 1);
      }
    }
  }
  const Eigen::MatrixXd solved = solve_symmetric(system, right);
  for (std::size_t k = 0; k < knots_.size(); ++k) {
    if (place[k] < 0) continue;
    knots_[k].slope = solved.row(place[k]).transpose() / unit;
    knots_[k].curvature = solved.row(place[k] + 1).transpose() / (unit * unit);
  }
}

Vec3 DisplacementCurve::along(const Segment& segment, double seconds) const {
  const Knot& from = knots_[segment.first];
  const Knot& to = knots_[segment.last];
  const double s = seconds / segment.width;
  const Vec3 rise = to.value - from.value;
  if (from.is_level && to.is_level && rise.isZero(0.0)) return from.value;
  const Vec3 v0 = segment.width * from.slope, v1 = segment.width * to.slope;
  const Vec3 a0 = segment.width * segment.width * from.curvature;
  const Vec3 a1 = segment.width * segment.width * to.curvature;
  const Vec3 c3 = 10.0 * rise - 6.0 * v0 - 4.0 * v1 - 1.5 * a0 + 0.5 * a1;
  const Vec3 c4 = -15.0 * rise + 8.0 * v0 + 7.0 * v1 + 1.5 * a0 - a1;
  const Vec3 c5 = 6.0 * rise - 3.0 * v0 - 3.0 * v1 - 0.5 * a0 + 0.5 * a1;
  return from.value + s * (v0 + s * (0.5 * a0 + s * (c3 + s * (c4 + s * c5))));
}

bool DisplacementCurve::is_nothing(const Knot& knot) {
  return knot.is_level && knot.value.isZero(0.0);
}

Vec3 DisplacementCurve::at(double seconds) const {
  for (const Segment& segment : segments_) {
    double since = seconds - knots_[segment.first].seconds;
    if (period_) since -= *period_ * std::floor(since / *period_);
    if (since < 0.0 || since > segment.width) continue;
    // Exactly nothing at the end of a reach, whatever the rounding of the time.
    if (since < same_moment && is_nothing(knots_[segment.first])) return Vec3::Zero();
    if (since > segment.width - same_moment && is_nothing(knots_[segment.last]))
      return Vec3::Zero();
    return along(segment, since);
  }
  return Vec3::Zero();
}

}  // namespace mien::motion

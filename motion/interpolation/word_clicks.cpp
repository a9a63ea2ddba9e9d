#include "motion/interpolation/word_clicks.h"

#include <cassert>
#include <cmath>

#include "motion/interpolation/cardinal_basis.h"
#include "motion/math/singular_values.h"

namespace mien::motion {

namespace {

constexpr int most_clicks = 400;
constexpr double least_gain = 1e-6;

}  // namespace

WordClicks fit_word_clicks(const Eigen::MatrixXd& places, double step) {
  assert(places.rows() > 0 && step > 0.0);
  WordClicks words;
  words.step = step;
  words.mean = places.colwise().mean().transpose();
  words.standardised = places.transpose().colwise() - words.mean;
  words.deviation =
      (words.standardised.rowwise().squaredNorm() / static_cast<double>(places.rows())).cwiseSqrt();
  for (double& deviation : words.deviation) {
    if (deviation < 1e-9) deviation = 1.0;
  }
  words.standardised.array().colwise() /= words.deviation.array();
  return words;
}

Eigen::VectorXd clicked(const WordClicks& words, const Eigen::VectorXd& weights,
                        std::span<const Click> word) {
  const auto named = static_cast<Eigen::Index>(word.size());
  Eigen::MatrixXd constraints(named + 1, weights.size());
  Eigen::VectorXd change(named + 1);
  for (Eigen::Index i = 0; i < named; ++i) {
    const Click& click = word[static_cast<size_t>(i)];
    constraints.row(i) = words.standardised.row(click.parameter);
    change[i] = words.step * click.sign;
  }
  constraints.row(named).setOnes();
  change[named] = 0.0;
  const Eigen::VectorXd move = singular_values(constraints).solve(change, 1e-12);
  return clipped_and_normalised(weights + move);
}

ClickPath click_towards(const WordClicks& words, const Eigen::RowVectorXd& request) {
  const auto count = words.standardised.cols();
  const Eigen::VectorXd goal = (request.transpose() - words.mean).cwiseQuotient(words.deviation);
  ClickPath path;
  path.weights = Eigen::VectorXd::Constant(count, 1.0 / static_cast<double>(count));
  std::vector<bool> stuck(static_cast<size_t>(goal.size()), false);
  while (static_cast<int>(path.clicks.size()) < most_clicks) {
    const Eigen::VectorXd missing = goal - words.standardised * path.weights;
    path.arrived = missing.size() == 0 || missing.cwiseAbs().maxCoeff() <= 0.5 * words.step;
    int farthest = -1;
    for (int m = 0; m < static_cast<int>(missing.size()); ++m) {
      if (stuck[static_cast<size_t>(m)] || std::abs(missing[m]) <= 0.5 * words.step) continue;
      if (farthest < 0 || std::abs(missing[m]) > std::abs(missing[farthest])) farthest = m;
    }
    if (farthest < 0) break;
    const Click click{farthest, missing[farthest] > 0.0 ? 1 : -1};
    const Eigen::VectorXd next = clicked(words, path.weights, std::span(&click, 1));
    const double gain = missing.norm() - (goal - words.standardised * next).norm();
    if (gain < least_gain) {
      stuck[static_cast<size_t>(farthest)] = true;
      continue;
    }
    path.weights = next;
    path.clicks.push_back(click);
    stuck.assign(stuck.size(), false);
  }
  return path;
}

}  // namespace mien::motion

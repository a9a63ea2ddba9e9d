#include "pipeline/base/adaptive/quest_plus.h"

#include <cmath>
#include <utility>

#include "motion/error.h"

namespace mien::pipeline {

namespace {

/// −p ln p.
double entropy_term(double p) { return p > 0.0 ? -p * std::log(p) : 0.0; }

/// Visits the points of the grid of the axes in their order, with the place on each axis.
void for_each_point(const std::vector<QuestAxis>& axes, auto&& visit) {
  std::vector<std::size_t> places(axes.size(), 0);
  for (Eigen::Index point = 0;; ++point) {
    visit(point, places);
    std::size_t axis = axes.size();
    while (axis > 0 && ++places[axis - 1] == axes[axis - 1].values.size()) places[--axis] = 0;
    if (axis == 0) return;
  }
}

Eigen::Index number_of_points(const std::vector<QuestAxis>& axes) {
  std::size_t points = 1;
  for (const QuestAxis& axis : axes) points *= axis.values.size();
  return static_cast<Eigen::Index>(points);
}

}  // namespace

QuestPlus quest_plus(std::vector<double> stimuli, std::vector<QuestAxis> axes, int outcomes,
                     const OutcomeProbability& probability) {
  QuestPlus quest;
  const Eigen::Index points = number_of_points(axes);
  const auto columns = static_cast<Eigen::Index>(stimuli.size());
  quest.prior = Eigen::VectorXd::Ones(points);
  quest.probability.assign(static_cast<std::size_t>(outcomes), Eigen::MatrixXd(points, columns));
  quest.outcome_entropy = Eigen::MatrixXd::Zero(points, columns);
  std::vector<double> parameters(axes.size());
  for_each_point(axes, [&](Eigen::Index point, const std::vector<std::size_t>& places) {
    for (std::size_t i = 0; i < axes.size(); ++i) {
      parameters[i] = axes[i].values[places[i]];
      if (!axes[i].prior.empty()) quest.prior[point] *= axes[i].prior[places[i]];
    }
    for (Eigen::Index column = 0; column < columns; ++column) {
      const double stimulus = stimuli[static_cast<std::size_t>(column)];
      for (int outcome = 0; outcome < outcomes; ++outcome) {
        const double p = probability(outcome, stimulus, parameters);
        quest.probability[static_cast<std::size_t>(outcome)](point, column) = p;
        quest.outcome_entropy(point, column) += entropy_term(p);
      }
    }
  });
  quest.prior /= quest.prior.sum();
  quest.axes = std::move(axes);
  quest.stimuli = std::move(stimuli);
  return quest;
}

QuestPlus psychometric_quest(Sigmoid sigmoid, std::vector<double> stimuli, QuestAxis location,
                             QuestAxis width, QuestAxis guess, QuestAxis lapse) {
  return quest_plus(std::move(stimuli),
                    {std::move(location), std::move(width), std::move(guess), std::move(lapse)}, 2,
                    [sigmoid](int outcome, double stimulus, const std::vector<double>& parameters) {
                      const AnswerProbability p = answer_probability(
                          {sigmoid, parameters[0], parameters[1], parameters[2], parameters[3]},
                          stimulus);
                      return outcome == 0 ? p.negative : p.positive;
                    });
}

Eigen::VectorXd updated(const QuestPlus& quest, const Eigen::VectorXd& posterior,
                        const QuestAnswer& answer) {
  const Eigen::MatrixXd& probability = quest.probability[static_cast<std::size_t>(answer.outcome)];
  const Eigen::VectorXd product =
      posterior.cwiseProduct(probability.col(static_cast<Eigen::Index>(answer.stimulus)));
  const double sum = product.sum();
  if (!(sum > 0.0))
    throw Error("an answer is impossible for all values of the parameters",
                "permit lapses and guesses");
  return product / sum;
}

Eigen::VectorXd posterior_after(const QuestPlus& quest, const std::vector<QuestAnswer>& answers) {
  Eigen::VectorXd posterior = quest.prior;
  for (const QuestAnswer& answer : answers) posterior = updated(quest, posterior, answer);
  return posterior;
}

Eigen::VectorXd expected_entropies(const QuestPlus& quest, const Eigen::VectorXd& posterior) {
  Eigen::VectorXd entropies = quest.outcome_entropy.transpose() * posterior;
  entropies.array() += posterior.unaryExpr(&entropy_term).sum();
  for (const Eigen::MatrixXd& probability : quest.probability)
    entropies -= (probability.transpose() * posterior).unaryExpr(&entropy_term);
  return entropies;
}

std::size_t next_stimulus(const QuestPlus& quest, const Eigen::VectorXd& posterior) {
  constexpr double tie = 1e-12;
  const Eigen::VectorXd entropies = expected_entropies(quest, posterior);
  const double least = entropies.minCoeff();
  Eigen::Index place = 0;
  while (entropies[place] > least + tie) ++place;
  return static_cast<std::size_t>(place);
}

QuestEstimate quest_estimate(const QuestPlus& quest, const Eigen::VectorXd& posterior,
                             std::size_t axis, double credibility) {
  const std::vector<double>& values = quest.axes[axis].values;
  Eigen::VectorXd marginal = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(values.size()));
  for_each_point(quest.axes, [&](Eigen::Index point, const std::vector<std::size_t>& places) {
    marginal[static_cast<Eigen::Index>(places[axis])] += posterior[point];
  });
  const Eigen::Map<const Eigen::VectorXd> grid(values.data(), marginal.size());
  const auto quantile = [&](double share) {
    Eigen::Index place = 0;
    // Sums of probabilities are a little below 1.
    for (double sum = marginal[0]; sum < share - 1e-12 && place + 1 < marginal.size();)
      sum += marginal[++place];
    return grid[place];
  };
  Eigen::Index most_probable = 0;
  marginal.maxCoeff(&most_probable);
  QuestEstimate estimate;
  estimate.mean = grid.dot(marginal);
  estimate.deviation = std::sqrt((grid.array() - estimate.mean).square().matrix().dot(marginal));
  estimate.mode = grid[most_probable];
  estimate.low = quantile(0.5 * (1.0 - credibility));
  estimate.high = quantile(0.5 * (1.0 + credibility));
  return estimate;
}

std::vector<double> most_probable(const QuestPlus& quest, const Eigen::VectorXd& posterior) {
  Eigen::Index best = 0;
  posterior.maxCoeff(&best);
  std::vector<double> values;
  for_each_point(quest.axes, [&](Eigen::Index point, const std::vector<std::size_t>& places) {
    if (point != best) return;
    for (std::size_t i = 0; i < places.size(); ++i)
      values.push_back(quest.axes[i].values[places[i]]);
  });
  return values;
}

bool is_finished(const QuestPlus& quest, const Eigen::VectorXd& posterior, int trials,
                 const QuestStop& stop) {
  if (stop.most_trials > 0 && trials >= stop.most_trials) return true;
  return stop.deviation > 0.0 &&
         quest_estimate(quest, posterior, stop.axis).deviation <= stop.deviation;
}

}  // namespace mien::pipeline

#include "pipeline/study/questionnaire/rating_spread.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <Eigen/Dense>

#include "motion/error.h"

namespace mien::pipeline {

namespace {

/// Sum and number of the ratings of one participant, or of one stimulus.
struct Total {
  double sum = 0.0;
  double count = 0.0;
};

using Totals = std::map<int, Total>;

/// Sum of total² / count.
double squares(const Totals& totals) {
  double sum = 0.0;
  for (const auto& [key, total] : totals) sum += total.sum * total.sum / total.count;
  return sum;
}

double squared_counts(const Totals& totals) {
  double sum = 0.0;
  for (const auto& [key, total] : totals) sum += total.count * total.count;
  return sum;
}

[[noreturn]] void refuse() {
  throw Error(
      "these ratings are too few to estimate the variance between participants and between stimuli",
      "give ratings by several participants of several stimuli each, or state standard deviations");
}

}  // namespace

RatingSpread spread_of(const std::vector<CrossedRating>& ratings) {
  Totals participants, stimuli;
  Total all;
  double raw = 0.0;
  for (const CrossedRating& rating : ratings) {
    for (Total* total : {&participants[rating.participant], &stimuli[rating.stimulus], &all}) {
      total->sum += rating.value;
      total->count += 1.0;
    }
    raw += rating.value * rating.value;
  }
  const auto people = static_cast<double>(participants.size());
  const auto things = static_cast<double>(stimuli.size());
  if (people < 2 || things < 2 || all.count < people + things) refuse();
  const double mean_square = all.sum * all.sum / all.count;
  // Expectations of the four sums in the squared mean and the three variances; as there is one
  // rating a cell, Σ n_ij² / n_i. is the number of participants.
  Eigen::Matrix4d of;
  of << all.count, all.count, all.count, all.count,  // raw
      all.count, all.count, people, people,          // participants
      all.count, things, all.count, things,          // stimuli
      all.count, squared_counts(participants) / all.count, squared_counts(stimuli) / all.count, 1.0;
  const Eigen::Vector4d sums(raw, squares(participants), squares(stimuli), mean_square);
  const Eigen::FullPivLU<Eigen::Matrix4d> solver(of);
  if (!solver.isInvertible()) refuse();
  const Eigen::Vector4d variances = solver.solve(sums);
  const auto deviation = [&](int i) { return std::sqrt(std::max(0.0, variances[i])); };
  return {.participant = deviation(1), .stimulus = deviation(2), .residual = deviation(3)};
}

std::vector<ScaleSpread> spreads_of(const Answers& answers) {
  std::map<std::string, int> people, things;
  std::vector<std::pair<std::string, std::map<std::pair<int, int>, Total>>> by_scale;
  const auto number = [](std::map<std::string, int>& numbers, const std::string& name) {
    return numbers.emplace(name, static_cast<int>(numbers.size())).first->second;
  };
  for (const Answer& answer : answers.answers) {
    if (answer.participant.empty())
      throw Error("these ratings are means over several participants",
                  "give the answers of each participant");
    auto cells = std::ranges::find(by_scale, answer.scale, [](const auto& of) { return of.first; });
    if (cells == by_scale.end()) cells = by_scale.insert(cells, {answer.scale, {}});
    Total& cell =
        cells->second[{number(people, answer.participant), number(things, answer.stimulus)}];
    cell.sum += answer.value;
    cell.count += 1.0;
  }
  if (by_scale.empty()) refuse();
  std::vector<ScaleSpread> spreads;
  for (const auto& [scale, cells] : by_scale) {
    std::vector<CrossedRating> ratings;
    for (const auto& [cell, total] : cells)
      ratings.push_back({cell.first, cell.second, total.sum / total.count});
    spreads.push_back({scale, spread_of(ratings)});
  }
  return spreads;
}

}  // namespace mien::pipeline

#include "pipeline/study/power/assumed_effects.h"

#include <algorithm>
#include <map>
#include <utility>

#include "pipeline/manifest/factorial_plan.h"

namespace mien::pipeline {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// Half a point of difference between first and last of several levels; 0 between them.
double half_difference(std::size_t level, std::size_t levels) {
  return level == 0 ? 0.5 : level + 1 == levels ? -0.5 : 0.0;
}

}  // namespace

MatrixXd effect_shift(const PlannedDesign& design, const VarianceTerm& term) {
  MatrixXd shift = MatrixXd::Zero(static_cast<Index>(design.group_count),
                                  static_cast<Index>(design.stimuli.size()));
  const std::vector<int> levels = design.levels();
  for (std::size_t cell = 0; cell < design.crossing.cells.size(); ++cell) {
    std::vector<std::size_t> own(levels.size());
    std::size_t rest = cell;
    for (std::size_t i = levels.size(); i-- > 0;) {
      own[i] = rest % static_cast<std::size_t>(levels[i]);
      rest /= static_cast<std::size_t>(levels[i]);
    }
    double mean = 1.0;
    for (const std::size_t factor : term.factors)
      mean *= half_difference(own[factor], static_cast<std::size_t>(levels[factor]));
    for (std::size_t group = 0; group < design.group_count; ++group)
      for (const std::size_t stimulus : design.crossing.cells[cell])
        shift(static_cast<Index>(group), static_cast<Index>(stimulus)) =
            term.by_group ? mean * half_difference(group, design.group_count) : mean;
  }
  return shift;
}

MatrixXd contrast_shift(const PlannedDesign& design, const DesignContrast& contrast) {
  MatrixXd shift = MatrixXd::Zero(static_cast<Index>(design.group_count),
                                  static_cast<Index>(design.stimuli.size()));
  double squares = 0.0;
  for (const double weight : contrast.weights) squares += weight * weight;
  for (std::size_t cell = 0; cell < contrast.cells.size(); ++cell)
    for (const std::size_t stimulus : contrast.cells[cell])
      shift.col(static_cast<Index>(stimulus)).setConstant(contrast.weights[cell] / squares);
  return shift;
}

double value_of(const DesignContrast& contrast, const MatrixXd& shift) {
  double value = 0.0;
  for (std::size_t cell = 0; cell < contrast.cells.size(); ++cell)
    value +=
        contrast.weights[cell] * shift.col(static_cast<Index>(contrast.cells[cell].front())).mean();
  return value;
}

std::vector<double> cell_truth(const Manifest& manifest, const StatedTruth& truth,
                               const std::vector<std::string>& stimuli, const Scale& scale) {
  const FactorTable table = design_table(manifest);
  std::vector<std::vector<std::string>> levels;
  std::map<std::vector<std::string>, std::pair<double, double>> sums;
  for (const std::string& stimulus : stimuli) {
    const auto place = std::ranges::find(manifest.stimuli, stimulus, &Stimulus::id);
    levels.push_back(table.rows[static_cast<std::size_t>(place - manifest.stimuli.begin())]);
    auto known = truth.find({stimulus, scale.id});
    if (known == truth.end())
      known = truth.find({stimulus.substr(0, stimulus.rfind('~')), scale.id});
    auto& [sum, count] = sums[levels.back()];
    sum += known == truth.end() ? 0.5 * (scale.least + scale.most) : known->second;
    count += 1.0;
  }
  std::vector<double> means;
  for (const auto& own : levels) means.push_back(sums[own].first / sums[own].second);
  return means;
}

}  // namespace mien::pipeline

#include "pipeline/study/analysis/feature_regression.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "motion/error.h"
#include "motion/math/percentile.h"
#include "pipeline/base/documents/csv.h"
#include "pipeline/production/synthesis/parameter_label.h"

namespace mien::pipeline {

namespace {

constexpr std::size_t fewest_examples = 4;

Eigen::RowVectorXd chosen(const motion::FeatureValues& values, const std::vector<int>& indices) {
  Eigen::RowVectorXd row(static_cast<Eigen::Index>(indices.size()));
  for (std::size_t k = 0; k < indices.size(); ++k) {
    row[static_cast<Eigen::Index>(k)] = values[static_cast<std::size_t>(indices[k])];
  }
  return row;
}

void choose_features(FeatureRegression& regression, const FeatureParameters& features) {
  for (int i = 0; i < motion::motion_feature_count; ++i) {
    const auto lacks = [i](const motion::FeatureValues& values) {
      return std::isnan(values[static_cast<std::size_t>(i)]);
    };
    if (std::any_of(features.values.begin(), features.values.end(), lacks)) continue;
    regression.feature_indices.push_back(i);
    regression.features.emplace_back(motion::motion_features()[static_cast<std::size_t>(i)].id);
  }
}

void number_styles(FeatureRegression& regression, const std::vector<RatedExample>& names) {
  std::map<std::string, int> numbers;
  for (const RatedExample& example : names) {
    const auto next = static_cast<int>(numbers.size());
    regression.examples.push_back(example.name);
    regression.style_of_example.push_back(
        numbers.emplace(style_of(example.name), next).first->second);
  }
}

PredictionCheck checked(const std::string& parameter, const std::string& left_out,
                        const Eigen::MatrixXd& predictors, const Eigen::VectorXd& observed,
                        const std::vector<int>& group) {
  PredictionCheck check{parameter, left_out, cross_validate(predictors, observed, group)};
  check.rmse = check.predictions.rmse(observed);
  check.mean_rmse = check.predictions.mean_rmse(observed);
  check.r_squared = check.predictions.r_squared(observed);
  return check;
}

ParameterRegression fitted(const std::string& parameter, const Eigen::MatrixXd& predictors,
                           const Eigen::VectorXd& observed, const std::vector<int>& style) {
  ParameterRegression result;
  result.parameter = parameter;
  result.observed = observed;
  std::vector<int> alone;
  for (Eigen::Index i = 0; i < observed.size(); ++i) alone.push_back(static_cast<int>(i));
  result.checks.push_back(checked(parameter, "example", predictors, observed, alone));
  const int styles = 1 + *std::max_element(style.begin(), style.end());
  if (styles > 1 && styles < observed.size()) {
    result.checks.push_back(checked(parameter, "style", predictors, observed, style));
  }
  const bool by_style = result.checks.size() > 1;
  const double penalty = best_penalty(predictors, observed, by_style ? style : alone);
  result.model = fit_ridge(predictors, observed, penalty);

  std::vector<double> errors;
  for (Eigen::Index i = 0; i < observed.size(); ++i) {
    errors.push_back(std::abs(observed[i] - result.checks.back().predictions.predicted[i]));
    const double own = leverage(result.model, predictors.row(i));
    result.mean_leverage += own / static_cast<double>(observed.size());
    result.largest_leverage = std::max(result.largest_leverage, own);
  }
  result.error_90 = motion::percentile(errors, 90.0);
  return result;
}

}  // namespace

std::string style_of(const std::string& example) {
  std::size_t end = example.find_last_not_of("0123456789");
  if (end == std::string::npos || end + 1 == example.size()) return example;
  const std::size_t last = example.find_last_not_of("-_ .", end);
  return last == std::string::npos ? example : example.substr(0, last + 1);
}

FeatureRegression fit_feature_regression(const Repertoire& repertoire) {
  if (repertoire.parameters.names.empty()) {
    throw Error("the examples have no ratings for prediction", "give ratings");
  }
  if (repertoire.names.size() < fewest_examples) {
    throw Error("there are too few examples for prediction", "rate four motions or more");
  }
  FeatureRegression regression;
  regression.simulated = repertoire.simulated_ratings;
  choose_features(regression, repertoire.features);
  number_styles(regression, repertoire.names);
  Eigen::MatrixXd predictors(static_cast<Eigen::Index>(repertoire.names.size()),
                             static_cast<Eigen::Index>(regression.features.size()));
  for (Eigen::Index i = 0; i < predictors.rows(); ++i) {
    predictors.row(i) =
        chosen(repertoire.features.values[static_cast<std::size_t>(i)], regression.feature_indices);
  }
  const ParameterTable& table = repertoire.parameters;
  for (std::size_t r = 0; r < table.names.size(); ++r) {
    regression.parameters.push_back(fitted(table.names[r], predictors,
                                           table.values.row(static_cast<Eigen::Index>(r)),
                                           regression.style_of_example));
  }
  return regression;
}

std::vector<Prediction> predict(const FeatureRegression& regression,
                                const motion::FeatureValues& features) {
  const Eigen::RowVectorXd predictors = chosen(features, regression.feature_indices);
  if (!predictors.allFinite()) {
    throw Error("the motion has no gait cycle, but the rated ones have",
                "give a walk of one cycle or more");
  }
  std::vector<Prediction> predictions;
  for (const ParameterRegression& r : regression.parameters) {
    Prediction p;
    p.parameter = r.parameter;
    p.value = predicted(r.model, predictors);
    p.leverage = leverage(r.model, predictors);
    p.extrapolated = p.leverage > r.largest_leverage;
    const double reach = r.error_90 * std::sqrt((1.0 + p.leverage) / (1.0 + r.mean_leverage));
    p.low = p.value - reach;
    p.high = p.value + reach;
    predictions.push_back(std::move(p));
  }
  return predictions;
}

std::string checks_csv(const FeatureRegression& regression, const ScaleSet& scales) {
  CsvWriter table({"parameter", "ratings", "left_out", "examples", "rmse", "mean_rmse", "r_squared",
                   "name", "name_ja"});
  for (const ParameterRegression& parameter : regression.parameters) {
    const ParameterLabel label = rating_label(parameter.parameter, scales);
    for (const PredictionCheck& check : parameter.checks) {
      table.row({check.parameter, regression.simulated ? "simulated" : "given", check.left_out,
                 std::to_string(regression.examples.size()), shortest(check.rmse),
                 shortest(check.mean_rmse), shortest(check.r_squared), english_text(label),
                 japanese_text(label)});
    }
  }
  return table.text();
}

std::string left_out_csv(const FeatureRegression& regression) {
  CsvWriter table({"parameter", "ratings", "left_out", "example", "observed", "predicted",
                   "mean_predicted", "penalty"});
  for (const ParameterRegression& parameter : regression.parameters) {
    for (const PredictionCheck& check : parameter.checks) {
      for (std::size_t i = 0; i < regression.examples.size(); ++i) {
        const auto at = static_cast<Eigen::Index>(i);
        table.row({check.parameter, regression.simulated ? "simulated" : "given", check.left_out,
                   regression.examples[i], shortest(parameter.observed[at]),
                   shortest(check.predictions.predicted[at]),
                   shortest(check.predictions.mean_predicted[at]),
                   shortest(check.predictions.penalty[at])});
      }
    }
  }
  return table.text();
}

}  // namespace mien::pipeline

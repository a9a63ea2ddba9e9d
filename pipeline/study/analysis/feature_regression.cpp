#include "pipeline/study/analysis/feature_regression.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "motion/error.h"
#include "pipeline/production/synthesis/parameter_label.h"

namespace mien::pipeline {

namespace {

constexpr std::size_t fewest_examples = 4;

Eigen::RowVectorXd chosen(const motion::FeatureValues& values, const std::vector<int>& indices) {
  Eigen::RowVectorXd row(static_cast<Eigen::Index>(indices.size()));
  for (std::size_t k = 0; k < indices.size(); ++k)
    row[static_cast<Eigen::Index>(k)] = values[static_cast<std::size_t>(indices[k])];
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
  if (styles > 1 && styles < observed.size())
    result.checks.push_back(checked(parameter, "style", predictors, observed, style));
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
  std::ranges::sort(errors);
  const auto place =
      static_cast<std::size_t>(std::ceil(0.9 * (static_cast<double>(errors.size()) + 1.0)));
  result.error_90 = errors[std::min(place, errors.size()) - 1];
  return result;
}

struct CheckRow {
  std::size_t examples;
  bool simulated;
  const PredictionCheck& check;
  ParameterLabel label;
};

struct LeftOutExample {
  const FeatureRegression& all;
  bool simulated;
  const PredictionCheck& check;
  const ParameterRegression& parameter;
  std::size_t example;

  double at(const Eigen::VectorXd& values) const {
    return values[static_cast<Eigen::Index>(example)];
  }
};

constexpr SharedColumn parameter_column{"parameter", "", "scale or group of scales",
                                        [](auto& r) { return r.check.parameter; }};
constexpr SharedColumn left_out_column{
    "left_out", "",
    "what is left out of the fit for each prediction: the example, or its style (all takes of it)",
    [](auto& r) { return r.check.left_out; }};

constexpr auto checks_columns = table_of<CheckRow>(
    "prediction_checks.csv", "parameter and kind of check",
    {parameter_column,
     whose_ratings_column,
     left_out_column,
     {"examples", "", "number of examples predicted", [](auto& r) { return r.examples; }},
     {"rmse", "0–1", "root mean square error of prediction, as a proportion of the scale",
      [](auto& r) { return r.check.rmse; }},
     {"mean_rmse", "0–1",
      "the same error when the mean of the examples not left out is the prediction",
      [](auto& r) { return r.check.mean_rmse; }},
     {"r_squared", "", "cross-validated R² = 1 − (rmse / mean_rmse)²; below 0: worse than the mean",
      [](auto& r) { return r.check.r_squared; }},
     {"name", "", "English name", [](auto& r) { return english_text(r.label); }},
     {"name_ja", "", "Japanese name", [](auto& r) { return japanese_text(r.label); }}});

constexpr auto left_out_columns = table_of<LeftOutExample>(
    "left_out_predictions.csv", "parameter, kind of check and example",
    {parameter_column,
     whose_ratings_column,
     left_out_column,
     {"example", "", "example label", [](auto& r) { return r.all.examples[r.example]; }},
     {"observed", "0–1", "mean rating", [](auto& r) { return r.at(r.parameter.observed); }},
     {"predicted", "0–1",
      "prediction from the features by a fit without the example (or its style)",
      [](auto& r) { return r.at(r.check.predictions.predicted); }},
     {"mean_predicted", "0–1", "mean rating of the examples in that fit",
      [](auto& r) { return r.at(r.check.predictions.mean_predicted); }},
     {"penalty", "", "penalty of the ridge regression in that fit",
      [](auto& r) { return r.at(r.check.predictions.penalty); }}});

}  // namespace

std::string style_of(const std::string& example) {
  std::size_t end = example.find_last_not_of("0123456789");
  if (end == std::string::npos || end + 1 == example.size()) return example;
  const std::size_t last = example.find_last_not_of("-_ .", end);
  return last == std::string::npos ? example : example.substr(0, last + 1);
}

FeatureRegression fit_feature_regression(const Repertoire& repertoire) {
  if (repertoire.parameters.names.empty())
    throw Error("the examples have no ratings for prediction", "give ratings");
  if (repertoire.names.size() < fewest_examples)
    throw Error("there are too few examples for prediction", "rate four motions or more");
  FeatureRegression regression;
  regression.simulated = repertoire.simulated_ratings;
  choose_features(regression, repertoire.features);
  number_styles(regression, repertoire.names);
  Eigen::MatrixXd predictors(static_cast<Eigen::Index>(repertoire.names.size()),
                             static_cast<Eigen::Index>(regression.features.size()));
  for (Eigen::Index i = 0; i < predictors.rows(); ++i)
    predictors.row(i) =
        chosen(repertoire.features.values[static_cast<std::size_t>(i)], regression.feature_indices);
  const ParameterTable& table = repertoire.parameters;
  for (std::size_t r = 0; r < table.names.size(); ++r)
    regression.parameters.push_back(fitted(table.names[r], predictors,
                                           table.values.row(static_cast<Eigen::Index>(r)),
                                           regression.style_of_example));
  return regression;
}

std::vector<Prediction> predict(const FeatureRegression& regression,
                                const motion::FeatureValues& features) {
  const Eigen::RowVectorXd predictors = chosen(features, regression.feature_indices);
  if (!predictors.allFinite())
    throw Error("the motion has no gait cycle, but the rated ones have",
                "give a walk of one cycle or more");
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

WrittenTable checks_table(const FeatureRegression& regression, const ScaleSet& scales) {
  std::vector<CheckRow> rows;
  for (const ParameterRegression& parameter : regression.parameters)
    for (const PredictionCheck& check : parameter.checks)
      rows.push_back({regression.examples.size(), regression.simulated, check,
                      rating_label(parameter.parameter, scales)});
  return checks_columns.of(rows);
}

WrittenTable left_out_table(const FeatureRegression& regression) {
  std::vector<LeftOutExample> rows;
  for (const ParameterRegression& parameter : regression.parameters)
    for (const PredictionCheck& check : parameter.checks)
      for (std::size_t i = 0; i < regression.examples.size(); ++i)
        rows.push_back({regression, regression.simulated, check, parameter, i});
  return left_out_columns.of(rows);
}

}  // namespace mien::pipeline

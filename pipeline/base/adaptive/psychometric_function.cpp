#include "pipeline/base/adaptive/psychometric_function.h"

#include <cmath>
#include <limits>
#include <numbers>

#include <boost/math/distributions/normal.hpp>

namespace mien::pipeline {

SigmoidValue sigmoid_at(Sigmoid sigmoid, double z) {
  switch (sigmoid) {
    case Sigmoid::logistic: {
      const double below = 1.0 / (1.0 + std::exp(-z));
      const double above = 1.0 / (1.0 + std::exp(z));
      return {below, above, below * above};
    }
    case Sigmoid::normal:
      return {0.5 * std::erfc(-z / std::numbers::sqrt2), 0.5 * std::erfc(z / std::numbers::sqrt2),
              std::exp(-0.5 * z * z) * std::numbers::inv_sqrtpi / std::numbers::sqrt2};
    case Sigmoid::weibull:
      break;
  }
  const double hazard = std::exp(z);
  const double above = std::exp(-hazard);
  return {-std::expm1(-hazard), above, above > 0.0 ? hazard * above : 0.0};
}

double sigmoid_quantile(Sigmoid sigmoid, double proportion) {
  switch (sigmoid) {
    case Sigmoid::logistic:
      return std::log(proportion) - std::log1p(-proportion);
    case Sigmoid::normal:
      return quantile(boost::math::normal(), proportion);
    case Sigmoid::weibull:
      break;
  }
  return std::log(-std::log1p(-proportion));
}

AnswerProbability answer_probability(const PsychometricFunction& function, double level) {
  const SigmoidValue value =
      sigmoid_at(function.sigmoid, (level - function.location) / function.width);
  const double range = 1.0 - function.guess - function.lapse;
  return {function.guess + range * value.below, function.lapse + range * value.above};
}

double level_at(const PsychometricFunction& function, double proportion) {
  const double share = (proportion - function.guess) / (1.0 - function.guess - function.lapse);
  if (!(share > 0.0 && share < 1.0)) return std::numeric_limits<double>::quiet_NaN();
  return function.location + function.width * sigmoid_quantile(function.sigmoid, share);
}

double slope_at(const PsychometricFunction& function, double level) {
  const double z = (level - function.location) / function.width;
  const double range = 1.0 - function.guess - function.lapse;
  return range * sigmoid_at(function.sigmoid, z).density / function.width;
}

}  // namespace mien::pipeline

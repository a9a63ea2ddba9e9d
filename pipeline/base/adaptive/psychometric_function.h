#pragma once

namespace mien::pipeline {

/// The shape F of a psychometric function, of z = (x − α)/β:
///
///   logistic  F(z) = 1/(1 + exp(−z))
///   normal    F(z) = Φ(z), the cumulative normal distribution
///   weibull   F(z) = 1 − exp(−exp(z)), for levels x on a logarithmic scale.
///
/// With x = ln s the last is the Weibull function 1 − exp(−(s/exp(α))^(1/β)) of intensity s. With x
/// in decibels (20·log₁₀ s) its exponent is 20/(β·ln 10), which is the slope of Watson (2017).
enum class Sigmoid { logistic, normal, weibull };

/// A sigmoid and its complement, each without cancellation, and its derivative by z.
struct SigmoidValue {
  double below;    ///< F(z)
  double above;    ///< 1 − F(z)
  double density;  ///< F′(z)
};

SigmoidValue sigmoid_at(Sigmoid sigmoid, double z);

/// z with F(z) = `proportion`, which must be between 0 and 1.
double sigmoid_quantile(Sigmoid sigmoid, double proportion);

/// The probability of a positive answer (correct, "yes", "different") at level x,
///
///   ψ(x) = γ + (1 − γ − λ) F((x − α)/β)
///
/// (Wichmann and Hill 2001a, eq. 1). It increases with the level: if stimuli become harder with
/// increasing levels, change the sign of the levels.
struct PsychometricFunction {
  Sigmoid sigmoid = Sigmoid::logistic;
  double location = 0.0;  ///< α, in units of the level
  double width = 1.0;     ///< β > 0, in units of the level
  double guess = 0.0;     ///< γ: 1/m if there are m alternatives
  double lapse = 0.0;     ///< λ; γ + λ < 1
};

/// ψ and 1 − ψ at a level, each without cancellation.
struct AnswerProbability {
  double positive;
  double negative;
};

AnswerProbability answer_probability(const PsychometricFunction& function, double level);

/// The threshold: the level at which ψ is `proportion`. NaN unless γ < proportion < 1 − λ.
double level_at(const PsychometricFunction& function, double proportion);

/// dψ/dx at a level, per unit of the level.
double slope_at(const PsychometricFunction& function, double level);

}  // namespace mien::pipeline

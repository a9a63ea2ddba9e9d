#pragma once

namespace mien::pipeline {

/// An interval of an effect size.
struct EffectInterval {
  double low = 0.0;
  double high = 0.0;
};

/// Confidence interval of partial η² from an F statistic: the noncentralities λ for which F is at
/// the upper and at the lower (1 − confidence)/2 quantile, each as λ/(λ + degrees + error_degrees +
/// 1) (Steiger 2004, equations 3 and 12). At 90 %, the interval excludes 0 exactly if p < 0.05.
/// Exact for independent observations with fixed factors, approximate for repeated measures. NaN
/// unless F is finite and not negative.
EffectInterval partial_eta_interval(double f, double degrees, double error_degrees,
                                    double confidence = 0.9);

/// Confidence interval of Cohen's d_z from the paired t statistic of `pairs` differences: the
/// noncentralities for which t is at the upper and lower quantiles, over √pairs (Cumming and Finch
/// 2001). NaN unless t is finite.
EffectInterval cohens_dz_interval(double t, int pairs, double confidence = 0.95);

}  // namespace mien::pipeline

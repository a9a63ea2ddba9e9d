#pragma once

#include "pipeline/base/statistics/bradley_terry.h"

namespace mien::pipeline {

/// Answers to signal and noise trials. In yes–no trials, a hit is "yes" to a signal, a false alarm
/// "yes" to noise. In two-interval trials, "the first" is the answer that is counted, and signal
/// trials are those with the signal in the first interval. In same–different trials, "different"
/// is counted, and signal trials are those with two different stimuli.
struct DetectionCounts {
  int signal_trials = 0;
  int hits = 0;
  int noise_trials = 0;
  int false_alarms = 0;

  friend bool operator==(const DetectionCounts&, const DetectionCounts&) = default;
};

/// Hit rate H = (hits + 0.5) / (signal trials + 1) and false-alarm rate F = (false alarms + 0.5) /
/// (noise trials + 1): the log-linear correction (Hautus 1995), applied to all counts, so that
/// rates are never 0 or 1.
struct DetectionRates {
  double hit = 0.5;
  double false_alarm = 0.5;
};

DetectionRates log_linear_rates(const DetectionCounts& counts);

/// Sensitivity and criterion, in standard deviations of the observation of one stimulus, with 95 %
/// intervals that treat all answers as independent.
struct Sensitivity {
  double d;                   ///< d′
  double error;               ///< standard error of d′; NaN if it is not part of the method
  Interval95 d_ends;          ///< 95 % interval of d′
  double criterion;           ///< see the functions below
  Interval95 criterion_ends;  ///< NaN if it is not part of the method
};

/// d′ = z(H) − z(F), with z the inverse of the normal distribution function. Rates must be between
/// 0 and 1, as in differencing_d.
double yes_no_d(const DetectionRates& rates);

/// d′ = z(H) − z(F) and the criterion c = −(z(H) + z(F))/2, positive if "no" is preferred, of
/// log_linear_rates (Macmillan and Creelman 2005, ch. 1 and 2). Standard errors by H(1 − H)/(N
/// φ(z(H))²) + F(1 − F)/(M φ(z(F))²), N and M the numbers of signal and noise trials (Gourevitch
/// and Galanter 1967), for c half of the root; intervals of ± 1.96 standard errors. All are NaN
/// without signal or without noise trials.
Sensitivity yes_no_sensitivity(const DetectionCounts& counts);

/// The same for two-interval forced choice: d′ = (z(H) − z(F))/√2 (ch. 7), with its standard error
/// divided by √2, too; the criterion is positive if the second interval is preferred.
Sensitivity two_interval_sensitivity(const DetectionCounts& counts);

/// d′ of the differencing model from the rates of "different" to different and to same pairs
/// (Macmillan and Creelman 2005, ch. 9): the participant answers "different" if the observations of
/// the two stimuli, of standard deviation 1, differ by more than k, so that
///
///     F = 2 Φ(−k/√2),   H = Φ((d′ − k)/√2) + Φ((−d′ − k)/√2).
///
/// 0 if the hit rate is not above the false-alarm rate. Rates must be between 0 and 1.
double differencing_d(const DetectionRates& rates);

/// The sensitivity by the differencing model from log_linear_rates; the criterion is k. The
/// interval of d′ is that of profile likelihood, of the corrected counts (Christensen and Brockhoff
/// 2009), and begins with 0 if the answers to same and different pairs do not differ enough. All
/// are NaN without signal or without noise trials.
Sensitivity same_different_sensitivity(const DetectionCounts& counts);

}  // namespace mien::pipeline

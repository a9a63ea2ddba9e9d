#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "pipeline/base/statistics/elo_rating.h"
#include "pipeline/base/statistics/transitivity.h"
#include "pipeline/base/statistics/worth_bootstrap.h"
#include "pipeline/study/results/answer_set.h"
#include "pipeline/study/results/worth_contrasts.h"

namespace mien::pipeline {

/// What comparisons say about one stimulus, or about all stimuli of one condition.
struct StimulusWorth {
  std::string name;  ///< ComparedConditions::names
  int chosen = 0;    ///< number of comparisons in which it was chosen
  int other_chosen = 0;
  int ties = 0;
  WinRecord record = WinRecord::estimated;
  int group = 1;               ///< counted from 1; worths of different groups cannot be compared
  double worth;                ///< log-worth; NaN if it is not finite. Sums to zero within a group
  double error;                ///< standard error, treating all answers as independent
  Interval95 by_answers;       ///< 95 % profile-likelihood interval: all answers independent
  Interval95 by_participants;  ///< 95 % interval from resampled participants; NaN if there is none
  EloRating elo;

  int comparisons() const { return chosen + other_chosen + ties; }
};

/// The circular triads of a participant who compared all stimuli with each other.
struct ParticipantTriads {
  std::size_t person = 0;
  CircularTriads triads;
};

/// Worths of all stimuli, or of all conditions (ComparedConditions), that were compared for one
/// item, by the model of Bradley and Terry with ties and order effect (bradley_terry.h). Of sets,
/// the comparisons are implied ones (implied_preferences); they depend on each other, so that the
/// tests are omitted (NaN), and so is transitivity, which holds within a set by construction.
struct PairWorth {
  std::string item;
  bool is_implied = false;  ///< whether the comparisons are implied by answers about sets
  int people = 0;
  int comparisons = 0;
  int ties = 0;
  int within_conditions = 0;           ///< further comparisons, of two stimuli of one condition
  std::vector<StimulusWorth> stimuli;  ///< in the order of the manifest
  std::vector<WorthContrast> contrasts;
  /// Whether the model has an order effect. It has none if it cannot be determined, for example if
  /// each pair was always shown with the same stimulus on the left.
  bool has_order = false;
  BradleyTerry fit;       ///< numbers of the model; its stimuli are those of `stimuli`
  Interval95 order_ends;  ///< 95 % interval of the order effect from resampled participants
  LikelihoodRatio order;  ///< test of the order effect
  double order_adjusted;  ///< p adjusted over all items
  LikelihoodRatio equal;  ///< test of equal worth
  double equal_adjusted;  ///< p adjusted over all items
  /// Whether the intervals that are reported are those from resampled participants.
  bool is_by_participants = false;
  int resamples = 0;         ///< number of resamples of participants
  int without_estimate = 0;  ///< of these, those in which not all worths are finite
  TransitivityViolations transitivity;
  std::vector<ParticipantTriads> triads;

  /// Whether intervals are reported: of implied comparisons, which depend on each other, none that
  /// treat answers as independent.
  bool has_intervals() const { return is_by_participants || !is_implied; }

  /// The reported interval; NaN without one.
  Interval95 ends_of(const StimulusWorth& one) const {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    if (!has_intervals()) return {none, none};
    return is_by_participants ? one.by_participants : one.by_answers;
  }
};

/// With fewer participants, intervals from resampled participants are not reported: too few
/// different ones are drawn.
inline constexpr int fewest_resampled_people = 10;

/// How much is computed of worths.
struct WorthDetail {
  int resamples = 999;  ///< number of resamples of participants
  /// Only the worths and the planned contrasts: without pairs of conditions, profile-likelihood
  /// intervals, Elo ratings, transitivity and tests of equal worth and of the order effect.
  bool only_planned = false;
};

/// The worths for each item about which there are comparisons, sorted by item.
///
/// Reported intervals are those from resampled participants, because several answers of the same
/// participant are not independent: profile-likelihood intervals are then too short. They are
/// profile-likelihood intervals if there are fewer than fewest_resampled_people, if some of the
/// resampled intervals have no finite ends, or if several groups of stimuli have worths. The same
/// holds for contrasts, whose intervals are then Wald's instead of profile-likelihood intervals.
std::vector<PairWorth> worths_of(const AnswerSet& answer_set, const WorthDetail& detail = {});

/// Why there is no worth: "always chosen", "never chosen" …; empty if there is one.
std::string record_text(const StimulusWorth& one);

}  // namespace mien::pipeline

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/base/adaptive/quest_plus.h"
#include "pipeline/base/adaptive/staircase.h"
#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

/// What QUEST+ estimates: the values of the parameters of a logistic psychometric function of the
/// level, all equally probable before the first answer. Levels are those of QuestLevels::signed.
struct QuestGrid {
  std::vector<double> location, width, guess, lapse;

  friend bool operator==(const QuestGrid&, const QuestGrid&) = default;
};

/// When a track of QUEST+ ends: once the posterior standard deviation of the threshold, the level
/// with this proportion of positive answers (ThresholdPosterior), is at most `deviation`, or after
/// so many trials.
struct QuestEnd {
  double deviation = 0.0;
  double proportion = 0.75;
  int most_trials = 0;

  friend bool operator==(const QuestEnd&, const QuestEnd&) = default;
};

/// How the tracks of a questionnaire choose levels. Levels are numbered by their places in the grid
/// (AdaptiveLevels::grid), from 0, the hardest.
struct TrackProcedure {
  AdaptiveMethod method = AdaptiveMethod::quest;
  std::vector<std::string> levels;  ///< of each place, as stated in the manifest
  /// The levels as numbers that increase with ease: those of the manifest or, if lower levels are
  /// easier, their negatives.
  std::vector<double> ease;
  QuestGrid quest;              ///< of QUEST+ only
  std::optional<QuestEnd> end;  ///< of QUEST+ only; unset: tracks show all trials of the plan
  StaircaseSettings staircase;  ///< of staircases only: its levels are places of the grid
};

/// The procedure of a questionnaire with adaptive trials.
TrackProcedure track_procedure(const Manifest& manifest);

/// The psychometric functions that QUEST+ considers: 25 locations over the range of the levels, 7
/// widths from a twentieth to a half of it, in equal ratios, and lapse rates of 0, 0.02 and 0.05.
/// The guess rate is 0.5 in two-interval trials, otherwise 0 to 0.4 in steps of 0.1.
QuestGrid quest_grid(const std::vector<double>& ease, const TrialForm& form);

/// An answered trial of a track.
struct TrackAnswer {
  std::size_t place = 0;
  bool is_positive = false;  ///< right, "yes" or "different"

  friend bool operator==(const TrackAnswer&, const TrackAnswer&) = default;
};

/// Chooses the levels of the trials of a track.
class TrackLevels {
 public:
  explicit TrackLevels(const TrackProcedure& procedure);

  /// The place of the next level after these answers of a track; nullopt if the track has ended.
  std::optional<std::size_t> next(const std::vector<TrackAnswer>& answers) const;

  /// Whether a level may be shown next: it is that of `next` or, of QUEST+, its expected entropy
  /// exceeds the least by no more than 1e-9 nats, as rounding can make of equal ones.
  bool permits(const std::vector<TrackAnswer>& answers, std::size_t place) const;

  /// Whether a track may have ended, or not, after these answers: as `next` has it or, of QUEST+,
  /// if the standard deviation differs from that of its end by no more than rounding.
  bool permits_end(const std::vector<TrackAnswer>& answers, bool has_ended) const;

  /// The tables of QUEST+; only where this is the method.
  const QuestPlus& quest() const { return *quest_; }

 private:
  StaircaseRun run(const std::vector<TrackAnswer>& answers) const;
  /// Whether a track of QUEST+ has ended if its end has this standard deviation.
  bool has_ended(const std::vector<TrackAnswer>& answers, double deviation) const;
  Eigen::VectorXd entropies(const std::vector<TrackAnswer>& answers) const;

  StaircaseSettings staircase_;
  std::optional<QuestPlus> quest_;
  std::optional<QuestEnd> end_;
};

/// The answers as those of QUEST+.
std::vector<QuestAnswer> quest_answers(const std::vector<TrackAnswer>& answers);

/// The answers of a staircase, whose levels follow from them.
std::vector<bool> staircase_answers(const std::vector<TrackAnswer>& answers);

}  // namespace mien::pipeline

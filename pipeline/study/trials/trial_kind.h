#pragma once

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "pipeline/manifest/manifest.h"
#include "pipeline/manifest/ratings/answers/answer_row.h"
#include "pipeline/manifest/ratings/answers/trial_form.h"
#include "pipeline/manifest/ratings/scales/scales.h"

namespace mien::pipeline {

struct TrialKind;
extern const TrialKind rating_trials;

/// An item of a trial: a scale, or the item of the trial form (TrialForm), such as the choice of an
/// emotion. In matching trials, the item is the interface, and the stimulus is the target. In chain
/// trials, the item is the word, or empty if it is not known beforehand.
struct TrialItem {
  std::string item;      ///< id
  bool flipped = false;  ///< the high end is at the left

  friend bool operator==(const TrialItem&, const TrialItem&) = default;
};

/// What a trial of an adaptive track may show. Which level it is depends on the answers to earlier
/// trials of the track.
struct AdaptiveTrial {
  int track = 0;  ///< from 1; 0: the trial is not adaptive, or without the signal
  /// Of each level, from the hardest, the ids from left to right.
  std::vector<std::vector<std::string>> by_level;
  std::string positive;  ///< raw answer that is right, or says that the signal is there

  friend bool operator==(const AdaptiveTrial&, const AdaptiveTrial&) = default;
};

/// One page of a session.
struct Trial {
  int number = 0;  ///< from 1, counted over all blocks
  /// "practice", "main", or the level of the blocking factor; in a matching experiment, "practice",
  /// or the interface or target that the trials of the block share.
  std::string block;
  const TrialKind* kind = &rating_trials;  ///< for an attention check, the kind that it resembles
  /// One id, or several from left to right; none in an attention check, and in plans none where the
  /// level is not known yet (shown_at).
  std::vector<std::string> stimuli;
  std::string reference;         ///< reference stimulus shown in addition; empty if there is none
  std::vector<TrialItem> items;  ///< in page order
  bool practice = false;
  bool warm_up = false;
  bool is_check = false;  ///< an attention check, or a stimulus that is shown a second time
  /// In an attention check, the raw answer that passes; otherwise empty.
  std::string expected;
  /// The level of the adaptive factor that is shown, as stated in the manifest; empty if it is not
  /// known yet or there is none.
  std::string level = {};
  AdaptiveTrial adaptive = {};

  bool is_attention_check() const { return !expected.empty(); }
  bool is_adaptive() const { return adaptive.track > 0; }

  /// Whether it is neither practice, warm-up, an attention check nor a repetition.
  bool is_analysed() const { return !practice && !warm_up && !is_check; }

  /// The name of the kind in plans, on pages and in tables of answers.
  std::string_view kind_name() const;

  /// What is shown in addition to the first stimulus: the second of a pair, the others of a set,
  /// separated by spaces, or the reference; may be empty.
  std::string against() const;

  friend bool operator==(const Trial&, const Trial&) = default;
};

/// A rating scale as presented by the questionnaire. Raw answers are counted from the left,
/// regardless of which end of the scale is at the left: 1 … points, or 0 … 100 on a slider.
struct ResponseScale {
  int points = 5;
  bool slider = false;
  bool words = false;     ///< answered in free text, without a value on the scale
  double least = -2.0;    ///< value of the low end
  double most = 2.0;      ///< value of the high end
  std::string low, high;  ///< labels of the ends
  bool ties = false;      ///< two stimuli may be compared without a preference
  bool strength = false;  ///< a preference for one of two stimuli is slight or strong
  /// In continuous trials: seconds from the beginning of the film that means of traces leave out,
  /// and whether the marker begins at the low end, not in the middle.
  double lead_s = 0.0;
  bool starts_low = false;
};

/// Response scales by item.
using ResponseScales = std::map<std::string, ResponseScale>;

/// The scales of a manifest's questionnaire, by item.
ResponseScales response_scales_by_item(const Manifest& manifest);

/// The scale of an item; nullptr if the item is not a scale.
const ResponseScale* find_scale(const ResponseScales& scales, const std::string& item);

/// Range of the raw answers.
double least_raw(const ResponseScale& scale);
double most_raw(const ResponseScale& scale);

/// The value of a raw answer in the scale's own range. `flipped`: the high end was at the left.
double value_of_raw(const ResponseScale& scale, double raw, bool flipped);

/// The value rounded to six decimals, as written by pages and servers.
double written_value_of_raw(const ResponseScale& scale, double raw, bool flipped);

/// The raw answer nearest to a value, clamped to the range.
double raw_of_value(const ResponseScale& scale, double value, bool flipped);

/// An item of a trial with its scale and choices. The referenced objects must outlive it.
struct Question {
  const Trial& trial;
  const TrialItem& item;
  const ResponseScale* scale;               ///< nullptr if the item is not a scale
  const std::vector<std::string>& choices;  ///< ids of the offered choices, in page order
};

/// A response to one item, as sent by the page.
struct ItemResponse {
  std::string item;
  std::string value_raw;        ///< as text; numbers in their shortest form
  bool is_number = false;       ///< whether it was a JSON number
  std::optional<double> rt_ms;  ///< response time, ms
};

/// What a simulated participant perceives of one item of a trial.
struct SimulatedView {
  std::function<double(std::size_t)>
      opinion;  ///< value, on the item's scale, of the stimulus with this index in the trial; in
                ///< detection, its observation, in standard deviations
  /// The first stimulus's level of the factor that is named like the item, such as `emotion`.
  std::string shown;
  /// The participant recognises the shown level or, in grid trials, a hidden reference.
  bool is_recognised = false;
  double chance = 0.0;  ///< random number from 0 to 1 for the simulated response
  // In continuous trials:
  double film_seconds = 0.0;    ///< duration of the film
  double reaction_lag_s = 0.0;  ///< between what is seen and its rating
  std::vector<double> wander;   ///< deviation of each sample from the opinion, on the scale
  /// Where the opinion changes: seconds of the film, and by how much, on the scale.
  std::vector<std::pair<double, double>> changes = {};
};

/// A kind of trial: defines how responses are checked, completed and simulated. An attention check
/// is a trial of the kind that it resembles, but without stimuli.
struct TrialKind {
  std::string_view name;
  const TrialForm* form =
      nullptr;  ///< the form in a manifest; nullptr for matching and chain trials

  /// Raw answers that an attention check may request.
  std::vector<std::string> (*attention_answers)(const Question&) = nullptr;
  /// The reason why a response is invalid; empty if it is valid.
  std::string (*fault)(const Question&, const ItemResponse&) = nullptr;
  /// Sets `value` and, for a rating, `pole_left` of a row from its raw answer (in continuous
  /// trials, `value` is the mean of the trace after the lead); in grid trials also the stimulus
  /// that the answer is about, what it is compared with, and the scale.
  void (*complete)(const Question&, AnswerRow& row) = nullptr;
  /// The reason why the responses to the items of a trial contradict each other; empty if they do
  /// not. nullptr if they cannot.
  std::string (*contradiction)(const std::vector<ItemResponse>&) = nullptr;
  /// The raw answer of a simulated participant.
  std::string (*simulated)(const Question&, const SimulatedView&) = nullptr;
};

extern const TrialKind rating_trials;  ///< one stimulus, rated on scales
extern const TrialKind
    emotion_trials;                  ///< a forced choice of the emotion shown, and optional scales
extern const TrialKind pair_trials;  ///< two stimuli: which is closer to the high end of each scale
extern const TrialKind same_different_trials;  ///< two stimuli: are they the same?
extern const TrialKind yes_no_trials;          ///< one stimulus: is the signal present?
extern const TrialKind two_interval_trials;    ///< two stimuli in turn: which has the signal?
extern const TrialKind best_worst_trials;      ///< several stimuli: which is best, which is worst?
extern const TrialKind grid_trials;            ///< several stimuli, each rated from 0 to 100
extern const TrialKind continuous_trials;      ///< one stimulus, rated while it plays
/// A target motion matched with sliders; used only in matching experiments, with their own records.
extern const TrialKind matching_trials;
/// A step of a chain of motions; used only in adaptive experiments, with their own records.
extern const TrialKind chain_trials;

/// All kinds of trials.
inline constexpr std::array trial_kinds = {
    &rating_trials,     &emotion_trials,      &pair_trials,       &same_different_trials,
    &yes_no_trials,     &two_interval_trials, &best_worst_trials, &grid_trials,
    &continuous_trials, &matching_trials,     &chain_trials};

/// The kind of trial with that form.
const TrialKind& trial_kind_of(const TrialForm& form);

/// Sets the columns of a row of answers that describe its trial.
void set_trial_columns(const Trial& trial, AnswerRow& row);

/// An error message if the response is not one of `choices`; otherwise empty.
std::string choice_fault(const ItemResponse& response, const std::vector<std::string>& choices);

}  // namespace mien::pipeline

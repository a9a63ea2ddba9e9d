#pragma once

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/manifest/manifest.h"
#include "pipeline/manifest/ratings/answers/answer_row.h"
#include "pipeline/manifest/ratings/answers/trial_form.h"
#include "pipeline/manifest/ratings/scales/scales.h"

namespace mien::pipeline {

struct TrialKind;
extern const TrialKind rating_trials;

/// An item of a trial: the id of a scale, or the item of the trial form (TrialForm), such as the
/// choice of an emotion. In matching trials it is the interface, and the stimulus is the target.
struct TrialItem {
  std::string item;
  bool flipped = false;  ///< the high end is at the left

  friend bool operator==(const TrialItem&, const TrialItem&) = default;
};

/// One page of a session.
struct Trial {
  int number = 0;     ///< from 1, through all blocks
  std::string block;  ///< "practice", "main", or the level of the blocking factor
  const TrialKind* kind = &rating_trials;  ///< of an attention check: the kind that it resembles
  std::vector<std::string>
      stimuli;            ///< one, or two of a pair from left to right; none in an attention check
  std::string reference;  ///< stimulus beside; empty for none
  std::vector<TrialItem> items;  ///< in the order on the page
  bool practice = false;
  bool warm_up = false;
  bool is_catch = false;  ///< an attention check, or a stimulus that is shown a second time
  /// In an attention check, the raw answer that passes; otherwise empty.
  std::string expected;

  bool is_attention_check() const { return !expected.empty(); }

  /// Whether it is neither practice, warm-up, an attention check nor a repetition.
  bool is_analysed() const { return !practice && !warm_up && !is_catch; }

  /// The name of its kind in plans, on pages and in tables of answers.
  std::string_view kind_name() const;

  /// The stimulus shown beside the first: the second of a pair, or the reference; or empty.
  const std::string& against() const { return stimuli.size() > 1 ? stimuli[1] : reference; }

  friend bool operator==(const Trial&, const Trial&) = default;
};

/// A rating scale as the questionnaire presents it. Raw answers count from the left, whichever end
/// of the scale is there: 1 … points, or 0 … 100 on a slider.
struct ResponseScale {
  int points = 5;
  bool slider = false;
  bool words = false;   ///< answered in free text, which has no value on the scale
  double least = -2.0;  ///< value of the low end
  double most = 2.0;
  std::string low, high;  ///< labels of the ends
};

/// By item.
using ResponseScales = std::map<std::string, ResponseScale>;

/// The scales of a manifest's questionnaire, by item.
ResponseScales response_scales_by_item(const Manifest& manifest);

/// The scale of an item; nullptr where the item is not a scale.
const ResponseScale* find_scale(const ResponseScales& scales, const std::string& item);

double least_raw(const ResponseScale& scale);
double most_raw(const ResponseScale& scale);

/// The value of a raw answer in the scale's own range; `flipped`: the high end was at the left.
double value_of_raw(const ResponseScale& scale, double raw, bool flipped);

/// The same rounded to six decimals, as pages and servers write it.
double written_value_of_raw(const ResponseScale& scale, double raw, bool flipped);

/// The raw answer nearest to a value, within the range.
double raw_of_value(const ResponseScale& scale, double value, bool flipped);

/// An item of a trial with its scale and choices. References must outlive it.
struct Question {
  const Trial& trial;
  const TrialItem& item;
  const ResponseScale* scale;  ///< nullptr where the item is not a scale
  const std::vector<std::string>&
      choices;  ///< ids of the offered choices, in the order on the page
};

/// A response to one item, as the page sends it.
struct ItemResponse {
  std::string item;
  std::string value_raw;   ///< as text; of numbers the shortest
  bool is_number = false;  ///< it was a JSON number
  std::optional<double> rt_ms;
};

/// What a simulated participant perceives of one item of a trial.
struct SimulatedView {
  std::function<double(std::size_t)>
      opinion;                 ///< value on the scale, of a stimulus by its index in the trial
  std::string shown;           ///< level of the first stimulus in the factor named like the item
  bool is_recognised = false;  ///< the participant recognises the shown level
  double chance = 0.0;         ///< 0 to 1
};

/// A kind of trial: what is asked and how responses are checked, completed and simulated. An
/// attention check is a trial of the same kind without stimuli.
struct TrialKind {
  std::string_view name;
  const TrialForm* form = nullptr;  ///< its form in a manifest; nullptr for matching trials

  /// Raw answers that an attention check may request.
  std::vector<std::string> (*attention_answers)(const Question&) = nullptr;
  /// Why a response is invalid; empty where it is valid.
  std::string (*fault)(const Question&, const ItemResponse&) = nullptr;
  /// Fills in value and pole_left from the raw answer of a row.
  void (*complete)(const Question&, AnswerRow& row) = nullptr;
  /// The raw answer of a simulated participant.
  std::string (*simulated)(const Question&, const SimulatedView&) = nullptr;
};

extern const TrialKind rating_trials;  ///< one stimulus, rated on scales
extern const TrialKind
    emotion_trials;                  ///< a forced choice of the emotion shown, and optional scales
extern const TrialKind pair_trials;  ///< two stimuli: which is closer to the high end of each scale
/// A target motion matched with sliders; used only in matching experiments, with their own records.
extern const TrialKind matching_trials;

/// All kinds of trials.
inline constexpr std::array trial_kinds = {&rating_trials, &emotion_trials, &pair_trials,
                                           &matching_trials};

/// The kind of trials with that form.
const TrialKind& trial_kind_of(const TrialForm& form);

/// Sets the columns of a row of answers that describe its trial.
void set_trial_columns(const Trial& trial, AnswerRow& row);

/// A fault where the response is not one of `choices`; otherwise empty.
std::string choice_fault(const ItemResponse& response, const std::vector<std::string>& choices);

}  // namespace mien::pipeline

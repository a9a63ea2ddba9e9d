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

/// One question of a trial: a scale by its id, or the own item of the form of trials (TrialForm).
/// Of a trial of matching: the interface, whose stimulus is the target.
struct AskedItem {
  std::string item;
  bool flipped = false;  ///< the high end is at the left

  friend bool operator==(const AskedItem&, const AskedItem&) = default;
};

/// One page of a session.
struct Trial {
  int number = 0;     ///< from 1, through all blocks
  std::string block;  ///< "practice", "main", or the level of the blocking factor
  const TrialKind* kind = &rating_trials;  ///< of a check: the kind that it looks like
  std::vector<std::string> stimuli;  ///< one; two of a pair, from left to right; none of a check
  std::string reference;             ///< stimulus beside; empty for none
  std::vector<AskedItem> items;      ///< in the order in which they stand there
  bool practice = false;
  bool warm_up = false;
  bool is_catch = false;  ///< an attention check, or a stimulus that is shown a second time
  /// Of an attention check: the raw answer that passes. Else empty.
  std::string expected;

  bool is_attention_check() const { return !expected.empty(); }

  /// Neither practice nor warm-up nor a check.
  bool is_analysed() const { return !practice && !warm_up && !is_catch; }

  /// What plans, pages and answers call its kind.
  std::string_view kind_name() const;

  /// What stands beside the first stimulus: the other one of a pair, or the reference. May be
  /// empty.
  const std::string& against() const { return stimuli.size() > 1 ? stimuli[1] : reference; }

  friend bool operator==(const Trial&, const Trial&) = default;
};

/// A scale, and how it is answered. Raw answers go from the left, whichever end of the scale is
/// there: 1 … points, or 0 … 100 of a slider.
struct AskedScale {
  int points = 5;
  bool slider = false;
  bool words = false;   ///< free words, which lie nowhere on the scale
  double least = -2.0;  ///< the answer that means the low end
  double most = 2.0;
  std::string low, high;  ///< words for the ends
};

/// By item.
using AskedScales = std::map<std::string, AskedScale>;

/// All scales that a manifest's questionnaire asks.
AskedScales asked_scales_by_item(const Manifest& manifest);

/// The scale of an item; nullptr where the item is none.
const AskedScale* find_scale(const AskedScales& scales, const std::string& item);

double least_raw(const AskedScale& scale);
double most_raw(const AskedScale& scale);

/// The answer in the scale's own range, its high end being the most.
double value_of_raw(const AskedScale& scale, double raw, bool flipped);

/// The same with the six decimals that pages and servers write.
double written_value_of_raw(const AskedScale& scale, double raw, bool flipped);

/// The raw answer nearest to a value, within the range.
double raw_of_value(const AskedScale& scale, double value, bool flipped);

/// An item of a trial, with all that says how it may be answered. A view.
struct Question {
  const Trial& trial;
  const AskedItem& item;
  const AskedScale* scale;                  ///< nullptr where the item is none
  const std::vector<std::string>& choices;  ///< ids of what is offered, as it stands there
};

/// An answer to one item as a page gives it.
struct GivenResponse {
  std::string item;
  std::string value_raw;   ///< as text; of numbers the shortest
  bool is_number = false;  ///< it was given as a number
  std::optional<double> rt_ms;
};

/// What a simulated participant knows of one item of a trial.
struct SimulatedView {
  std::function<double(std::size_t)> opinion;  ///< where a stimulus of the trial lies on the scale
  std::string shown;     ///< level of the first stimulus in the factor that is named as the item
  bool is_seen = false;  ///< the participant recognises what is shown
  double chance = 0.0;   ///< 0 to 1
};

/// How the trials of one kind are asked and answered. An attention check is a trial of the same
/// kind without stimuli.
struct TrialKind {
  std::string_view name;
  const TrialForm* form = nullptr;  ///< how a manifest asks for it; nullptr where it does otherwise

  /// Raw answers of which a check may ask for one.
  std::vector<std::string> (*checkable)(const Question&) = nullptr;
  /// Why a page cannot have given this response; empty where it can.
  std::string (*fault)(const Question&, const GivenResponse&) = nullptr;
  /// Fills in what the raw answer of a row means: value and pole_left.
  void (*complete)(const Question&, AnswerRow& row) = nullptr;
  /// The raw answer of somebody simulated.
  std::string (*simulated)(const Question&, const SimulatedView&) = nullptr;
};

extern const TrialKind rating_trials;   ///< a stimulus, on scales
extern const TrialKind emotion_trials;  ///< which of a list a stimulus shows, and scales
extern const TrialKind pair_trials;     ///< which of two stimuli has more of each scale's high end
/// A motion that is matched with sliders: an experiment of its own, with its own records.
extern const TrialKind matching_trials;

/// All of them.
inline constexpr std::array trial_kinds = {&rating_trials, &emotion_trials, &pair_trials,
                                           &matching_trials};

/// The kind of this form.
const TrialKind& trial_kind_of(const TrialForm& form);

/// What a row of answers has of its trial.
void put_trial(const Trial& trial, AnswerRow& row);

/// "an answer is none of those that may be chosen", where it is none of these; else empty.
std::string choice_fault(const GivenResponse& response, const std::vector<std::string>& choices);

}  // namespace mien::pipeline

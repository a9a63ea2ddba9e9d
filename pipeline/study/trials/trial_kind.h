#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/manifest/ratings/answers/answer_row.h"
#include "pipeline/manifest/ratings/answers/trial_form.h"
#include "pipeline/study/trials/asked_scale.h"
#include "pipeline/study/trials/trial.h"

namespace mien::pipeline {

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

/// "an answer is none of those that may be chosen", where it is none of these; else empty.
std::string choice_fault(const GivenResponse& response, const std::vector<std::string>& choices);

}  // namespace mien::pipeline

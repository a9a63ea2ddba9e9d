#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "motion/text/words.h"

namespace mien::pipeline {

/// A form of trial as manifests and tables of answers see it: the value of a questionnaire's
/// `trials:` and the meaning of its answers. How they are checked, completed and simulated:
/// study/trials/trial_kind.h.
struct TrialForm {
  const char* name;                 ///< name in manifests, plans and answers
  const char* judged = "stimulus";  ///< noun for what is judged in one trial
  std::size_t stimuli = 1;          ///< number of stimuli judged in one trial
  std::string_view item;            ///< item asked before the scales; empty: only scales are asked
  bool offers_choices = false;      ///< `item` is answered with one of the questionnaire's choices
  bool is_on_scale = true;  ///< scales are answered between their ends, not by choosing a stimulus
  const char* key = "";     ///< key of a questionnaire that applies only to this form
};

inline constexpr TrialForm rating_form = {.name = "rating"};
inline constexpr TrialForm emotion_form = {
    .name = "emotion", .item = "emotion", .offers_choices = true, .key = "choices"};
inline constexpr TrialForm pair_form = {
    .name = "pair", .judged = "pair", .stimuli = 2, .is_on_scale = false, .key = "pairs"};

/// All forms. Their description in codebooks is trial_forms_meaning.
inline constexpr Words<const TrialForm*> trial_form_words = {{rating_form.name, &rating_form},
                                                             {emotion_form.name, &emotion_form},
                                                             {pair_form.name, &pair_form}};
inline constexpr char trial_forms_meaning[] =
    "rating, emotion (which of a list), pair (which of two) or attention";

/// The value of an answer to a pair that states no preference.
inline constexpr char tie_value[] = "tie";

/// The kind of an attention check's answer, for all forms of trials.
inline constexpr char attention_kind[] = "attention";

/// Returns the form of that name, or nullptr if there is none (also for attention checks).
inline const TrialForm* find_trial_form(std::string_view name) {
  return meaning_of(trial_form_words, name).value_or(nullptr);
}

/// Returns the valid kinds of answers in tables.
inline std::vector<std::string_view> answer_kinds() {
  std::vector<std::string_view> kinds;
  for (const auto& [name, form] : trial_form_words) kinds.emplace_back(name);
  kinds.emplace_back(attention_kind);
  return kinds;
}

}  // namespace mien::pipeline

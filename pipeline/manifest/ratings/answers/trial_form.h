#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "motion/text/words.h"

namespace mien::pipeline {

/// A kind of trial as far as manifests and tables of answers go: what `trials:` of a questionnaire
/// names, and what its answers mean. How it is asked and answered: study/trials/trial_kind.h.
struct TrialForm {
  const char* name;                  ///< in manifests, plans and answers
  const char* subject = "stimulus";  ///< what one trial is about
  std::size_t stimuli = 1;           ///< to be judged in one trial
  std::string_view item;             ///< asked before the scales; empty for scales alone
  bool offers_choices = false;       ///< `item` is answered with one of the questionnaire's choices
  bool is_on_scale = true;           ///< a scale is answered from end to end, not with a stimulus
  const char* key = "";              ///< of a questionnaire, without meaning in other trials
};

inline constexpr TrialForm rating_form = {.name = "rating"};
inline constexpr TrialForm emotion_form = {
    .name = "emotion", .item = "emotion", .offers_choices = true, .key = "choices"};
inline constexpr TrialForm pair_form = {
    .name = "pair", .subject = "pair", .stimuli = 2, .is_on_scale = false, .key = "pairs"};

/// All of them. What the codebook says of them: trial_forms_meaning.
inline constexpr Words<const TrialForm*> trial_form_words = {{rating_form.name, &rating_form},
                                                             {emotion_form.name, &emotion_form},
                                                             {pair_form.name, &pair_form}};
inline constexpr char trial_forms_meaning[] =
    "rating, emotion (which of a list), pair (which of two) or attention";

/// The kind of an attention check's answer, whatever the trials are that it looks like.
inline constexpr char attention_kind[] = "attention";

/// The form of that name; nullptr for none, and so for an attention check.
inline const TrialForm* find_trial_form(std::string_view name) {
  return meaning_of(trial_form_words, name).value_or(nullptr);
}

/// What the kind of an answer may be, in tables.
inline std::vector<std::string_view> answer_kinds() {
  std::vector<std::string_view> kinds;
  for (const auto& [name, form] : trial_form_words) kinds.emplace_back(name);
  kinds.emplace_back(attention_kind);
  return kinds;
}

}  // namespace mien::pipeline

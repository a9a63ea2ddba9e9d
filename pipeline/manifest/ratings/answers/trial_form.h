#pragma once

#include <algorithm>
#include <array>
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
  const char* judged = "stimulus";  ///< noun for what is judged in one trial: stimulus, pair or set
  /// Number of stimuli judged in one trial; of sets, the least that a questionnaire may state.
  std::size_t stimuli = 1;
  std::string_view item;        ///< item asked before the scales; empty: only scales are asked
  bool offers_choices = false;  ///< `item` is answered with one of the questionnaire's choices
  bool is_on_scale = true;  ///< scales are answered between their ends, not by choosing a stimulus
  /// Only `item` is asked, and answers are right or wrong: each trial is a signal or a noise trial,
  /// and the result is the sensitivity d′.
  bool is_detection = false;
  bool is_set = false;      ///< the questionnaire states the number of stimuli
  bool is_in_turn = false;  ///< the stimuli are always shown one after the other
  /// The manifest states which stimuli are a set; each of them is rated, in a place of its own.
  bool is_grid = false;
  bool is_on_slider = false;  ///< scales are always answered on sliders from 0 to 100
  /// A scale is rated while the film plays; each trial asks one scale.
  bool is_continuous = false;
  /// Keys of a questionnaire that apply to this form and not to all others.
  std::array<std::string_view, 3> keys = {};

  /// Whether the stimuli of a trial are a set in which each has a place.
  bool has_places() const { return is_set || is_grid; }
  bool has_key(std::string_view key) const { return std::ranges::find(keys, key) != keys.end(); }
};

inline constexpr TrialForm rating_form = {.name = "rating"};
inline constexpr TrialForm emotion_form = {
    .name = "emotion", .item = "emotion", .offers_choices = true, .keys = {"choices"}};
inline constexpr TrialForm pair_form = {.name = "pair",
                                        .judged = "pair",
                                        .stimuli = 2,
                                        .is_on_scale = false,
                                        .keys = {"pairs", "preference"}};
/// Two stimuli: are they the same? Signal trials have two different stimuli, noise trials the same
/// one twice.
inline constexpr TrialForm same_different_form = {
    .name = "same_different",
    .judged = "pair",
    .stimuli = 2,
    .item = "same_different",
    .is_on_scale = false,
    .is_detection = true,
    .keys = {"pairs", "preference", "same_different"}};
/// One stimulus: is the signal present?
inline constexpr TrialForm yes_no_form = {.name = "yes_no",
                                          .item = "yes_no",
                                          .is_on_scale = false,
                                          .is_detection = true,
                                          .keys = {"signal"}};
/// Two-interval forced choice: which of two stimuli, one of them with the signal, has it?
inline constexpr TrialForm two_interval_form = {.name = "two_interval",
                                                .judged = "pair",
                                                .stimuli = 2,
                                                .item = "two_interval",
                                                .is_on_scale = false,
                                                .is_detection = true,
                                                .is_in_turn = true,
                                                .keys = {"pairs", "signal"}};
/// Best–worst scaling: which of a set of stimuli is best, and which is worst, with respect to each
/// scale (best_worst_item.h).
inline constexpr TrialForm best_worst_form = {.name = "best_worst",
                                              .judged = "set",
                                              .stimuli = 3,
                                              .is_on_scale = false,
                                              .is_set = true,
                                              .keys = {"best_worst"}};

/// Multiple stimuli with hidden reference and anchor (MUSHRA, ITU-R BS.1534-3): several stimuli,
/// each rated from 0 to 100 (grid_item.h).
inline constexpr TrialForm grid_form = {.name = "grid",
                                        .judged = "set",
                                        .stimuli = 2,
                                        .is_in_turn = true,
                                        .is_grid = true,
                                        .is_on_slider = true,
                                        .keys = {"grid"}};
/// One stimulus, rated on one scale from 0 to 100 while it plays (trace.h).
inline constexpr TrialForm continuous_form = {
    .name = "continuous", .is_on_slider = true, .is_continuous = true, .keys = {"continuous"}};

/// All forms. Their description in codebooks is trial_forms_meaning.
inline constexpr Words<const TrialForm*> trial_form_words = {
    {rating_form.name, &rating_form},
    {emotion_form.name, &emotion_form},
    {pair_form.name, &pair_form},
    {same_different_form.name, &same_different_form},
    {yes_no_form.name, &yes_no_form},
    {two_interval_form.name, &two_interval_form},
    {best_worst_form.name, &best_worst_form},
    {grid_form.name, &grid_form},
    {continuous_form.name, &continuous_form}};
inline constexpr char trial_forms_meaning[] =
    "rating, emotion (which of a list), pair (which of two), same_different (are two the same), "
    "yes_no (is a signal present), two_interval (which of two has the signal), "
    "best_worst (which of a set is best and worst), "
    "grid (each of a set, rated from 0 to 100), continuous (rated from 0 to 100 while it plays) or "
    "attention";

/// The value of an answer to a pair that states no preference.
inline constexpr char tie_value[] = "tie";

/// Values of answers to same–different and yes–no trials that count as hits or false alarms.
inline constexpr char different_answer[] = "different";
inline constexpr char yes_answer[] = "yes";

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

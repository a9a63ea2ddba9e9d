#pragma once

#include <string>
#include <vector>

#include "pipeline/manifest/questionnaire.h"

namespace mien::pipeline {

/// When participants see the result of a guess: directly after it (trial by trial), or only after
/// they have made a guess at the target with every interface.
enum class MatchingOrder { trial_by_trial, guesses_first };

inline constexpr Words<MatchingOrder> matching_order_words = {
    {"trial-by-trial", MatchingOrder::trial_by_trial},
    {"guesses-first", MatchingOrder::guesses_first}};

/// A matching experiment: participants adjust the sliders of one or more interfaces until a motion
/// matches a target as closely as possible. The experiment does not affect the stimuli.
struct Matching {
  LocalText title;                           ///< empty: the study's name
  PageLanguage language;                     ///< of the interface and of the ends of adjectives
  OwnTexts texts;                            ///< of the interface, in place of the built-in ones
  int participants = 0;                      ///< planned number
  TextSource consent, instructions, ending;  ///< empty: not given
  std::vector<std::string> targets;  ///< stimulus ids; empty: all stimuli with the role of a target
                                     ///< that are not used for practice
  std::vector<std::string> practice;  ///< stimulus ids, shown before all others
  std::vector<std::string> interfaces = {"adjectives", "features", "weights"};
  MatchingOrder order = MatchingOrder::trial_by_trial;
  std::vector<std::string> primary;   ///< adjectives shown initially; empty: the scales' groups, or
                                      ///< all adjectives if there are none
  std::vector<std::string> offered;   ///< adjectives that may be added; empty: all that are rated
  std::vector<std::string> features;  ///< features shown initially; empty: the four groups
  double limit_s = 300.0;             ///< time limit for a match, after the guess
  double threshold_m = 0.06;          ///< distance D below which a motion matches
  bool shows_distance = true;         ///< show the distance while sliders are moved
  bool shows_examples = false;        ///< show the examples one after the other next to the task
  std::string target_colour = "#2e8b57";
  std::string created_colour = "#3465c8";
  Phones phones = Phones::refused;
  std::vector<Demographic> demographics;
};

void fields_of(auto&& field, MaybeConst<Matching> auto& matching) {
  field.by("title", matching.title, concerns::nothing, LocalTextForm());
  field.by("language", matching.language, concerns::nothing, PageLanguageForm());
  field.by("texts", matching.texts, concerns::nothing, OwnTextsForm());
  field("participants", matching.participants, concerns::required);
  field.by("consent", matching.consent, concerns::nothing, TextForm());
  field.by("instructions", matching.instructions, concerns::nothing, TextForm());
  field.by("ending", matching.ending, concerns::nothing, TextForm());
  field("targets", matching.targets, concerns::nothing);
  field("practice", matching.practice, concerns::nothing);
  field("interfaces", matching.interfaces, concerns::nothing);
  field("order", matching.order, concerns::nothing, matching_order_words);
  field("primary", matching.primary, concerns::nothing);
  field("pairs_offered", matching.offered, concerns::nothing);
  field("features", matching.features, concerns::nothing);
  field("limit_s", matching.limit_s, concerns::nothing);
  field("threshold_m", matching.threshold_m, concerns::nothing);
  field("show_distance", matching.shows_distance, concerns::nothing);
  field("show_examples", matching.shows_examples, concerns::nothing);
  field("target_colour", matching.target_colour, concerns::nothing);
  field("created_colour", matching.created_colour, concerns::nothing);
  field("phones", matching.phones, concerns::nothing, phones_words);
  field.each("demographics", matching.demographics, concerns::nothing,
             [] { return Demographic(); });
}

}  // namespace mien::pipeline

#pragma once

#include <string>
#include <vector>

#include "pipeline/manifest/questionnaire.h"

namespace mien::pipeline {

/// When something is seen of a guess: at once, trial by trial, or once a guess has been made with
/// every interface at the same target.
enum class MatchingOrder { trial_by_trial, guesses_first };

inline constexpr Words<MatchingOrder> matching_order_words = {
    {"trial-by-trial", MatchingOrder::trial_by_trial},
    {"guesses-first", MatchingOrder::guesses_first}};

/// A matching experiment: participants bring a motion as near to a target as they can, with one
/// interface of sliders or another. It has no influence on the stimuli.
struct Matching {
  std::string title;  ///< empty: the study's name
  InterfaceLanguage language = InterfaceLanguage::english;
  int participants = 0;                      ///< planned
  TextSource consent, instructions, ending;  ///< empty where nothing is said
  std::vector<std::string> targets;          ///< stimuli; empty: those whose role is target
  std::vector<std::string> practice;         ///< stimuli, tried before all others
  std::vector<std::string> interfaces = {"adjectives", "features", "weights"};
  MatchingOrder order = MatchingOrder::trial_by_trial;
  std::vector<std::string>
      primary;  ///< adjectives shown at once; empty: the scales' groups, or all
  std::vector<std::string> offered;   ///< adjectives that may be added; empty: all rated pairs
  std::vector<std::string> features;  ///< shown at once; empty: the four groups
  double limit_s = 300.0;             ///< for a match, after the guess
  double threshold_m = 0.06;          ///< D below which a motion matches, metres
  bool shows_distance = true;         ///< while sliders are moved
  bool shows_examples = false;        ///< one after the other, beside the task
  std::string target_colour = "#2e8b57";
  std::string created_colour = "#3465c8";
  Phones phones = Phones::refused;
  std::vector<Demographic> demographics;
};

void fields_of(auto&& field, MaybeConst<Matching> auto& matching) {
  field("title", matching.title, concerns::nothing);
  field("language", matching.language, concerns::nothing, language_words);
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

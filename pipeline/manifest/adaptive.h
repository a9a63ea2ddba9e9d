#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pipeline/manifest/questionnaire.h"
#include "pipeline/manifest/recipe_space.h"

namespace mien::pipeline {

/// How answers lead through the space of motions: Gibbs sampling with people (Harrison, Marjieh and
/// others 2020) or Markov chain Monte Carlo with people (Sanborn and Griffiths 2008).
enum class ChainMethod { gibbs, mcmc };

inline constexpr Words<ChainMethod> chain_method_words = {{"gibbs", ChainMethod::gibbs},
                                                          {"mcmc", ChainMethod::mcmc}};

/// How the answers of several people to one step become the next point.
enum class StepAggregate { median, mean };

inline constexpr Words<StepAggregate> step_aggregate_words = {{"median", StepAggregate::median},
                                                              {"mean", StepAggregate::mean}};

/// The dimensions in which motions vary, all of one kind: groups of scales, rated scales, motion
/// features, weights of examples, principal components of the examples' features, or modifications
/// of one motion.
struct MotionSpace {
  enum class Kind { groups, scales, features, weights, components, recipe };

  Kind kind = Kind::groups;
  std::vector<std::string> names;  ///< empty: all of that kind; components and recipes have none
  int components = 0;              ///< number of components
  RecipeSpace recipe;              ///< of modifications only

  friend bool operator==(const MotionSpace&, const MotionSpace&) = default;
};

inline constexpr Words<MotionSpace::Kind> space_words = {
    {"groups", MotionSpace::Kind::groups},         {"scales", MotionSpace::Kind::scales},
    {"features", MotionSpace::Kind::features},     {"weights", MotionSpace::Kind::weights},
    {"components", MotionSpace::Kind::components}, {"recipe", MotionSpace::Kind::recipe}};

/// `space: {groups: all}`, `space: {features: [step-length, head-tilt]}`,
/// `space: {components: 3}`, `space: {recipe: {of: normal, emotions: {sad: [0, 1.5]}}}`.
struct MotionSpaceForm {
  static void read(const DocumentValue& given, MotionSpace& space);
  static nlohmann::ordered_json write(const MotionSpace& space, const WritingOptions& how);
  static void walk(auto& names) {
    for (const auto& [word, kind] : space_words)
      if (kind != MotionSpace::Kind::recipe) names.add(std::string(word));
    RecipeSpace recipe;
    names("recipe", recipe, concerns::nothing);
  }
};

/// When the chains of a word end: once they agree, or at their greatest length.
struct ChainEnd {
  double r_hat = 1.1;  ///< they agree if R̂ is at most this in every dimension
  int at_least = 10;   ///< number of sweeps (choices in mcmc) of every chain before R̂ is computed
  int at_most = 40;    ///< greatest number of sweeps (choices)
};

void fields_of(auto&& field, MaybeConst<ChainEnd> auto& end) {
  field("r_hat", end.r_hat, concerns::required);
  field("at_least", end.at_least, concerns::nothing);
  field("at_most", end.at_most, concerns::required);
}

/// An adaptive experiment: chains of motions for each word, in which every step depends on the
/// answers before. The experiment does not affect the stimuli.
struct Adaptive {
  LocalText title;                           ///< empty: the study's name
  PageLanguage language;                     ///< of the pages
  OwnTexts texts;                            ///< of the pages, in place of the built-in ones
  int participants = 0;                      ///< planned number
  TextSource consent, instructions, ending;  ///< empty: not given
  ChainMethod method = ChainMethod::gibbs;
  DisplayedChoices words;  ///< what motions are to look like: ids and what is displayed
  MotionSpace space;
  int chains = 1;      ///< of each word: of each participant, or of all if across participants
  int iterations = 5;  ///< sweeps over all dimensions in Gibbs sampling; otherwise choices
  std::optional<ChainEnd> until;  ///< in place of `iterations`, only across participants
  /// Each step is answered by other participants than the one before; needs a server.
  bool across_participants = false;
  int people_per_step = 1;  ///< only across participants
  StepAggregate aggregate = StepAggregate::median;
  int trials_per_participant = 40;  ///< only across participants
  double answer_within_s = 180.0;   ///< after this, a step is given to another participant
  int practice = 2;                 ///< number of practice trials
  int attention_every = 0;          ///< mean number of trials between attention checks; 0: none
  int max_failed_checks = 1;        ///< participants who fail more are replaced
  double deviation = 0.15;          ///< of proposals in mcmc, as a share of the ranges
  std::string colour = "#3465c8";   ///< of the figure
  Phones phones = Phones::refused;
  std::vector<Demographic> demographics;
};

void fields_of(auto&& field, MaybeConst<Adaptive> auto& adaptive) {
  field.by("title", adaptive.title, concerns::nothing, LocalTextForm());
  field.by("language", adaptive.language, concerns::nothing, PageLanguageForm());
  field.by("texts", adaptive.texts, concerns::nothing, OwnTextsForm());
  field("participants", adaptive.participants, concerns::required);
  field.by("consent", adaptive.consent, concerns::nothing, TextForm());
  field.by("instructions", adaptive.instructions, concerns::nothing, TextForm());
  field.by("ending", adaptive.ending, concerns::nothing, TextForm());
  field("method", adaptive.method, concerns::required, chain_method_words);
  field.by("words", adaptive.words, concerns::required, ChoicesForm());
  field.by("space", adaptive.space, concerns::required, MotionSpaceForm());
  field("chains", adaptive.chains, concerns::nothing);
  field("iterations", adaptive.iterations, concerns::nothing);
  field("until", adaptive.until, concerns::nothing);
  field("across_participants", adaptive.across_participants, concerns::nothing);
  field("people_per_step", adaptive.people_per_step, concerns::nothing);
  field("aggregate", adaptive.aggregate, concerns::nothing, step_aggregate_words);
  field("trials_per_participant", adaptive.trials_per_participant, concerns::nothing);
  field("answer_within_s", adaptive.answer_within_s, concerns::nothing);
  field("practice", adaptive.practice, concerns::nothing);
  field.group("attention", [&](auto& checks) {
    checks("every", adaptive.attention_every, concerns::nothing);
    checks("max_failed_checks", adaptive.max_failed_checks, concerns::nothing);
  });
  field("deviation", adaptive.deviation, concerns::nothing);
  field("colour", adaptive.colour, concerns::nothing);
  field("phones", adaptive.phones, concerns::nothing, phones_words);
  field.each("demographics", adaptive.demographics, concerns::nothing,
             [] { return Demographic(); });
}

}  // namespace mien::pipeline

#pragma once

#include <string>
#include <utility>
#include <vector>

#include "pipeline/base/documents/concerns.h"
#include "pipeline/manifest/questionnaire_forms.h"
#include "pipeline/manifest/ratings/answers/trial_form.h"

namespace mien::pipeline {

enum class InterfaceLanguage { english, japanese };
enum class StartsAt { none, middle };
enum class PoleSide { random, fixed };
enum class Watching { full, free };
enum class ShownAs { video, turn };
enum class Phones { served, refused };
enum class TestCorrection { holm, benjamini_hochberg, none };

inline constexpr Words<InterfaceLanguage> language_words = {{"en", InterfaceLanguage::english},
                                                            {"ja", InterfaceLanguage::japanese}};
inline constexpr Words<StartsAt> starts_at_words = {{"none", StartsAt::none},
                                                    {"middle", StartsAt::middle}};
inline constexpr Words<PoleSide> pole_side_words = {{"random", PoleSide::random},
                                                    {"fixed", PoleSide::fixed}};
inline constexpr Words<Watching> watching_words = {{"full", Watching::full},
                                                   {"free", Watching::free}};
inline constexpr Words<ShownAs> shown_as_words = {{"video", ShownAs::video},
                                                  {"turn", ShownAs::turn}};
inline constexpr Words<Phones> phones_words = {{"served", Phones::served},
                                               {"refused", Phones::refused}};
inline constexpr Words<TestCorrection> correction_words = {
    {"holm", TestCorrection::holm},
    {"bh", TestCorrection::benjamini_hochberg},
    {"none", TestCorrection::none}};

/// How a scale is answered: on points, unless it is a slider or in words.
struct AnswerSettings {
  int points = 5;       ///< from one end of a scale to the other, both counted
  bool slider = false;  ///< raw answers 0 … 100 from the left
  bool words = false;   ///< free words; the raw answer is the text
  bool anchors = true;  ///< each point has its words ("very sad"), and not the ends alone
  StartsAt starts_at = StartsAt::none;  ///< what is chosen before an answer is given
  PoleSide side = PoleSide::random;     ///< of the high end: by participant and item, or right
  friend bool operator==(const AnswerSettings&, const AnswerSettings&) = default;
};

void fields_of(auto&& field, MaybeConst<AnswerSettings> auto& answer) {
  field("points", answer.points, concerns::nothing);
  field("slider", answer.slider, concerns::nothing);
  field("words", answer.words, concerns::nothing);
  field("anchors", answer.anchors, concerns::nothing);
  field("default", answer.starts_at, concerns::nothing, starts_at_words);
  field("side", answer.side, concerns::nothing, pole_side_words);
}

/// A question about the participant.
struct Demographic {
  std::string id;       ///< column of the table of participants
  std::string ask;      ///< the question
  AnswerChoice answer;  ///< a number, a text, or one of a list
  bool required = false;
};

void fields_of(auto&& field, MaybeConst<Demographic> auto& question) {
  field("id", question.id, concerns::required);
  field("ask", question.ask, concerns::required);
  field.by("answer", question.answer, concerns::required, AnswerChoiceForm());
  field("required", question.required, concerns::nothing);
}

/// What a session is reckoned to take beside its videos; seconds.
struct Pace {
  double words_per_minute = 200.0;  ///< of texts that are read
  double answer = 3.5;              ///< an item of a trial, read and answered
  double comment = 5.0;             ///< a trial with a place for one, on the average
  double between = 1.5;             ///< from one trial to the next
  double demographic = 8.0;         ///< a question about the participant
  friend bool operator==(const Pace&, const Pace&) = default;
};

void fields_of(auto&& field, MaybeConst<Pace> auto& pace) {
  field("words_per_minute", pace.words_per_minute, concerns::nothing);
  field("answer", pace.answer, concerns::nothing);
  field("comment", pace.comment, concerns::nothing);
  field("between", pace.between, concerns::nothing);
  field("demographic", pace.demographic, concerns::nothing);
}

/// What is said before the answers are seen about how they will be looked at.
struct AnalysisPlan {
  TextSource plan;      ///< in words; part of the preregistration
  double alpha = 0.05;  ///< level of every test
  TestCorrection correction = TestCorrection::holm;
  int max_failed_checks = 1;  ///< a participant who fails more attention checks is excluded
};

void fields_of(auto&& field, MaybeConst<AnalysisPlan> auto& analysis) {
  field.by("plan", analysis.plan, concerns::nothing, TextForm());
  field("alpha", analysis.alpha, concerns::nothing);
  field("correction", analysis.correction, concerns::nothing, correction_words);
  field("max_failed_checks", analysis.max_failed_checks, concerns::nothing);
}

/// The questions to participants about the stimuli of a manifest, in which order, and how it is
/// shown. It has no influence on the stimuli.
struct Questionnaire {
  std::string title;  ///< empty: the study's name
  InterfaceLanguage language =
      InterfaceLanguage::english;            ///< of the interface, and of the scales' ends
  int participants = 0;                      ///< planned
  TextSource consent, instructions, ending;  ///< empty where nothing is said
  std::string question;                      ///< above the items of a trial; empty for a usual one
  StimulusChoice stimuli;
  int per_participant = 0;                 ///< trials that are analysed; 0: all
  const TrialForm* trials = &rating_form;  ///< the question about a stimulus
  ScaleChoice scales;
  std::vector<std::pair<std::string, std::string>> choices;  ///< to choose from: id → as shown
  std::vector<std::vector<std::string>> pairs;  ///< of forms with two stimuli; empty: all
  AnswerSettings answer;
  TrialOrder order;
  std::vector<std::string> no_repeats;  ///< factors in which successive trials must differ
  std::vector<std::string> practice;    ///< stimuli of trials before the main part
  int warm_up = 0;          ///< trials more at the beginning of the main part, not analysed
  int attention_every = 0;  ///< a check after so many trials; 0: none
  int repeated = 0;         ///< catch trials: stimuli that are shown a second time
  Replays replays;
  Watching watch = Watching::full;
  bool comments = false;
  std::string reference;  ///< stimulus that is shown beside; empty for none
  ShownAs view = ShownAs::video;
  Phones phones = Phones::refused;
  std::vector<Demographic> demographics;
  Pace pace;
  AnalysisPlan analysis;
};

void fields_of(auto&& field, MaybeConst<Questionnaire> auto& questionnaire) {
  field("title", questionnaire.title, concerns::nothing);
  field("language", questionnaire.language, concerns::nothing, language_words);
  field("participants", questionnaire.participants, concerns::required);
  field.by("consent", questionnaire.consent, concerns::nothing, TextForm());
  field.by("instructions", questionnaire.instructions, concerns::nothing, TextForm());
  field.by("ending", questionnaire.ending, concerns::nothing, TextForm());
  field("question", questionnaire.question, concerns::nothing);
  field.by("stimuli", questionnaire.stimuli, concerns::nothing, StimulusChoiceForm());
  field("per_participant", questionnaire.per_participant, concerns::nothing);
  field("trials", questionnaire.trials, concerns::nothing, trial_form_words);
  field.by("scales", questionnaire.scales, concerns::nothing, ScaleChoiceForm());
  field.by("choices", questionnaire.choices, concerns::nothing, ChoicesForm());
  field("pairs", questionnaire.pairs, concerns::nothing);
  field("answer", questionnaire.answer, concerns::nothing);
  field.by("order", questionnaire.order, concerns::nothing, TrialOrderForm());
  field("no_repeats", questionnaire.no_repeats, concerns::nothing);
  field("practice", questionnaire.practice, concerns::nothing);
  field("warm_up", questionnaire.warm_up, concerns::nothing);
  field.group("attention", [&](auto& checks) {
    checks("every", questionnaire.attention_every, concerns::nothing);
  });
  field.group("catch",
              [&](auto& trials) { trials("repeat", questionnaire.repeated, concerns::nothing); });
  field.by("replays", questionnaire.replays, concerns::nothing, ReplaysForm());
  field("watch", questionnaire.watch, concerns::nothing, watching_words);
  field("comments", questionnaire.comments, concerns::nothing);
  field("reference", questionnaire.reference, concerns::nothing);
  field("view", questionnaire.view, concerns::nothing, shown_as_words);
  field("phones", questionnaire.phones, concerns::nothing, phones_words);
  field.each("demographics", questionnaire.demographics, concerns::nothing,
             [] { return Demographic(); });
  field("pace", questionnaire.pace, concerns::nothing);
  field("analysis", questionnaire.analysis, concerns::nothing);
}

}  // namespace mien::pipeline

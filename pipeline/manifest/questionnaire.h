#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "pipeline/base/documents/concerns.h"
#include "pipeline/manifest/adaptive_trials.h"
#include "pipeline/manifest/continuous.h"
#include "pipeline/manifest/factorial_plan.h"
#include "pipeline/manifest/grid.h"
#include "pipeline/manifest/questionnaire_forms.h"
#include "pipeline/manifest/ratings/answers/trial_form.h"
#include "pipeline/manifest/recruitment.h"
#include "pipeline/manifest/screening.h"

namespace mien::pipeline {

enum class StartsAt { none, middle };
enum class PoleSide { random, fixed };
enum class Watching { full, free };
enum class ShownAs { video, turn };
enum class Phones { served, refused };
enum class PairPresentation { together, in_turn };
enum class TestCorrection { holm, benjamini_hochberg, none };
enum class FlaggedAnswers { excluded, kept };

inline constexpr Words<StartsAt> starts_at_words = {{"none", StartsAt::none},
                                                    {"middle", StartsAt::middle}};
inline constexpr Words<PoleSide> pole_side_words = {{"random", PoleSide::random},
                                                    {"fixed", PoleSide::fixed}};
inline constexpr Words<Watching> watching_words = {{"full", Watching::full},
                                                   {"free", Watching::free}};
inline constexpr Words<ShownAs> shown_as_words = {{"video", ShownAs::video},
                                                  {"turn", ShownAs::turn}};
inline constexpr Words<PairPresentation> pair_presentation_words = {
    {"together", PairPresentation::together}, {"in_turn", PairPresentation::in_turn}};
inline constexpr Words<Phones> phones_words = {{"served", Phones::served},
                                               {"refused", Phones::refused}};
inline constexpr Words<TestCorrection> correction_words = {
    {"holm", TestCorrection::holm},
    {"bh", TestCorrection::benjamini_hochberg},
    {"none", TestCorrection::none}};

inline constexpr Words<FlaggedAnswers> flagged_answers_words = {
    {"excluded", FlaggedAnswers::excluded}, {"kept", FlaggedAnswers::kept}};

/// How a scale is answered: on discrete points by default, on a slider or in free words.
struct AnswerSettings {
  int points = 5;                       ///< number of points, including both ends
  bool slider = false;                  ///< raw answers are 0 … 100 from left to right
  bool words = false;                   ///< free words; the raw answer is the text
  LocalWords suggest;                   ///< words that are suggested while one types
  bool anchors = true;                  ///< every point is labelled ("very sad"), not only the ends
  StartsAt starts_at = StartsAt::none;  ///< initial state of a scale
  PoleSide side = PoleSide::random;     ///< side of the high end: varies between participants and
                                        ///< scales, or is always the right
  friend bool operator==(const AnswerSettings&, const AnswerSettings&) = default;
};

void fields_of(auto&& field, MaybeConst<AnswerSettings> auto& answer) {
  field("points", answer.points, concerns::nothing);
  field("slider", answer.slider, concerns::nothing);
  field("words", answer.words, concerns::nothing);
  field.by("suggest", answer.suggest, concerns::nothing, LocalWordsForm());
  field("anchors", answer.anchors, concerns::nothing);
  field("default", answer.starts_at, concerns::nothing, starts_at_words);
  field("side", answer.side, concerns::nothing, pole_side_words);
}

/// How pairs are shown and answered.
struct PreferenceSettings {
  bool ties = false;                                    ///< "no difference" may be answered
  bool strength = false;                                ///< a preference is slight or strong
  PairPresentation shown = PairPresentation::together;  ///< side by side, or one after the other
  /// If no pairs are listed: only stimuli with equal levels of these factors form pairs.
  std::vector<std::string> alike;
  friend bool operator==(const PreferenceSettings&, const PreferenceSettings&) = default;
};

void fields_of(auto&& field, MaybeConst<PreferenceSettings> auto& preference) {
  field("ties", preference.ties, concerns::nothing);
  field("strength", preference.strength, concerns::nothing);
  field("shown", preference.shown, concerns::nothing, pair_presentation_words);
  field("alike", preference.alike, concerns::nothing);
}

/// How the pairs of same–different trials are made up.
struct SameDifferentSettings {
  double same = 0.5;  ///< share of the trials in which a stimulus is shown twice, above 0, below 1
  /// If not empty and no pairs are listed: the different pairs are those whose stimuli have
  /// different levels of this factor and equal levels of all other factors.
  std::string differ_in;
  friend bool operator==(const SameDifferentSettings&, const SameDifferentSettings&) = default;
};

void fields_of(auto&& field, MaybeConst<SameDifferentSettings> auto& pairs) {
  field("same", pairs.same, concerns::nothing);
  field("differ_in", pairs.differ_in, concerns::nothing);
}

/// The sets of stimuli of best–worst trials.
struct BestWorstSettings {
  int size = 4;  ///< number of stimuli in a set, 3 to 6
  int sets = 0;  ///< number of different sets; 0: as many as stimuli
  friend bool operator==(const BestWorstSettings&, const BestWorstSettings&) = default;
};

void fields_of(auto&& field, MaybeConst<BestWorstSettings> auto& sets) {
  field("size", sets.size, concerns::nothing);
  field("sets", sets.sets, concerns::nothing);
}

/// The size of stimuli on the screen.
struct DisplaySettings {
  DisplaySize size;           ///< of the width of each video
  double distance_cm = 60.0;  ///< between the eyes and the screen, as participants are told
  bool blind_spot = false;    ///< participants measure the distance with the blind spot of the eye
};

void fields_of(auto&& field, MaybeConst<DisplaySettings> auto& display) {
  field.by("size", display.size, concerns::nothing, DisplaySizeForm());
  field("distance_cm", display.distance_cm, concerns::nothing);
  field("blind_spot", display.blind_spot, concerns::nothing);
}

/// A question about the participant.
struct Demographic {
  std::string id;       ///< column in the table of participants
  LocalText ask;        ///< the question
  AnswerChoice answer;  ///< a number, a text, or one of several choices
  bool required = false;
};

void fields_of(auto&& field, MaybeConst<Demographic> auto& question) {
  field("id", question.id, concerns::required);
  field.by("ask", question.ask, concerns::required, LocalTextForm());
  field.by("answer", question.answer, concerns::required, AnswerChoiceForm());
  field("required", question.required, concerns::nothing);
}

/// What the estimated duration of a session contains in addition to its videos: times in seconds,
/// and the reading speed.
struct Pace {
  double words_per_minute = 200.0;  ///< reading speed for texts
  double answer = 3.5;              ///< to read and answer an item of a trial
  double comment = 5.0;             ///< mean time for comments per trial, if comments are allowed
  double between = 1.5;             ///< between successive trials
  double demographic = 8.0;         ///< per question about the participant
  friend bool operator==(const Pace&, const Pace&) = default;
};

void fields_of(auto&& field, MaybeConst<Pace> auto& pace) {
  field("words_per_minute", pace.words_per_minute, concerns::nothing);
  field("answer", pace.answer, concerns::nothing);
  field("comment", pace.comment, concerns::nothing);
  field("between", pace.between, concerns::nothing);
  field("demographic", pace.demographic, concerns::nothing);
}

/// Rules, stated before the study, by which answers and participants are flagged. An unset rule is
/// not applied.
struct QualityRules {
  std::optional<double> min_rt_ms;    ///< answers that took less are flagged
  std::optional<double> max_rt_ms;    ///< answers that took longer are flagged
  std::optional<double> max_blur_ms;  ///< answers of trials in which the window was left longer
  std::optional<int> max_longstring;  ///< participants with more equal raw answers in succession
  std::optional<double> min_sd;       ///< participants whose raw answers vary less
  std::string repeated_by;            ///< URL parameter: later sessions with the same value
  FlaggedAnswers flagged = FlaggedAnswers::excluded;  ///< whether the analysis uses what is flagged
  /// Whether the analysis uses participants whom the post-screening of grid trials flags.
  FlaggedAnswers post_screening = FlaggedAnswers::kept;
};

void fields_of(auto&& field, MaybeConst<QualityRules> auto& rules) {
  field("min_rt_ms", rules.min_rt_ms, concerns::nothing);
  field("max_rt_ms", rules.max_rt_ms, concerns::nothing);
  field("max_blur_ms", rules.max_blur_ms, concerns::nothing);
  field("max_longstring", rules.max_longstring, concerns::nothing);
  field("min_sd", rules.min_sd, concerns::nothing);
  field("repeated_by", rules.repeated_by, concerns::nothing);
  field("flagged", rules.flagged, concerns::nothing, flagged_answers_words);
  field("post_screening", rules.post_screening, concerns::nothing, flagged_answers_words);
}

/// The preregistered analysis plan.
struct AnalysisPlan {
  TextSource plan;      ///< text of the plan, included in the preregistration
  double alpha = 0.05;  ///< significance level of each test
  TestCorrection correction = TestCorrection::holm;
  /// Participants who fail more attention checks than this are excluded.
  int max_failed_checks = 1;
  /// Seconds by which traces of continuous trials are moved back, so that a rating is about the
  /// moment that it responds to.
  double lag = 0.0;
  FactorialPlan factorial;
  QualityRules quality;
};

void fields_of(auto&& field, MaybeConst<AnalysisPlan> auto& analysis) {
  field.by("plan", analysis.plan, concerns::nothing, TextForm());
  field("alpha", analysis.alpha, concerns::nothing);
  field("correction", analysis.correction, concerns::nothing, correction_words);
  field("max_failed_checks", analysis.max_failed_checks, concerns::nothing);
  field("lag", analysis.lag, concerns::nothing);
  field("factors", analysis.factorial.factors, concerns::nothing);
  field("between", analysis.factorial.between, concerns::nothing);
  field.each("contrasts", analysis.factorial.contrasts, concerns::nothing,
             [] { return PlannedContrast(); });
  field("random_slopes", analysis.factorial.random_slopes, concerns::nothing);
  field("quality", analysis.quality, concerns::nothing);
}

/// The questions asked about the stimuli of a manifest, their order and their presentation. It does
/// not affect the stimuli.
struct Questionnaire {
  LocalText title;                           ///< empty: the study's name
  PageLanguage language;                     ///< of the interface and of the scales' labels
  OwnTexts texts;                            ///< of the interface, in place of the built-in ones
  int participants = 0;                      ///< planned number
  TextSource consent, instructions, ending;  ///< empty: not given
  std::string consent_version;               ///< as approved by an ethics committee, say; or empty
  TextSource debriefing;  ///< shown after the last answer and after withdrawal; empty: none
  LocalText question;     ///< shown above the items of a trial; empty: a default text
  StimulusChoice stimuli;
  int per_participant = 0;                 ///< number of analysed trials per participant; 0: all
  const TrialForm* trials = &rating_form;  ///< form of the trials
  ScaleChoice scales;
  DisplayedChoices choices;  ///< possible answers; empty: the levels of the factor emotion
  /// Stimuli of each pair, for forms with two stimuli; empty: all pairs that suit the form.
  std::vector<std::vector<std::string>> pairs;
  PreferenceSettings preference;         ///< only for forms with two stimuli
  SameDifferentSettings same_different;  ///< only for same–different trials
  BestWorstSettings best_worst;          ///< only for best–worst trials
  GridSettings grid;                     ///< only for grid trials
  ContinuousSettings continuous;         ///< only for continuous trials
  StimulusChoice signal;  ///< of detection (yes_no, two_interval): the stimuli with the signal
  AdaptiveTrialSettings adaptive;  ///< of detection and same–different trials
  AnswerSettings answer;
  TrialOrder order;
  std::vector<std::string> no_repeats;  ///< factors in which successive trials must differ
  std::vector<std::string> practice;    ///< stimuli of the practice trials
  int warm_up = 0;  ///< additional trials at the beginning of the main part that are not analysed
  int attention_every = 0;  ///< mean number of trials between attention checks; 0: no checks
  int repeated = 0;         ///< number of stimuli that are shown a second time (test-retest)
  Replays replays;
  Watching watch = Watching::full;
  bool comments = false;
  std::string reference;  ///< id of the stimulus shown next to the rated one; empty for none
  ShownAs view = ShownAs::video;
  DisplaySettings display;
  Phones phones = Phones::refused;
  Screening screening;
  std::vector<Demographic> demographics;
  Recruitment recruitment;
  Pace pace;
  AnalysisPlan analysis;
};

void fields_of(auto&& field, MaybeConst<Questionnaire> auto& questionnaire) {
  field.by("title", questionnaire.title, concerns::nothing, LocalTextForm());
  field.by("language", questionnaire.language, concerns::nothing, PageLanguageForm());
  field.by("texts", questionnaire.texts, concerns::nothing, OwnTextsForm());
  field("participants", questionnaire.participants, concerns::required);
  field.by("consent", questionnaire.consent, concerns::nothing, TextForm());
  field("consent_version", questionnaire.consent_version, concerns::nothing);
  field.by("instructions", questionnaire.instructions, concerns::nothing, TextForm());
  field.by("debriefing", questionnaire.debriefing, concerns::nothing, TextForm());
  field.by("ending", questionnaire.ending, concerns::nothing, TextForm());
  field.by("question", questionnaire.question, concerns::nothing, LocalTextForm());
  field.by("stimuli", questionnaire.stimuli, concerns::nothing, StimulusChoiceForm());
  field("per_participant", questionnaire.per_participant, concerns::nothing);
  field("trials", questionnaire.trials, concerns::nothing, trial_form_words);
  field.by("scales", questionnaire.scales, concerns::nothing, ScaleChoiceForm());
  field.by("choices", questionnaire.choices, concerns::nothing, ChoicesForm());
  field("pairs", questionnaire.pairs, concerns::nothing);
  field("preference", questionnaire.preference, concerns::nothing);
  field("same_different", questionnaire.same_different, concerns::nothing);
  field("best_worst", questionnaire.best_worst, concerns::nothing);
  field("grid", questionnaire.grid, concerns::nothing);
  field("continuous", questionnaire.continuous, concerns::nothing);
  field.by("signal", questionnaire.signal, concerns::nothing, StimulusChoiceForm());
  field("adaptive", questionnaire.adaptive, concerns::nothing);
  field("answer", questionnaire.answer, concerns::nothing);
  field.by("order", questionnaire.order, concerns::nothing, TrialOrderForm());
  field("no_repeats", questionnaire.no_repeats, concerns::nothing);
  field("practice", questionnaire.practice, concerns::nothing);
  field("warm_up", questionnaire.warm_up, concerns::nothing);
  field.group("attention", [&](auto& checks) {
    checks("every", questionnaire.attention_every, concerns::nothing);
  });
  field.group("retest",
              [&](auto& trials) { trials("repeat", questionnaire.repeated, concerns::nothing); });
  field.by("replays", questionnaire.replays, concerns::nothing, ReplaysForm());
  field("watch", questionnaire.watch, concerns::nothing, watching_words);
  field("comments", questionnaire.comments, concerns::nothing);
  field("reference", questionnaire.reference, concerns::nothing);
  field("view", questionnaire.view, concerns::nothing, shown_as_words);
  field("display", questionnaire.display, concerns::nothing);
  field("phones", questionnaire.phones, concerns::nothing, phones_words);
  field("screening", questionnaire.screening, concerns::nothing);
  field.each("demographics", questionnaire.demographics, concerns::nothing,
             [] { return Demographic(); });
  field("recruitment", questionnaire.recruitment, concerns::nothing);
  field("pace", questionnaire.pace, concerns::nothing);
  field("analysis", questionnaire.analysis, concerns::nothing);
}

}  // namespace mien::pipeline

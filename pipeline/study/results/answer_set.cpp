#include "pipeline/study/results/answer_set.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "motion/text/excerpt.h"
#include "pipeline/base/documents/fault.h"
#include "pipeline/base/documents/fault_list.h"
#include "pipeline/base/statistics/t_test.h"
#include "pipeline/manifest/adaptive_levels.h"
#include "pipeline/manifest/questionnaire_content.h"
#include "pipeline/manifest/ratings/answers/counted_answers.h"
#include "pipeline/manifest/ratings/answers/trial_form.h"
#include "pipeline/study/results/answer_collector.h"
#include "pipeline/study/results/grid_screening.h"
#include "pipeline/study/results/no_answers.h"

namespace mien::pipeline {

namespace {

/// Whether a factor describes how a stimulus was made, and not its actor or content.
bool is_making_factor(const std::string& factor) {
  constexpr std::array<std::string_view, 5> making = {"made", "emotion", "strength", "example",
                                                      "clip"};
  return std::ranges::find(making, factor) != making.end();
}

bool has_matched_sound(const Stimulus& stimulus) { return sound_level(stimulus) == "matched"; }

/// `has_audio_levels`: whether stimuli of the study differ in the factor `audio`.
ReportedStimulus reported(const Stimulus& stimulus, bool has_audio_levels) {
  ReportedStimulus result;
  result.id = stimulus.id;
  result.factors = levels_of(stimulus);
  for (const auto& [factor, level] : result.factors) {
    if (factor == "made") result.made = level;
    if (factor == "emotion") result.emotion = level;
    if (is_making_factor(factor) || (factor == "audio" && !has_audio_levels)) continue;
    result.setting += (result.setting.empty() ? "" : ", ") + level;
  }
  return result;
}

/// The stimuli of a questionnaire, including practice and warm-up.
std::vector<ReportedStimulus> reported_stimuli(const Manifest& manifest) {
  const std::vector<std::string> asked = questionnaire_stimuli(manifest);
  const Questionnaire& questionnaire = questionnaire_of(manifest);
  std::set<std::string> shown(asked.begin(), asked.end());
  shown.insert(questionnaire.practice.begin(), questionnaire.practice.end());
  const bool has_audio_levels =
      !std::ranges::all_of(manifest.stimuli, [&](const Stimulus& stimulus) {
        return !shown.contains(stimulus.id) || has_matched_sound(stimulus);
      });
  std::vector<ReportedStimulus> stimuli;
  for (const Stimulus& stimulus : manifest.stimuli)
    if (shown.contains(stimulus.id)) stimuli.push_back(reported(stimulus, has_audio_levels));
  return stimuli;
}

/// The rows of the design's table for the reported stimuli.
FactorTable reported_factors(const Manifest& manifest,
                             const std::vector<ReportedStimulus>& reported) {
  const FactorTable all = design_table(manifest);
  FactorTable table{all.factors, {}};
  for (const ReportedStimulus& stimulus : reported)
    for (std::size_t i = 0; i < manifest.stimuli.size(); ++i)
      if (manifest.stimuli[i].id == stimulus.id) table.rows.push_back(all.rows[i]);
  return table;
}

void check_designs(const std::vector<AnswerRow>& rows, AnswerSet& result,
                   std::vector<Fault>& faults) {
  result.design = rows.front().design;
  std::set<std::string> met = {result.design};
  for (const AnswerRow& row : rows) {
    if (!met.insert(row.design).second) continue;
    faults.push_back({row.place, "",
                      fmt::format("an answer of design {} among answers of design {}",
                                  motion::in_quotes(row.design), motion::in_quotes(result.design)),
                      "report the answers of each design separately"});
  }
}

/// Counts answered trials; participants listed as finished are trusted.
std::vector<Unfinished> unfinished_of(const std::vector<AnswerRow>& rows,
                                      const ReportChoices& choices) {
  std::map<std::string, std::set<int>> trials;
  std::map<std::string, int> planned;
  std::set<std::string> finished;
  for (const AnswerRow& row : rows) {
    trials[row.participant].insert(row.trial);
    if (choices.finished.contains(row.participant) ||
        choices.finished.contains(row.participant + "/" + row.session))
      finished.insert(row.participant);
    const auto plan = choices.planned.find(row.seed);
    if (plan != choices.planned.end()) planned[row.participant] = plan->second;
  }
  std::vector<Unfinished> unfinished;
  for (const auto& [participant, of] : planned) {
    const int done = static_cast<int>(trials.at(participant).size());
    if (done < of && !finished.contains(participant)) unfinished.push_back({participant, done, of});
  }
  return unfinished;
}

std::vector<std::string> included_people(const AnswerSet& answer_set) {
  std::vector<std::string> people;
  std::set<std::string> left_out;
  if (answer_set.without_unfinished)
    for (const Unfinished& one : answer_set.unfinished) left_out.insert(one.participant);
  for (const Attention& own : answer_set.attention)
    if (!left_out.contains(own.participant) && !answer_set.quality.leaves_out(own.participant))
      people.push_back(own.participant);
  std::ranges::sort(people);
  return people;
}

/// A sentence on trials that have no answers since their stimuli could not be played; or none.
std::vector<std::string> unplayed_sentences(const std::vector<AnswerRow>& rows) {
  std::set<std::pair<std::string, int>> trials;
  std::set<std::string> people;
  for (const AnswerRow& row : rows) {
    if (row.play_fault.empty()) continue;
    trials.emplace(row.participant, row.trial);
    people.insert(row.participant);
  }
  if (trials.empty()) return {};
  return {fmt::format("{} of {} {} no answers, since the stimuli could not be played",
                      counted_noun(trials.size(), "trial", "trials"),
                      counted_noun(people.size(), "participant", "participants"),
                      trials.size() == 1 ? "has" : "have")};
}

/// A sentence on the viewing distances that the blind spot gave to included participants; or none.
std::vector<std::string> distance_sentences(const std::vector<AnswerRow>& rows,
                                            const std::vector<std::string>& people) {
  std::map<std::string, double> distances;
  for (const AnswerRow& row : rows)
    if (row.viewing_cm && std::ranges::binary_search(people, row.participant))
      distances[row.participant] = *row.viewing_cm;
  if (distances.empty()) return {};
  std::vector<double> cm;
  for (const auto& [participant, distance] : distances) cm.push_back(distance);
  const TTest of_mean = paired_t_test(cm);
  const double deviation = of_mean.standard_error * std::sqrt(static_cast<double>(cm.size()));
  return {fmt::format(
      "Viewing distance, measured with the blind spot: mean {:.1f} cm{} ({:.1f} to {:.1f} cm; {}).",
      of_mean.mean, cm.size() > 1 ? fmt::format(", standard deviation {:.1f} cm", deviation) : "",
      std::ranges::min(cm), std::ranges::max(cm),
      counted_noun(cm.size(), "participant", "participants"))};
}

/// Notes where choices depart from the analysis that the manifest states.
void note_deviations(const AnalysisPlan& plan, const ReportChoices& choices, AnswerSet& result) {
  const auto note = [&](const std::string& given, const std::string& stated) {
    result.notes.push_back(fmt::format(
        "Deviation from the analysis that the manifest states: {} instead of {}.", given, stated));
  };
  if (choices.correction && *choices.correction != plan.correction)
    note(fmt::format("--correction {}", word_of(correction_words, *choices.correction)),
         std::string(word_of(correction_words, plan.correction)));
  if (choices.max_failed_checks && *choices.max_failed_checks != plan.max_failed_checks)
    note(fmt::format("--max-failed-checks {}", *choices.max_failed_checks),
         std::to_string(plan.max_failed_checks));
  if (choices.without_unfinished)
    note("--unfinished leave-out",
         "keep, which includes the answers of participants who did not finish");
}

/// Notes that no answer on a scale is beside the middle, as sliders are that nobody moved.
void note_middle_answers(AnswerSet& result) {
  constexpr std::size_t few = 4;
  if (result.ratings.size() < few) return;
  for (const AnalysedRating& rating : result.ratings) {
    const Scale& scale = result.scales[rating.scale];
    if (std::abs(rating.value - 0.5 * (scale.least + scale.most)) > 1e-9) return;
  }
  result.notes.push_back(fmt::format(
      "All {} answers on scales are exactly in the middle: there is nothing to compare, and tests, "
      "intervals and agreement have no meaning. {}",
      result.ratings.size(),
      result.simulated
          ? "Simulated answers without a truth have the middle as their mean; with a standard "
            "deviation that is small against the scale, all of them are rounded to it "
            "(mien study simulate --truth, --residual-sd)."
          : "Participants may not have moved the sliders or markers from their start."));
}

/// The flags of rows that have been separated by participants; `sessions` are those before.
QualityFlags all_flags(const Questionnaire& asked, const std::vector<AnswerRow>& rows,
                       const std::vector<SessionStart>& sessions, const ReportChoices& choices,
                       AnswerSet& result) {
  QualityFlags flags = quality_flags(asked, rows);
  add_failed_attention(result.attention, result.rule, flags);
  add_post_screening(result.grid, rows, flags);
  const std::string& parameter = asked.analysis.quality.repeated_by;
  if (parameter.empty()) return flags;
  result.is_repetition_known = choices.session_people.is_known;
  if (!choices.session_people.is_known)
    result.notes.push_back("Repeated participation was not examined: no table has the column " +
                           parameter_column(parameter) + ".");
  for (const auto& [participant, reason] :
       repeated_participants(sessions, rows, choices.session_people))
    flags.participants[participant].push_back({QualityRule::repeated_by, reason});
  return flags;
}

}  // namespace

bool ReportedStimulus::is_neutral() const {
  return emotion == "neutral" || emotion == "normal" ||
         (emotion.empty() && (made == "as-is" || made == "neutral"));
}

AnswerSet collect_answers(const Manifest& manifest, std::vector<AnswerRow> rows,
                          const ReportChoices& choices) {
  const Questionnaire& asked = questionnaire_of(manifest);
  AnswerSet result;
  result.study = manifest.study;
  result.title = title_of(manifest);
  result.form = asked.trials;
  result.stimuli = reported_stimuli(manifest);
  for (ReportedStimulus& stimulus : result.stimuli) {
    if (const auto moods = choices.moods.find(stimulus.id); moods != choices.moods.end())
      stimulus.moods = moods->second;
    if (const auto film = choices.film_seconds.find(stimulus.id);
        film != choices.film_seconds.end())
      stimulus.film_s = film->second;
  }
  result.factors = reported_factors(manifest, result.stimuli);
  result.factorial = asked.analysis.factorial;
  result.scales = questionnaire_scales(manifest).scales;
  result.choices = questionnaire_choices(manifest);
  result.grid = grid_sets(manifest);
  if (!asked.adaptive.empty())
    result.thresholds = {asked.adaptive.factor,
                         asked.adaptive.easier == LevelDirection::rising ? 1.0 : -1.0,
                         threshold_proportion(asked.adaptive), track_procedure(manifest)};
  if (asked.trials->is_continuous) result.trace_lead_s = asked.continuous.lead;
  result.trace_lag_s = asked.analysis.lag;
  result.is_slider = has_sliders(asked);
  result.points = result.is_slider ? 11 : asked.answer.points;
  result.rule.max_failed_checks =
      choices.max_failed_checks.value_or(asked.analysis.max_failed_checks);
  result.correction = choices.correction.value_or(asked.analysis.correction);
  result.alpha = asked.analysis.alpha;
  const std::vector<SessionStart> sessions = session_starts(rows);
  result.notes = separate_participants(rows);
  for (const SessionStart& session : sessions)
    result.person_of_session.emplace(session.name, rows[session.row].participant);
  for (std::string& sentence : unplayed_sentences(rows))
    result.notes.push_back(std::move(sentence));
  result.simulated = std::ranges::any_of(rows, &AnswerRow::simulated);
  result.attention = attention_of(rows, result.rule);
  result.quality = all_flags(asked, rows, sessions, choices, result);
  result.unfinished = unfinished_of(rows, choices);
  result.without_unfinished = choices.without_unfinished;
  for (const Demographic& question : asked.demographics)
    if (!question.answer.is_number) result.worded_questions.insert(question.id);
  result.people = included_people(result);
  for (std::string& sentence : distance_sentences(rows, result.people))
    result.notes.push_back(std::move(sentence));
  std::vector<Fault> faults;
  check_designs(rows, result, faults);
  append(faults, check_and_collect(manifest, rows, result));
  if (!faults.empty()) throw Faults(faults);
  if (result.ratings.empty() && result.chosen.empty() && result.preferences.empty() &&
      result.detections.empty() && result.words.empty() &&
      std::ranges::none_of(result.levels, &AnalysedLevel::is_counted))
    refuse_without_answers(rows, result);
  note_middle_answers(result);
  note_deviations(asked.analysis, choices, result);
  return result;
}

std::string counted_noun(std::size_t count, const std::string& one, const std::string& several) {
  return fmt::format("{} {}", count, count == 1 ? one : several);
}

bool has_attention_checks(const AnswerSet& answer_set) {
  return std::ranges::any_of(answer_set.attention,
                             [](const Attention& own) { return own.checks > 0; });
}

std::string people_sentence(const AnswerSet& answer_set) {
  const std::size_t all = answer_set.attention.size();
  return fmt::format("{} of {} analysed", answer_set.people.size(),
                     counted_noun(all, "participant", "participants"));
}

std::vector<std::string> unfinished_sentences(const AnswerSet& answer_set) {
  std::vector<std::string> sentences;
  for (const Unfinished& one : answer_set.unfinished)
    sentences.push_back(
        fmt::format("participant {} did not finish ({} of {} trials): {}",
                    motion::in_quotes(one.participant), one.trials, one.planned,
                    answer_set.without_unfinished ? "excluded" : "answers given are included"));
  return sentences;
}

}  // namespace mien::pipeline

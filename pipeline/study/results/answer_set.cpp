#include "pipeline/study/results/answer_set.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "motion/text/as_number.h"
#include "motion/text/excerpt.h"
#include "motion/text/nearest_word.h"
#include "pipeline/base/documents/fault.h"
#include "pipeline/manifest/questionnaire_content.h"
#include "pipeline/manifest/ratings/answers/counted_answers.h"
#include "pipeline/manifest/ratings/answers/trial_form.h"

namespace mien::pipeline {

namespace {

/// Whether a factor describes how a stimulus was made, and not its actor or content.
bool is_making_factor(const std::string& factor) {
  constexpr std::array<std::string_view, 5> making = {"made", "emotion", "strength", "example",
                                                      "clip"};
  return std::ranges::find(making, factor) != making.end();
}

ReportedStimulus reported(const Stimulus& stimulus) {
  ReportedStimulus result;
  result.id = stimulus.id;
  result.factors = levels_of(stimulus);
  for (const auto& [factor, level] : result.factors) {
    if (factor == "made") result.made = level;
    if (factor == "emotion") result.emotion = level;
    if (is_making_factor(factor)) continue;
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
  std::vector<ReportedStimulus> stimuli;
  for (const Stimulus& stimulus : manifest.stimuli)
    if (shown.contains(stimulus.id)) stimuli.push_back(reported(stimulus));
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

/// Validates rows and collects their faults.
class AnswerCollector {
 public:
  AnswerCollector(const Manifest& manifest, const std::vector<AnswerRow>& rows, AnswerSet& result)
      : questionnaire_(questionnaire_of(manifest)), rows_(rows), result_(result) {
    for (std::size_t i = 0; i < result.stimuli.size(); ++i) {
      stimuli_.emplace(result.stimuli[i].id, i);
      stimulus_ids_.push_back(result.stimuli[i].id);
    }
    for (std::size_t i = 0; i < result.scales.size(); ++i) {
      scales_.emplace(result.scales[i].id, i);
      items_.push_back(result.scales[i].id);
    }
    for (std::size_t i = 0; i < result.people.size(); ++i) people_.emplace(result.people[i], i);
  }

  void check_and_add_all() {
    for (const AnswerRow& row : rows_) check_and_add(row);
  }

  std::vector<Fault> faults;

 private:
  void check_and_add(const AnswerRow& row) {
    if (row.kind == attention_kind) return;
    const auto stimulus = known_stimulus(row, row.stimulus);
    if (!stimulus || !is_of_trial_kind(row)) return;
    if (is_on_scale(row)) {
      add_rating(row, *stimulus);
    } else if (row.item == find_trial_form(row.kind)->item) {
      add_choice(row, *stimulus);
    } else {
      add_preference(row, *stimulus);
    }
    if (!row.comment.empty() && !row.is_practice)
      result_.remarks.push_back({row.participant, row.stimulus, "", row.comment});
  }

  void fault(const AnswerRow& row, std::string wrong, std::string remedy) {
    faults.push_back({row.place, "", std::move(wrong), std::move(remedy)});
  }

  std::optional<std::size_t> known_stimulus(const AnswerRow& row, const std::string& id) {
    const auto found = stimuli_.find(id);
    if (found != stimuli_.end()) return found->second;
    if (told_.insert(id).second)
      fault(row, fmt::format("the study has no stimulus {}", motion::in_quotes(id)),
            motion::did_you_mean(id, stimulus_ids_));
    return std::nullopt;
  }

  bool is_of_trial_kind(const AnswerRow& row) {
    const TrialForm& asked = *questionnaire_.trials;
    // A study of pairs may ask to rate by how much, too.
    if (row.kind == asked.name || (asked.stimuli > 1 && row.kind == rating_form.name)) return true;
    if (told_.insert("kind " + row.kind).second)
      fault(row,
            fmt::format("an answer of kind {}, but the questionnaire has trials of kind {}",
                        row.kind, asked.name),
            "give the manifest that these answers belong to");
    return false;
  }

  bool counts(const AnswerRow& row) const {
    return row.counts() && people_.contains(row.participant) &&
           !result_.quality.leaves_out(static_cast<std::size_t>(&row - rows_.data()));
  }

  std::optional<std::size_t> known_scale(const AnswerRow& row) {
    const auto found = scales_.find(row.item);
    if (found != scales_.end()) return found->second;
    if (told_.insert("item " + row.item).second)
      fault(row, fmt::format("the questionnaire does not ask {}", motion::in_quotes(row.item)),
            motion::did_you_mean(row.item, items_));
    return std::nullopt;
  }

  void add_rating(const AnswerRow& row, std::size_t stimulus) {
    if (questionnaire_.answer.words) {
      if (counts(row))
        result_.words.push_back({row.participant, row.stimulus, row.item, row.value});
      return;
    }
    const auto scale = known_scale(row);
    if (!scale || row.value.empty() || row.value == "NA") return;
    const auto value = motion::as_finite_number(row.value);
    const Scale& of = result_.scales[*scale];
    if (!value || *value < of.least || *value > of.most) {
      fault(row,
            fmt::format("{} is not a valid answer on {}", motion::in_quotes(row.value),
                        motion::in_quotes(of.id)),
            fmt::format("answers go from {} to {}", of.least, of.most));
      return;
    }
    check_orientation(row, of, *value);
    if (counts(row))
      result_.ratings.push_back({people_.at(row.participant), stimulus, *scale, *value});
  }

  /// Checks that the raw answer and the side of the poles give the value.
  void check_orientation(const AnswerRow& row, const Scale& scale, double value) {
    const auto raw = motion::as_finite_number(row.value_raw);
    if (!raw || row.pole_left.empty()) return;
    const double share = questionnaire_.answer.slider
                             ? *raw / 100.0
                             : (*raw - 1.0) / std::max(1.0, questionnaire_.answer.points - 1.0);
    const double from_low = row.pole_left == "low" ? share : 1.0 - share;
    const double expected = scale.least + from_low * (scale.most - scale.least);
    if (std::abs(expected - value) <= 1e-6 * (scale.most - scale.least)) return;
    fault(row,
          fmt::format("the raw answer {} with the {} pole on the left corresponds to {:g}, not {}",
                      row.value_raw, row.pole_left, expected, row.value),
          "use the file as written by the questionnaire, and its manifest");
  }

  void add_choice(const AnswerRow& row, std::size_t stimulus) {
    if (row.value.empty() || row.value == "NA") return;
    const bool is_offered = std::ranges::any_of(
        result_.choices, [&](const auto& choice) { return choice.first == row.value; });
    if (!is_offered) {
      fault(row, fmt::format("{} was not among the choices", motion::in_quotes(row.value)),
            "give the manifest that these answers belong to");
      return;
    }
    if (counts(row)) result_.chosen.push_back({people_.at(row.participant), stimulus, row.value});
  }

  void add_preference(const AnswerRow& row, std::size_t stimulus) {
    const auto against = known_stimulus(row, row.against);
    if (!against || row.value.empty() || row.value == "NA") return;
    const bool is_tie = row.value == tie_value && row.value_raw == tie_value;
    if (!is_tie && row.value != row.stimulus && row.value != row.against) {
      fault(row, fmt::format("{} is not one of the pair", motion::in_quotes(row.value)),
            fmt::format("they are {} and {}", row.stimulus, row.against));
      return;
    }
    if (!counts(row)) return;
    const bool is_first = is_tie || row.value == row.stimulus;
    result_.preferences.push_back({people_.at(row.participant), is_first ? stimulus : *against,
                                   is_first ? *against : stimulus, row.item, is_first, is_tie});
  }

  const Questionnaire& questionnaire_;
  const std::vector<AnswerRow>& rows_;
  AnswerSet& result_;
  std::map<std::string, std::size_t> stimuli_, scales_, people_;
  std::vector<std::string> stimulus_ids_, items_;
  std::set<std::string> told_;
};

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
  for (const AnswerRow& row : rows) {
    trials[row.participant].insert(row.trial);
    const auto plan = choices.planned.find(row.seed);
    if (plan != choices.planned.end()) planned[row.participant] = plan->second;
  }
  std::vector<Unfinished> unfinished;
  for (const auto& [participant, of] : planned) {
    const int done = static_cast<int>(trials.at(participant).size());
    if (done < of && !choices.finished.contains(participant))
      unfinished.push_back({participant, done, of});
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

/// The flags of rows that have been separated by participants; `sessions` are those before.
QualityFlags all_flags(const Questionnaire& asked, const std::vector<AnswerRow>& rows,
                       const std::vector<SessionStart>& sessions, const ReportChoices& choices,
                       AnswerSet& result) {
  QualityFlags flags = quality_flags(asked, rows);
  add_failed_attention(result.attention, result.rule, flags);
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
  result.stimuli = reported_stimuli(manifest);
  result.factors = reported_factors(manifest, result.stimuli);
  result.factorial = asked.analysis.factorial;
  result.scales = questionnaire_scales(manifest).scales;
  result.choices = questionnaire_choices(manifest);
  result.is_slider = asked.answer.slider;
  result.points = asked.answer.slider ? 11 : asked.answer.points;
  result.rule.max_failed_checks =
      choices.max_failed_checks.value_or(asked.analysis.max_failed_checks);
  result.correction = choices.correction.value_or(asked.analysis.correction);
  result.alpha = asked.analysis.alpha;
  const std::vector<SessionStart> sessions = session_starts(rows);
  result.notes = separate_participants(rows);
  result.simulated = std::ranges::any_of(rows, &AnswerRow::simulated);
  result.attention = attention_of(rows, result.rule);
  result.quality = all_flags(asked, rows, sessions, choices, result);
  result.unfinished = unfinished_of(rows, choices);
  result.without_unfinished = choices.without_unfinished;
  for (const Demographic& question : asked.demographics)
    if (!question.answer.is_number) result.worded_questions.insert(question.id);
  result.people = included_people(result);
  AnswerCollector sorter(manifest, rows, result);
  check_designs(rows, result, sorter.faults);
  sorter.check_and_add_all();
  if (!sorter.faults.empty()) throw Faults(sorter.faults);
  if (result.ratings.empty() && result.chosen.empty() && result.preferences.empty() &&
      result.words.empty())
    throw Error(Place{rows.front().place.file, 1, 1}, "holds no answers to analyse",
                "answers to practice, warm-up and check trials, those of excluded participants and "
                "those that quality rules exclude are ignored");
  return result;
}

std::string counted_noun(std::size_t count, const std::string& one, const std::string& several) {
  return fmt::format("{} {}", count, count == 1 ? one : several);
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

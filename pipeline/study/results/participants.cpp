#include "pipeline/study/results/participants.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "motion/text/as_number.h"
#include "pipeline/base/statistics/t_test.h"
#include "pipeline/manifest/ratings/answers/answer_row.h"
#include "pipeline/manifest/ratings/answers/identifying_columns.h"
#include "pipeline/manifest/ratings/answers/participant_row.h"
#include "pipeline/study/results/people_of_rows.h"
#include "pipeline/study/results/summaries.h"

namespace mien::pipeline {

namespace {

/// Sums measurements that are repeated in each row of a trial, once for each trial. `own` are
/// indices of `rows`.
void add_trials(ParticipantSummary& summary, const std::vector<AnswerRow>& rows,
                const std::vector<std::size_t>& own, const QualityFlags& quality) {
  std::set<std::pair<std::string, int>> met;
  std::set<std::string> values;
  int on_scale = 0;
  std::vector<double> times;
  for (const std::size_t index : own) {
    const AnswerRow* row = &rows[index];
    summary.flagged_answers += quality.of_answer(index).empty() ? 0 : 1;
    if (row->counts() && !quality.leaves_out(index)) {
      ++summary.answers;
      if (!row->pole_left.empty()) {
        ++on_scale;
        values.insert(row->value_raw);
      }
      if (row->rt_ms) times.push_back(*row->rt_ms);
    }
    if (!met.emplace(row->session, row->trial).second) continue;
    summary.stalls += row->stalls.value_or(0);
    summary.dropped_frames += row->dropped_frames.value_or(0);
    summary.blurs += row->blurs.value_or(0);
  }
  summary.trials = static_cast<int>(met.size());
  summary.median_rt_ms = median_of(times);
  summary.is_straight_lining = on_scale >= 3 && values.size() == 1;
}

void add_numbers(const std::string& question, const std::vector<double>& numbers,
                 std::vector<DemographicSummary>& all) {
  const TTest of_mean = paired_t_test(numbers);
  const int people = static_cast<int>(numbers.size());
  all.push_back({question, "mean", of_mean.mean, people});
  all.push_back({question, "standard deviation",
                 of_mean.standard_error * std::sqrt(static_cast<double>(people)), people});
  all.push_back({question, "least", std::ranges::min(numbers), people});
  all.push_back({question, "most", std::ranges::max(numbers), people});
}

}  // namespace

std::vector<ParticipantSummary> participant_summaries(const AnswerSet& answer_set,
                                                      std::vector<AnswerRow> rows) {
  separate_participants(rows);
  std::map<std::string, std::vector<std::size_t>> of_person;
  for (std::size_t i = 0; i < rows.size(); ++i) of_person[rows[i].participant].push_back(i);
  std::set<std::string> unfinished;
  for (const Unfinished& one : answer_set.unfinished) unfinished.insert(one.participant);
  std::vector<ParticipantSummary> all;
  for (const Attention& own : answer_set.attention) {
    ParticipantSummary summary;
    summary.participant = own.participant;
    summary.checks = own.checks;
    summary.passed = own.passed;
    summary.is_excluded = !std::ranges::binary_search(answer_set.people, own.participant);
    summary.is_unfinished = unfinished.contains(own.participant);
    summary.reasons = reasons_text(answer_set.quality.of_participant(own.participant));
    add_trials(summary, rows, of_person.at(own.participant), answer_set.quality);
    all.push_back(summary);
  }
  std::ranges::sort(all, {}, &ParticipantSummary::participant);
  return all;
}

std::vector<std::string> ParticipantTable::questions() const {
  std::vector<std::string> questions;
  for (const CsvField& field : table.header)
    if (is_question_column(field.text)) questions.push_back(field.text);
  return questions;
}

std::set<std::string> ParticipantTable::finished() const {
  std::set<std::string> names;
  const int name = find_column(table, "participant");
  const int session = find_column(table, "session");
  const int done = find_column(table, "finished");
  if (name < 0 || done < 0) return names;
  for (const auto& row : table.rows) {
    if (row[static_cast<std::size_t>(done)].text != "1") continue;
    const std::string& participant = row[static_cast<std::size_t>(name)].text;
    const std::string own = session < 0 ? "" : row[static_cast<std::size_t>(session)].text;
    names.insert(own.empty() ? participant : participant + "/" + own);
  }
  return names;
}

ParticipantTable read_participants(const std::filesystem::path& file) {
  ParticipantTable participants{read_csv(file)};
  require_column(participants.table, "participant");
  leave_out_what_identifies(participants.table);
  return participants;
}

ParticipantTable joined(const std::vector<ParticipantTable>& tables) {
  ParticipantTable all;
  for (const ParticipantTable& part : tables) {
    if (all.table.header.empty()) {
      all = part;
      continue;
    }
    const bool alike = std::ranges::equal(all.table.header, part.table.header, {}, &CsvField::text,
                                          &CsvField::text);
    if (!alike)
      throw Error(place_of(part.table, part.table.header.front()),
                  "has different columns from " + all.table.file,
                  "report each questionnaire separately");
    all.table.rows.insert(all.table.rows.end(), part.table.rows.begin(), part.table.rows.end());
  }
  std::set<std::vector<std::string>> met;
  std::erase_if(all.table.rows, [&](const std::vector<CsvField>& row) {
    std::vector<std::string> texts;
    for (const CsvField& field : row) texts.push_back(field.text);
    return !met.insert(std::move(texts)).second;
  });
  return all;
}

namespace {

/// Summarises the answers to a question: numbers by their distribution, words by their frequencies.
void add_answers(const std::string& question, const std::vector<std::string>& answers,
                 bool is_worded, std::vector<DemographicSummary>& all) {
  if (answers.empty()) return;
  std::vector<double> numbers;
  std::map<std::string, int> words;
  for (const std::string& answer : answers) {
    ++words[answer];
    if (const auto number = motion::as_written_number(answer)) numbers.push_back(*number);
  }
  if (!is_worded && numbers.size() == answers.size()) return add_numbers(question, numbers, all);
  for (const auto& [word, count] : words)
    all.push_back(
        {question, word, static_cast<double>(count), static_cast<int>(answers.size()), true});
}

}  // namespace

std::vector<DemographicSummary> demographics_of(const ParticipantTable& participants,
                                                const AnswerSet& answer_set) {
  std::vector<DemographicSummary> all;
  if (participants.empty()) return all;
  const CsvTable& table = participants.table;
  const std::vector<std::string> people = people_of_rows(participants, answer_set);
  const auto answers_to = [&](const std::string& question) {
    const auto column = static_cast<std::size_t>(find_column(table, question));
    std::map<std::string, std::set<std::string>> of_person;
    for (std::size_t i = 0; i < people.size(); ++i) {
      const std::string& answer = table.rows[i][column].text;
      if (!answer.empty() &&
          std::ranges::find(answer_set.people, people[i]) != answer_set.people.end())
        of_person[people[i]].insert(answer);
    }
    std::vector<std::string> answers;
    for (const auto& [person, own] : of_person)
      if (own.size() == 1) answers.push_back(*own.begin());
    return answers;
  };
  for (const std::string& question : participants.questions())
    add_answers(question, answers_to(question), answer_set.worded_questions.contains(question),
                all);
  if (find_column(table, "language") < 0) return all;
  const std::vector<std::string> languages = answers_to("language");
  if (std::ranges::any_of(languages, [&](const auto& one) { return one != languages.front(); }))
    add_answers("language of the pages", languages, true, all);
  return all;
}

}  // namespace mien::pipeline

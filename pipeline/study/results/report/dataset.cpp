#include "pipeline/study/results/report/dataset.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <set>
#include <span>

#include <nlohmann/json.hpp>

#include "pipeline/base/documents/psych_ds.h"
#include "pipeline/base/documents/table.h"
#include "pipeline/manifest/ratings/answers/participant_row.h"
#include "pipeline/manifest/ratings/answers/trace_table.h"
#include "pipeline/study/results/people_of_rows.h"

namespace mien::pipeline {

namespace {

using nlohmann::ordered_json;

constexpr Column excluded_column = {"excluded", "",
                                    "1 for answers of participants excluded from the report"};

/// The same, and flags, for questionnaires with quality rules.
constexpr std::array<Column, 3> quality_columns = {
    {{"excluded", "",
      "1 for answers excluded from the report, alone or because the participant is excluded"},
     {"answer_flags", "", "reasons for which quality rules flag the answer; empty: none"},
     {"participant_flags", "",
      "reasons for which quality rules flag the participant; empty: none"}}};

/// The columns that the report adds to the answers.
std::span<const Column> added_columns(const AnswerSet& answer_set) {
  if (answer_set.quality.stated.empty()) return {&excluded_column, 1};
  return quality_columns;
}

constexpr Column simulated_column = {"simulated", "", "1 for simulated participants"};

constexpr auto stimulus_columns = table_of<ReportedStimulus>(
    "data/stimuli.csv", "stimulus",
    {{"stimulus", "", "stimulus id", [](auto& r) { return r.id; }},
     {"made", "", "level of factor made", [](auto& r) { return r.made; }},
     {"emotion", "", "level of factor emotion", [](auto& r) { return r.emotion; }},
     {"setting", "", "levels of the other factors except strength, example and clip",
      [](auto& r) { return r.setting; }}});

/// A column of participant_form; nullptr for a demographic question.
const Column* participant_column(std::string_view name) {
  return name == simulated_column.name ? &simulated_column : find_column(participant_form, name);
}

/// The traces, with participants named as in the other tables.
std::string separated_traces_csv(const Results& results, std::vector<AnswerRow> rows) {
  separate_participants(rows);
  std::map<std::string, double> film_seconds;
  for (const ReportedStimulus& stimulus : results.answer_set.stimuli)
    film_seconds[stimulus.id] = stimulus.film_s;
  return traces_csv(rows, film_seconds);
}

std::string answers_csv(const Results& results, std::vector<AnswerRow> rows) {
  separate_participants(rows);
  const std::vector<std::string>& people = results.answer_set.people;
  const QualityFlags& quality = results.answer_set.quality;
  std::vector<std::string> header = header_of(answer_form);
  for (const Column& column : added_columns(results.answer_set)) header.emplace_back(column.name);
  CsvWriter writer(header);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    std::vector<std::string> fields = fields_of_row(rows[i]);
    const std::string& participant = rows[i].participant;
    const bool counts = std::ranges::binary_search(people, participant) && !quality.leaves_out(i);
    fields.emplace_back(counts ? "0" : "1");
    if (!quality.stated.empty()) {
      fields.push_back(reasons_text(quality.of_answer(i)));
      fields.push_back(reasons_text(quality.of_participant(participant)));
    }
    writer.row(fields);
  }
  return writer.text();
}

/// Factors of the stimuli other than `made` and `emotion`.
std::vector<std::string> further_factors(const AnswerSet& answer_set) {
  std::vector<std::string> factors;
  for (const ReportedStimulus& stimulus : answer_set.stimuli)
    for (const auto& [factor, level] : stimulus.factors) {
      const bool is_known = find_column(stimulus_columns.form(), factor) != nullptr ||
                            std::ranges::find(factors, factor) != factors.end();
      if (!is_known) factors.push_back(factor);
    }
  return factors;
}

std::string stimuli_csv(const AnswerSet& answer_set) {
  const std::vector<std::string> further = further_factors(answer_set);
  std::vector<std::string> header = header_of(stimulus_columns.form());
  header.insert(header.end(), further.begin(), further.end());
  CsvWriter writer(header);
  for (const ReportedStimulus& stimulus : answer_set.stimuli) {
    std::vector<std::string> row = stimulus_columns.fields_of(stimulus);
    for (const std::string& factor : further) {
      const auto found =
          std::ranges::find(stimulus.factors, factor, &std::pair<std::string, std::string>::first);
      row.push_back(found == stimulus.factors.end() ? "" : found->second);
    }
    writer.row(row);
  }
  return writer.text();
}

/// The table of participants, with participants named as in the other tables.
std::string participants_csv(const Results& results) {
  const CsvTable& table = results.demographics.table;
  const std::vector<std::string> names = published_names(results.demographics, results.answer_set);
  const auto participant = static_cast<std::size_t>(require_column(table, "participant"));
  std::vector<std::string> header;
  for (const CsvField& field : table.header) header.push_back(field.text);
  CsvWriter writer(header);
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    std::vector<std::string> fields;
    for (const CsvField& field : table.rows[i]) fields.push_back(field.text);
    fields[participant] = names[i];
    writer.row(fields);
  }
  return writer.text();
}

/// The columns of the data, each name once.
class Variables {
 public:
  void add(const Column& column) {
    if (names_.insert(std::string(column.name)).second)
      list_.push_back(psych_ds_variable(column.name, column.meaning, column.unit));
  }
  void add(const std::string& name, const std::string& meaning) { add(Column{name, "", meaning}); }
  const ordered_json& list() const { return list_; }

 private:
  std::set<std::string> names_;
  ordered_json list_ = ordered_json::array();
};

Variables variables_of(const Results& results) {
  Variables variables;
  for (const Column& column : answer_form.columns) variables.add(column);
  for (const Column& column : added_columns(results.answer_set)) variables.add(column);
  if (results.answer_set.form->is_continuous)
    for (const Column& column : traces_form.columns) variables.add(column);
  for (const Column& column : stimulus_columns.columns) variables.add(column);
  for (const std::string& factor : further_factors(results.answer_set))
    variables.add(factor, "level of the factor " + factor + " of the stimulus");
  if (!results.demographics.empty()) {
    for (const CsvField& field : results.demographics.table.header)
      if (const Column* known = participant_column(field.text)) variables.add(*known);
    for (const std::string& question : results.demographics.questions())
      variables.add(question, "participant's answer to the question " + question);
  }
  return variables;
}

std::string description_of(const Results& results) {
  const AnswerSet& answer_set = results.answer_set;
  const std::string simulated = answer_set.simulated ? "SIMULATED answers: " : "";
  ordered_json description = psych_ds_description(
      answer_set.title,
      simulated + "answers to the questionnaire of study " + answer_set.study +
          ", one row per answer, with the stimuli and participants. Derived tables and figures are "
          "in results and figures; codebook.csv documents all columns.",
      variables_of(results).list());
  description["keywords"] = {"questionnaire", "human motion", "ratings"};
  if (answer_set.simulated) description["keywords"].push_back("simulated");
  const auto replace = ordered_json::error_handler_t::replace;
  return description.dump(2, ' ', false, replace) + "\n";
}

std::string codebook_of(const Results& results, const std::vector<WrittenTable>& tables) {
  const DatasetPaths paths = dataset_paths(results.answer_set.study);
  std::vector<DescribedColumn> book;
  const auto add = [&](const TableForm& form, std::string_view path) {
    std::ranges::move(described(form, path), std::back_inserter(book));
  };
  add(answer_form, paths.answers);
  add({paths.answers, answer_form.rows, added_columns(results.answer_set)}, paths.answers);
  if (results.answer_set.form->is_continuous) add(traces_form, paths.traces);
  add(stimulus_columns.form(), paths.stimuli);
  for (const std::string& factor : further_factors(results.answer_set))
    book.push_back({paths.stimuli, "stimulus", factor, "", "level of the factor " + factor});
  if (!results.demographics.empty()) {
    for (const CsvField& field : results.demographics.table.header) {
      const Column* known = participant_column(field.text);
      book.push_back({paths.participants, "participant", field.text, "",
                      known == nullptr ? "answer to the question " + field.text
                                       : std::string(known->meaning)});
    }
  }
  for (const WrittenTable& table : tables) {
    add(table.form, table.form.path);
    if (results.answer_set.simulated)
      book.push_back({std::string(table.form.path), std::string(table.form.rows), "simulated", "",
                      "1: computed from simulated answers"});
  }
  return codebook_csv(book);
}

std::string readme_of(const Results& results) {
  const DatasetPaths paths = dataset_paths(results.answer_set.study);
  return "# " + results.answer_set.title + "\n\n" +
         (results.answer_set.simulated ? "**Simulated answers.**\n\n" : "") +
         "Answers to the questionnaire of study " + results.answer_set.study +
         ", as a Psych-DS dataset, and the results computed from them by mien study report.\n\n"
         "- report.html: all results on one page\n" +
         (results.demographics.empty()
              ? "- data/: the answers (one row each) and the stimuli\n"
              : "- data/: the answers (one row each), the stimuli and the participants\n") +
         (results.answer_set.form->is_continuous
              ? "- " + paths.traces + ": the traces of continuous ratings (one row per sample)\n"
              : std::string()) +
         "- dataset_description.json: meaning of each column of data/ (JSON-LD)\n"
         "- codebook.csv: meaning of each column of data/ and results/\n"
         "- results/: tables\n"
         "- figures/: figures as PDF, SVG and PNG\n" +
         (results.answer_set.ratings.empty()
              ? std::string()
              : "- analysis/: R scripts (lme4, ordinal, afex) that analyse " + paths.answers +
                    "\n");
}

}  // namespace

DatasetPaths dataset_paths(const std::string& study) {
  return {psych_ds_path(study, "answers"), psych_ds_path(study, "stimuli"),
          psych_ds_path(study, "participants"), psych_ds_path(study, "traces")};
}

std::vector<DatasetFile> dataset_files(const Results& results, const std::vector<AnswerRow>& rows,
                                       const std::vector<WrittenTable>& tables) {
  const DatasetPaths paths = dataset_paths(results.answer_set.study);
  std::vector<DatasetFile> files = {{paths.answers, answers_csv(results, rows)},
                                    {paths.stimuli, stimuli_csv(results.answer_set)},
                                    {"dataset_description.json", description_of(results)},
                                    {"codebook.csv", codebook_of(results, tables)},
                                    {"README.md", readme_of(results)},
                                    // Files that the validator ignores.
                                    {".psychdsignore",
                                     "report.html\ncodebook.csv\n"
                                     "results/\nfigures/\nanalysis/\n"}};
  if (results.answer_set.form->is_continuous)
    files.push_back({paths.traces, separated_traces_csv(results, rows)});
  if (!results.demographics.empty())
    files.push_back({paths.participants, participants_csv(results)});
  return files;
}

}  // namespace mien::pipeline

#include "pipeline/manifest/ratings/answers/counted_answers.h"

#include <array>
#include <cstddef>
#include <set>

#include <fmt/format.h>

#include "motion/text/excerpt.h"
#include "pipeline/manifest/ratings/answers/attention.h"
#include "pipeline/manifest/ratings/answers/raw_form.h"
#include "pipeline/manifest/ratings/answers/trial_form.h"

namespace mien::pipeline {

namespace {

/// A column there, and its name here.
struct CarriedColumn {
  const char* name;
  const char* as;
};

constexpr std::array carried_columns = {CarriedColumn{"participant", "participant"},
                                        CarriedColumn{"stimulus", "stimulus"},
                                        CarriedColumn{"item", "scale"},
                                        CarriedColumn{"value", "value"},
                                        CarriedColumn{"rt_ms", "rt_ms"},
                                        CarriedColumn{"comment", "comment"},
                                        CarriedColumn{"simulated", "simulated"}};

std::set<std::string> told_excluded(const std::vector<AnswerRow>& rows,
                                    std::vector<std::string>& told) {
  std::set<std::string> excluded;
  for (const Attention& own : attention_of(rows)) {
    if (!own.is_excluded) continue;
    excluded.insert(own.participant);
    told.push_back(fmt::format("participant {} is excluded: {} of {} attention checks passed",
                               motion::in_quotes(own.participant), own.passed, own.checks));
  }
  return excluded;
}

}  // namespace

bool is_on_scale(const AnswerRow& row) {
  // A trial that asks which emotion is seen may ask scales too.
  const TrialForm* form = find_trial_form(row.kind);
  return form != nullptr && form->is_on_scale && row.item != form->item;
}

CountedAnswers counted_answers(const CsvTable& table, const ScaleSet& scales) {
  std::vector<AnswerRow> rows = answer_rows(table);
  const std::vector<Fault> faults = contradicted_values(rows, scales);
  if (!faults.empty()) throw Faults(faults);
  CountedAnswers counted;
  counted.told = tell_people_apart(rows);
  const std::set<std::string> excluded = told_excluded(rows, counted.told);
  counted.table.file = table.file;
  std::vector<std::size_t> indices;
  for (const CarriedColumn& column : carried_columns) {
    indices.push_back(static_cast<std::size_t>(require_column(table, column.name)));
    const CsvField& head = table.header[indices.back()];
    counted.table.header.push_back({column.as, head.line, head.column});
  }
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const bool is_rating = rows[i].counts() && is_on_scale(rows[i]);
    if (!is_rating || excluded.contains(rows[i].participant)) continue;
    std::vector<CsvField> fields;
    for (const std::size_t index : indices) fields.push_back(table.rows[i][index]);
    fields.front().text = rows[i].participant;
    counted.table.rows.push_back(std::move(fields));
  }
  if (counted.table.rows.empty())
    throw Error(Place{table.file, 1, 1}, "holds no ratings to analyse",
                "ratings in practice, warm-up and check trials and of participants who failed "
                "checks are ignored");
  return counted;
}

}  // namespace mien::pipeline

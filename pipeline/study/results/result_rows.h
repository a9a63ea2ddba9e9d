#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include "pipeline/base/documents/table.h"
#include "pipeline/study/results/result_tables.h"

namespace mien::pipeline {

/// A result with the answers on which it is based.
template <class Result>
struct ResultRow {
  const AnswerSet& in;
  const Result& of;

  const ReportedStimulus& stimulus() const { return in.stimuli[of.stimulus]; }
  const Scale& scale() const { return in.scales[of.scale]; }
};

/// A ColumnOf whose floating-point numbers are formatted by number_field.
template <class Row>
struct ResultColumn : ColumnOf<Row> {
  constexpr ResultColumn() = default;

  template <class From>
  constexpr ResultColumn(std::string_view column, std::string_view of_unit, std::string_view means,
                         From)
      : ColumnOf<Row>(column, of_unit, means, [](const Row& row) { return rounded(From{}(row)); }) {
  }

  template <class From>
  constexpr ResultColumn(const SharedColumn<From>& shared)
      : ResultColumn(shared.name, shared.unit, shared.meaning, shared.from) {}

 private:
  static std::string rounded(double number) { return number_field(number); }
  static auto rounded(const auto& value) { return value; }
};

/// A table of results. `path` is relative to the folder of the report, `rows` states what a row is,
/// and `ending` has the last columns.
template <class Row, std::size_t count, std::size_t more = 0>
constexpr Table<Row, count + more> result_table(
    std::string_view path, std::string_view rows, const ResultColumn<Row> (&columns)[count],
    const std::array<ResultColumn<Row>, more>& ending = {}) {
  std::array<ResultColumn<Row>, count + more> all;
  std::ranges::copy(columns, all.begin());
  std::ranges::copy(ending, all.begin() + count);
  return {path, rows, all};
}

/// Appends the table to `tables`, unless it has no rows. If `simulated`, a column states that.
template <class Row, std::size_t count>
void add_table(const Table<Row, count>& table, const std::vector<Row>& rows, bool simulated,
               std::vector<WrittenTable>& tables) {
  if (rows.empty()) return;
  std::vector<std::string> header = header_of(table.form());
  if (simulated) header.emplace_back("simulated");
  CsvWriter writer(header);
  for (const Row& row : rows) {
    std::vector<std::string> fields = table.fields_of(row);
    if (simulated) fields.emplace_back("1");
    writer.row(fields);
  }
  tables.push_back({table.form(), writer.text()});
}

/// Appends a table in which each of `results` has a row, ResultRow{answer_set, result}.
template <class Row, std::size_t count>
void add_results(const Table<Row, count>& table, const auto& results, const AnswerSet& answer_set,
                 std::vector<WrittenTable>& tables) {
  std::vector<Row> rows;
  for (const auto& result : results) rows.push_back({answer_set, result});
  add_table(table, rows, answer_set.simulated, tables);
}

// Columns shared by several tables.

inline constexpr SharedColumn stimulus_column{"stimulus", "", "stimulus id",
                                              [](auto& r) { return r.stimulus().id; }};
inline constexpr SharedColumn made_column{"made", "",
                                          "level of factor made: acted, modified or as-is",
                                          [](auto& r) { return r.stimulus().made; }};
inline constexpr SharedColumn emotion_column{"emotion", "", "level of factor emotion",
                                             [](auto& r) { return r.stimulus().emotion; }};
inline constexpr SharedColumn setting_column{
    "setting", "",
    "levels of the other factors except strength, example and clip; comparisons are made within a "
    "setting",
    [](auto& r) { return r.stimulus().setting; }};
inline constexpr SharedColumn scale_column{"scale", "", "scale id",
                                           [](auto& r) { return r.scale().id; }};
inline constexpr SharedColumn adjusted_column{"p_adjusted", "",
                                              "p corrected for multiple comparisons, over the "
                                              "rows of the question (groups), of the confusion "
                                              "matrix (recall) or of the whole table",
                                              [](auto& r) { return p_field(r.of.adjusted); }};

/// Adds the tables of comparisons.
void add_comparisons(const Results& results, std::vector<WrittenTable>& tables);
/// Adds the tables of the analysis of variance, its cell means and contrasts.
void add_factors(const Results& results, std::vector<WrittenTable>& tables);
/// Adds the tables of worths of compared stimuli.
void add_worths(const Results& results, std::vector<WrittenTable>& tables);
/// Adds the tables of the sensitivities in detection.
void add_detection(const Results& results, std::vector<WrittenTable>& tables);
/// Adds the tables of the thresholds of adaptive trials.
void add_thresholds(const Results& results, std::vector<WrittenTable>& tables);
/// Adds the tables of grid trials.
void add_grid(const Results& results, std::vector<WrittenTable>& tables);
/// Adds the tables of traces.
void add_traces(const Results& results, std::vector<WrittenTable>& tables);
/// Adds the tables of participants, free texts and repeated trials.
void add_participants(const Results& results, std::vector<WrittenTable>& tables);

}  // namespace mien::pipeline

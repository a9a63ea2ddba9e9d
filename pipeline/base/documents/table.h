#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "pipeline/base/documents/csv.h"

namespace mien::pipeline {

/// A column of a table of results.
struct Column {
  std::string_view name;
  std::string_view unit;     ///< "m", "0–1"; empty for names, texts and plain counts
  std::string_view meaning;  ///< a sentence without its full stop; how signs are to be read
};

/// What a table of results holds, as codebooks have it.
struct TableForm {
  std::string_view path;  ///< "metrics/distances.csv"
  std::string_view rows;  ///< what a row is of: "compared pair"
  std::span<const Column> columns;
};

/// A column of which a study may have any number, `<prefix><name>` each.
inline constexpr std::string_view column_of_each = "*";

/// The columns' names. A column `factor_*` stands for one of each of `names`.
std::vector<std::string> header_of(const TableForm& form,
                                   const std::vector<std::string>& names = {});

/// The column of that name, or null.
const Column* find_column(const TableForm& form, std::string_view name);

/// The form as a section of a page in Markdown: what a row is, and a table of the columns.
std::string markdown_of(const TableForm& form);

/// A table as it is written.
struct WrittenTable {
  TableForm form;
  std::string csv;
};

/// "simulated" or "given": whose ratings, answers or sessions a row rests on.
std::string given_or_simulated(bool is_simulated);

// Values as tables have them. Numbers are the shortest decimals that read back as the same, and
// empty where they are not finite; truth is 1 or 0; what is not known is empty.

std::string field_text(double number);
inline std::string field_text(std::string text) { return text; }
inline std::string field_text(std::string_view text) { return std::string(text); }
inline std::string field_text(const char* text) { return text; }
inline std::string field_text(bool value) { return value ? "1" : "0"; }
std::string field_text(std::integral auto number) { return std::to_string(number); }
template <class Value>
std::string field_text(const std::optional<Value>& value) {
  return value ? field_text(*value) : std::string();
}

/// A column that several tables have, whose rows all have what `from` takes.
template <class From>
struct SharedColumn {
  std::string_view name;
  std::string_view unit;
  std::string_view meaning;
  From from;
};
template <class From>
SharedColumn(std::string_view, std::string_view, std::string_view, From) -> SharedColumn<From>;

/// A column of a table whose rows are made from a `Row` each: its `from` is a lambda without
/// captures that takes one and returns what the column holds of it, or a vector of texts for a
/// column of each.
template <class Row>
struct ColumnOf : Column {
  constexpr ColumnOf() = default;

  template <class From>
  constexpr ColumnOf(std::string_view column, std::string_view of_unit, std::string_view means,
                     From)
      : Column{column, of_unit, means}, add([](const Row& row, std::vector<std::string>& fields) {
          add_field(From{}(row), fields);
        }) {}

  template <class From>
  constexpr ColumnOf(const SharedColumn<From>& shared)
      : ColumnOf(shared.name, shared.unit, shared.meaning, shared.from) {}

  void (*add)(const Row& row, std::vector<std::string>& fields) = nullptr;

 private:
  static void add_field(std::vector<std::string> of_each, std::vector<std::string>& fields) {
    for (std::string& text : of_each) fields.push_back(std::move(text));
  }
  static void add_field(const auto& value, std::vector<std::string>& fields) {
    fields.push_back(field_text(value));
  }
};

/// A result, and whether what it rests on is simulated: a row of tables of such results.
template <class Result>
struct GivenOrSimulated {
  bool simulated;
  const Result& of;
};

/// Whose ratings a row rests on, of an `r.simulated`.
inline constexpr SharedColumn whose_ratings_column = {
    "ratings", "", "given (by people) or simulated",
    [](auto& r) { return given_or_simulated(r.simulated); }};

/// A table as it is declared: one list of columns, from which header, rows and codebook come.
template <class Row, std::size_t count>
struct Table {
  /// `list` has `count` columns.
  constexpr Table(std::string_view file, std::string_view row_is, const auto& list)
      : path(file), rows(row_is) {
    for (std::size_t i = 0; i < count; ++i) {
      columns[i] = list[i];
      add[i] = list[i].add;
    }
  }

  /// Of a table in static storage, to which it refers.
  constexpr TableForm form() const { return {path, rows, columns}; }

  std::vector<std::string> fields_of(const Row& row) const {
    std::vector<std::string> fields;
    for (const auto add_column : add) add_column(row, fields);
    return fields;
  }

  /// With a row for each of a range of `Row`s; `names` are those of columns of each.
  WrittenTable of(auto&& all, const std::vector<std::string>& names = {}) const {
    CsvWriter writer(header_of(form(), names));
    for (const Row& row : all) writer.row(fields_of(row));
    return {form(), writer.text()};
  }

  /// Likewise of Row{whole, part} for each of `parts`.
  WrittenTable of_parts(const auto& whole, auto&& parts,
                        const std::vector<std::string>& names = {}) const {
    CsvWriter writer(header_of(form(), names));
    for (const auto& part : parts) writer.row(fields_of(Row{whole, part}));
    return {form(), writer.text()};
  }

  std::string_view path;
  std::string_view rows;
  std::array<Column, count> columns{};
  std::array<void (*)(const Row&, std::vector<std::string>&), count> add{};
};

/// table_of<Row>("metrics/weights.csv", "a stimulus and example",
///               {{"weight", "", "its share of the blend", [](auto& r) { return r.weight; }}})
template <class Row, std::size_t count>
constexpr Table<Row, count> table_of(std::string_view path, std::string_view rows,
                                     const ColumnOf<Row> (&columns)[count]) {
  return {path, rows, columns};
}

/// A p value for tables: the shortest decimal that reads back as the same ("0.034", "3.2e-15"),
/// "< 1e-300" where it is smaller than that or too small for a double, and "" where it is not known
/// (NaN). Never "0": nothing that was tested has that probability.
std::string p_of_table(double p);

/// The same with the three places that people read: "0.034", "3.2e-15", "< 1e-300", "–".
std::string p_for_people(double p);

/// A column of a table, as codebook.csv has it.
struct DescribedColumn {
  std::string table;  ///< path of the table
  std::string rows;   ///< what a row of it is
  std::string column;
  std::string unit;
  std::string meaning;
};

/// The columns of a form, of a table at `path`.
std::vector<DescribedColumn> described(const TableForm& form, std::string_view path);

std::string codebook_csv(const std::vector<DescribedColumn>& columns);

/// Writes each into the folder, which need not be there yet, under the name of its file, and
/// codebook.csv: what their columns are.
void write_tables(const std::filesystem::path& folder, const std::vector<WrittenTable>& tables);

}  // namespace mien::pipeline

#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "pipeline/base/documents/csv.h"

namespace mien::pipeline {

/// A column of a table of results.
struct Column {
  std::string_view name;
  std::string_view unit;  ///< "m", "0–1"; empty for names, texts and plain counts
  std::string_view
      meaning;  ///< a sentence without its full stop; says what positive and negative values mean
};

/// Description of a table of results, as listed in codebooks.
struct TableForm {
  std::string_view path;  ///< "metrics/distances.csv"
  std::string_view rows;  ///< what a row describes: "compared pair"
  std::span<const Column> columns;
};

/// Suffix of the declared name of a column that is repeated for each of several names: `<prefix>*`
/// becomes the columns `<prefix><name>`.
inline constexpr std::string_view column_of_each = "*";

/// The columns' names. A column declared as `factor_*` becomes one column for each of `names`.
std::vector<std::string> header_of(const TableForm& form,
                                   const std::vector<std::string>& names = {});

/// The column of that name, or null.
const Column* find_column(const TableForm& form, std::string_view name);

/// The form as a Markdown section: what a row describes, and a table of the columns.
std::string markdown_of(const TableForm& form);

/// A table as it is written.
struct WrittenTable {
  TableForm form;
  std::string csv;
};

/// "simulated" or "given": the origin of the ratings, answers or sessions on which a row is based.
std::string origin_text(bool is_simulated);

// Values as fields of tables. Numbers are the shortest decimals that read back as the same number,
// and empty if not finite; Booleans are 1 or 0; missing values are empty.

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

/// A column shared by several tables; `from` must accept the rows of each.
template <class From>
struct SharedColumn {
  std::string_view name;
  std::string_view unit;
  std::string_view meaning;
  From from;
};
template <class From>
SharedColumn(std::string_view, std::string_view, std::string_view, From) -> SharedColumn<From>;

/// A column of a table whose rows are built from `Row`s: `from` is a lambda without captures that
/// takes a Row and returns the column's value, or a vector of texts for a repeated column.
template <class Row>
struct ColumnOf : Column {
  constexpr ColumnOf() = default;

  template <class From>
  constexpr ColumnOf(std::string_view column, std::string_view of_unit, std::string_view means,
                     From)
      : Column{column, of_unit, means}, add([](const Row& row, std::vector<std::string>& fields) {
          add_field(From{}(row), fields);
        }) {
    static_assert(std::is_empty_v<From>, "a pointer to a function would be called as null");
  }

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

/// A result, and whether the ratings or answers that it is based on are simulated; a row of result
/// tables.
template <class Result>
struct WithOrigin {
  bool simulated;
  const Result& of;
};

/// Column with the origin of a row's ratings, from its member `simulated`.
inline constexpr SharedColumn whose_ratings_column{
    "ratings", "", "given (by people) or simulated",
    [](auto& r) { return origin_text(r.simulated); }};

/// The declaration of a table: one list of columns that defines header, rows and codebook.
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

  /// The description of this table. It refers to the table, which must be in static storage.
  constexpr TableForm form() const { return {path, rows, columns}; }

  std::vector<std::string> fields_of(const Row& row) const {
    std::vector<std::string> fields;
    for (const auto add_column : add) add_column(row, fields);
    return fields;
  }

  /// The table with a row for each element of `all`, a range of `Row`s. `names` complete the names
  /// of repeated columns (header_of).
  WrittenTable of(auto&& all, const std::vector<std::string>& names = {}) const {
    CsvWriter writer(header_of(form(), names));
    for (const Row& row : all) writer.row(fields_of(row));
    return {form(), writer.text()};
  }

  /// The table with a row of Row{whole, part} for each of `parts`.
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

/// A p value for tables: the shortest decimal that reads back as the same number ("0.034",
/// "3.2e-15"), "< 1e-300" for smaller values, including those that a double can only represent as
/// 0, and "" for NaN. Never "0", since no tested result has that probability.
std::string p_field(double p);

/// A p value for reports, rounded for reading: "0.034", "3.2e-15", "< 1e-300", "–" for NaN.
std::string p_label(double p);

/// A row of codebook.csv: one column of a table.
struct DescribedColumn {
  std::string table;  ///< path of the table
  std::string rows;   ///< what a row of it describes
  std::string column;
  std::string unit;
  std::string meaning;
};

/// Codebook rows for the columns of a form, for a table at `path`.
std::vector<DescribedColumn> described(const TableForm& form, std::string_view path);

std::string codebook_csv(const std::vector<DescribedColumn>& columns);

/// Writes each table to the folder, which is created if necessary, under its file name, and a
/// codebook.csv that describes their columns. Throws WriteFailure.
void write_tables(const std::filesystem::path& folder, const std::vector<WrittenTable>& tables);

}  // namespace mien::pipeline

#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/base/documents/fault.h"

namespace mien::pipeline {

/// One field and where it starts.
struct CsvField {
  std::string text;
  int line = 0;
  int column = 0;
};

/// A table with a header, RFC 4180: comma separated, quotes doubled, CRLF or LF, UTF-8 with or
/// without byte order mark. Every row has as many fields as the header. Empty lines are skipped.
/// Fields are stored without the mark of with_formula_mark.
struct CsvTable {
  std::string file;
  std::vector<CsvField> header;
  std::vector<std::vector<CsvField>> rows;
};

/// Throws Error, with line and column if it concerns the content: a file that cannot be read, text
/// that is not UTF-8, an unclosed quote, a quote within a field, text after a closing quote, a row
/// with a different number of fields, a column name that occurs twice, a repeated header, columns
/// separated by semicolons or tabs, no header.
CsvTable read_csv(const std::filesystem::path& file);
CsvTable parse_csv(std::string_view text, const std::string& file);

/// Index of a column, or −1.
int find_column(const CsvTable& table, std::string_view name);

/// Index of a column. If there is none, throws Error, which lists the existing columns.
int require_column(const CsvTable& table, std::string_view name);

/// Renames a column from its former to its present name, in tables written before the change, and
/// returns a warning. Does nothing if no column has the former name or if a column has the present
/// name already.
std::optional<Fault> rename_column(CsvTable& table, std::string_view former, std::string_view now);

/// Position of a field, for messages.
Place place_of(const CsvTable& table, const CsvField& field);

/// The field as a finite number. Throws Error.
double number_in(const CsvTable& table, const CsvField& field);

/// The numbers in a column of a table that mien wrote. Their keys are the stimuli, which are in the
/// first column. Throws Error as read_csv does, for a missing column, and for a field that is not a
/// number.
std::map<std::string, double> stimulus_numbers(const std::filesystem::path& file,
                                               std::string_view column);

/// The shortest decimal that reads back as the same double: "0.1", "-3", "1e-07", "nan"; "0" for
/// −0 too.
std::string shortest(double value);

/// Like `shortest`, for measured or computed values in metres or proportions of a scale: magnitudes
/// below 1e-12 are rounding errors and are written as "0".
std::string shortest_measured(double value);

/// Collects rows and writes them with LF line ends, quoting where necessary and marking texts that
/// a spreadsheet would evaluate (with_formula_mark).
class CsvWriter {
 public:
  explicit CsvWriter(std::vector<std::string> header);

  /// Appends a row, which must have as many fields as the header.
  void row(const std::vector<std::string>& fields);

  const std::string& text() const { return text_; }

 private:
  std::size_t width_;
  std::string text_;
};

// Spreadsheets interpret a field that begins with = + - @ (also in full width) as a formula and
// evaluate it when the table is opened (OWASP, CSV injection); some do so also if a tab or line end
// precedes the sign. Since texts of participants may be anything, a field that begins with one of
// these signs, a tab or a line end (also after spaces) is written with a leading apostrophe, which
// marks it as text in spreadsheets. Reading removes the apostrophe, so that any text, including one
// with apostrophes of its own, is preserved. Numbers, and two numbers joined by "–", are written
// unchanged. pipeline/study/page/src/questionnaire/rows.ts does the same.

/// Whether a field needs the mark. Apostrophes at its beginning, and then spaces, are ignored.
bool looks_like_formula(std::string_view field);

std::string with_formula_mark(std::string field);
std::string without_formula_mark(std::string field);

}  // namespace mien::pipeline

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
/// Fields are without the mark of with_formula_mark.
struct CsvTable {
  std::string file;
  std::vector<CsvField> header;
  std::vector<std::vector<CsvField>> rows;
};

/// Throws Error with line and column: unclosed quote, text after a quote, a row of another length,
/// a column name that occurs twice, no header.
CsvTable read_csv(const std::filesystem::path& file);
CsvTable parse_csv(std::string_view text, const std::string& file);

/// Index of a column, or −1.
int find_column(const CsvTable& table, std::string_view name);

/// Index of a column. Throws Error that lists the columns there are.
int require_column(const CsvTable& table, std::string_view name);

/// Gives a column its present name where it has its former one, of tables written before it was
/// renamed. Returns a warning then. Where there is a column of the present name, nothing is done.
std::optional<Fault> rename_column(CsvTable& table, std::string_view former, std::string_view now);

/// Where a field is, for messages.
Place place_of(const CsvTable& table, const CsvField& field);

/// The field as a finite number. Throws Error.
double number_in(const CsvTable& table, const CsvField& field);

/// The numbers in a column of a table that mien has written, by the stimulus that a row begins
/// with. Throws Error.
std::map<std::string, double> stimulus_numbers(const std::filesystem::path& file,
                                               std::string_view column);

/// The shortest decimal that reads back as the same double: "0.1", "-3", "1e-07", "nan"; "0" for
/// −0 too.
std::string shortest(double value);

/// The same of what was measured or solved for, in metres or shares of a scale: below 1e-12 nothing
/// but roundings is left, and "0" is written.
std::string shortest_measured(double value);

/// Collects rows and writes them with LF line ends, quoting where necessary and marking texts that
/// a spreadsheet would run (with_formula_mark).
class CsvWriter {
 public:
  explicit CsvWriter(std::vector<std::string> header);

  /// As many fields as the header.
  void row(const std::vector<std::string>& fields);

  const std::string& text() const { return text_; }

 private:
  std::size_t width_;
  std::string text_;
};

// Spreadsheets take a field of a table that begins with = + - @ (wide ones, a tab and a line end
// too) for a formula, and run it when the table is opened (OWASP, CSV injection). Texts of
// participants may be anything: such a field is written with an apostrophe before it, which
// spreadsheets take for "this is text". Reading takes it off again, so that any text comes back as
// it was, one with apostrophes of its own too. Numbers, and two with "–" between them, are no
// formulas and stay as they are.
// pipeline/study/page/src/questionnaire/rows.ts does the same.

/// Whether it has to be marked: whatever apostrophes and blanks it begins with are passed over.
bool is_like_formula(std::string_view field);

std::string with_formula_mark(std::string field);
std::string without_formula_mark(std::string field);

}  // namespace mien::pipeline

#include "pipeline/base/documents/csv.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <unordered_set>
#include <utility>

#include <fmt/format.h>

#include "motion/text/as_number.h"
#include "motion/text/excerpt.h"
#include "motion/text/file_contents.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/base/documents/utf8.h"

namespace mien::pipeline {

namespace {

/// Reads fields one after the other and keeps count of lines and columns (in characters).
class CsvScanner {
 public:
  CsvScanner(std::string_view text, const std::string& file) : text_(text), file_(file) {
    if (text_.starts_with("\xEF\xBB\xBF")) text_.remove_prefix(3);
  }

  bool at_end() const { return position_ == text_.size(); }

  /// The fields up to the end of the line; nothing for an empty line.
  std::vector<CsvField> row() {
    std::vector<CsvField> fields;
    if (skip_line_end()) return fields;
    while (true) {
      fields.push_back(field());
      if (at_end() || skip_line_end()) return fields;
      take();  // the comma
    }
  }

 private:
  char peek() const { return text_[position_]; }

  char take() {
    const char c = text_[position_++];
    if (c == '\n') {
      ++line_;
      column_ = 1;
    } else if ((static_cast<unsigned char>(c) & 0xC0U) != 0x80U) {
      ++column_;
    }
    return c;
  }

  bool at_line_end() const {
    return peek() == '\n' || text_.substr(position_, 2) == "\r\n" ||
           (peek() == '\r' && position_ + 1 == text_.size());
  }

  bool skip_line_end() {
    if (at_end() || !at_line_end()) return false;
    if (take() == '\r' && !at_end()) take();
    return true;
  }

  CsvField field() {
    CsvField field = written_field();
    field.text = without_formula_mark(std::move(field.text));
    return field;
  }

  CsvField written_field() {
    CsvField field{"", line_, column_};
    if (!at_end() && peek() == '"') {
      quoted(field);
    } else {
      while (!at_end() && peek() != ',' && !at_line_end()) {
        refuse_quote();
        field.text += take();
      }
    }
    return field;
  }

  void quoted(CsvField& field) {
    take();
    while (true) {
      if (at_end())
        throw Error({file_, field.line, field.column}, "a quote that is not closed",
                    "add the closing \"");
      const char c = take();
      if (c != '"') {
        field.text += c;
      } else if (!at_end() && peek() == '"') {
        field.text += take();
      } else {
        break;
      }
    }
    if (at_end() || peek() == ',' || at_line_end()) return;
    throw Error({file_, line_, column_}, "text after a closing quote",
                "write a quote inside a quoted field as \"\"");
  }

  void refuse_quote() const {
    if (peek() != '"') return;
    throw Error({file_, line_, column_}, "a quote in the middle of a field",
                "quote the whole field and write the quote as \"\"");
  }

  std::string_view text_;
  const std::string& file_;
  std::size_t position_ = 0;
  int line_ = 1;
  int column_ = 1;
};

/// Spreadsheets of some languages write ; where others write a comma.
void refuse_other_separators(const CsvTable& table) {
  if (table.header.size() > 1) return;
  for (const auto& [sign, name] : {std::pair{';', ";"}, std::pair{'\t', "tabs"}})
    if (std::ranges::count(table.header.front().text, sign) > 1)
      throw Error(place_of(table, table.header.front()),
                  fmt::format("is separated by {}, not by commas", name),
                  "save it as CSV separated by commas");
}

void refuse_repeated_columns(const CsvTable& table) {
  std::unordered_set<std::string_view> met;
  for (const CsvField& field : table.header) {
    if (met.insert(field.text).second) continue;
    throw Error(place_of(table, field),
                "the column " + motion::in_quotes(field.text) + " appears twice",
                "rename one of the two");
  }
}

/// Refuses a row that repeats the header, which results from joining files.
void refuse_header(const CsvTable& table, const std::vector<CsvField>& row) {
  if (row.size() == 1 ||
      !std::ranges::equal(row, table.header, {}, &CsvField::text, &CsvField::text))
    return;
  throw Error(place_of(table, row.front()), "the header is repeated here",
              "keep only the first one");
}

bool needs_quotes(const std::string& field) {
  return field.find_first_of(",\"\r\n") != std::string::npos || field.starts_with(' ') ||
         field.ends_with(' ');
}

std::string quoted(const std::string& field) {
  std::string text = "\"";
  for (const char c : field) text += c == '"' ? "\"\"" : std::string(1, c);
  return text + "\"";
}

std::string read_text(const std::filesystem::path& file) {
  motion::FileReading reading = motion::bytes_of_file(file, motion::max_table_bytes);
  if (reading.bytes) return *std::move(reading.bytes);
  throw Error({file.string(), 0, 0}, reading.error, "name a CSV file");
}

}  // namespace

CsvTable read_csv(const std::filesystem::path& file) {
  return parse_csv(read_text(file), file.string());
}

CsvTable parse_csv(std::string_view text, const std::string& file) {
  if (const auto position = first_invalid_utf8(text))
    throw Error({file, position->line, position->column}, "not UTF-8 text", "save it as UTF-8");
  CsvTable table;
  table.file = file;
  CsvScanner scanner(text, table.file);
  while (!scanner.at_end()) {
    std::vector<CsvField> row = scanner.row();
    if (row.empty()) continue;
    if (table.header.empty()) {
      table.header = std::move(row);
      refuse_other_separators(table);
      refuse_repeated_columns(table);
    } else if (row.size() == table.header.size()) {
      refuse_header(table, row);
      table.rows.push_back(std::move(row));
    } else {
      throw Error(place_of(table, row.front()),
                  fmt::format("{} fields where the header has {}", row.size(), table.header.size()),
                  "give every row as many fields as the header");
    }
  }
  if (table.header.empty())
    throw Error({file, 1, 1}, "the table is empty", "begin with a line of column names");
  return table;
}

int find_column(const CsvTable& table, std::string_view name) {
  for (std::size_t i = 0; i < table.header.size(); ++i)
    if (table.header[i].text == name) return static_cast<int>(i);
  return -1;
}

int require_column(const CsvTable& table, std::string_view name) {
  const int column = find_column(table, name);
  if (column >= 0) return column;
  std::vector<std::string> names;
  for (const CsvField& field : table.header) names.push_back(field.text);
  throw Error(place_of(table, table.header.front()),
              "there is no column " + motion::in_quotes(name),
              "the columns are " + motion::listed(names));
}

std::optional<Fault> rename_column(CsvTable& table, std::string_view former, std::string_view now) {
  const auto column = std::ranges::find(table.header, former, &CsvField::text);
  if (column == table.header.end() || find_column(table, now) >= 0) return std::nullopt;
  column->text = now;
  return Fault{place_of(table, *column), std::string(former), fmt::format("now called {}", now),
               "rename the column"};
}

Place place_of(const CsvTable& table, const CsvField& field) {
  return {table.file, field.line, field.column};
}

double number_in(const CsvTable& table, const CsvField& field) {
  if (const auto value = motion::as_written_number(field.text)) return *value;
  throw Error(place_of(table, field), motion::in_quotes(field.text) + " is not a number",
              "write a finite decimal number");
}

std::map<std::string, double> stimulus_numbers(const std::filesystem::path& file,
                                               std::string_view column) {
  const CsvTable table = read_csv(file);
  const auto index = static_cast<std::size_t>(require_column(table, column));
  std::map<std::string, double> numbers;
  for (const auto& row : table.rows) numbers[row[0].text] = number_in(table, row[index]);
  return numbers;
}

std::string shortest(double value) {
  std::array<char, 32> text{};
  // Adding zero turns −0 into 0.
  const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value + 0.0);
  assert(error == std::errc{});
  return {text.data(), end};
}

std::string shortest_measured(double value) {
  constexpr double roundings = 1e-12;
  return shortest(std::abs(value) < roundings ? 0.0 : value);
}

CsvWriter::CsvWriter(std::vector<std::string> header) : width_(header.size()) { row(header); }

void CsvWriter::row(const std::vector<std::string>& fields) {
  assert(fields.size() == width_);
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (i > 0) text_ += ',';
    const std::string field = with_formula_mark(fields[i]);
    text_ += needs_quotes(field) ? quoted(field) : field;
  }
  // A row of one empty field must not read back as an empty line.
  if (width_ == 1 && fields.front().empty()) text_ += "\"\"";
  text_ += '\n';
}

}  // namespace mien::pipeline

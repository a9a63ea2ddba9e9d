#include "motion/formats/table/table_rows.h"

#include <algorithm>

namespace mien::motion {

namespace {

constexpr std::size_t most_bytes_examined = std::size_t{1} << 16;
constexpr int most_lines_examined = 16;

bool is_line_end(char c) { return c == '\n' || c == '\r'; }

std::string_view trimmed(std::string_view text) {
  const auto is_blank = [](char c) { return c == ' ' || c == '\t'; };
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

bool is_comment(std::string_view line) {
  return line.starts_with('#') && !same_word(line.substr(0, 4), "#N/A");
}

/// How often each separator occurs outside quotes.
struct SeparatorCount {
  std::size_t tabs = 0;
  std::size_t semicolons = 0;
  std::size_t commas = 0;

  void add(std::string_view line) {
    bool is_quoted = false;
    for (const char c : line) {
      if (c == '"') is_quoted = !is_quoted;
      if (is_quoted) continue;
      tabs += c == '\t';
      semicolons += c == ';';
      commas += c == ',';
    }
  }
};

}  // namespace

char separator_of(std::string_view text) {
  SeparatorCount count;
  TextCursor cursor = start_of(text.substr(0, most_bytes_examined), "");
  for (int lines = 0; lines < most_lines_examined && !at_end(cursor);) {
    const std::size_t start = cursor.at;
    skip_line(cursor);
    const std::string_view line = cursor.text.substr(start, cursor.at - start);
    if (trimmed(line).empty() || is_comment(line)) continue;
    count.add(line);
    ++lines;
  }
  // A row of n numbers with decimal commas has up to n commas and n - 1 separators.
  if (count.tabs > 0 && 2 * count.tabs >= count.commas) return '\t';
  if (count.semicolons > 0 && 2 * count.semicolons >= count.commas) return ';';
  return ',';
}

TableRows::TableRows(std::string_view text, std::string file, char separator,
                     TableComments comments)
    : cursor_(start_of(text, std::move(file))), separator_(separator), comments_(comments) {}

void TableRows::refuse(std::size_t field, std::string_view wrong, std::string_view remedy) const {
  fail(cursor_, start_of_field(field), wrong, remedy);
}

bool TableRows::skip_to_row() {
  while (!at_end(cursor_)) {
    const std::size_t start = cursor_.at;
    // Tabs are separators: a line of tabs alone is a row of empty fields.
    std::size_t first = start;
    while (first < cursor_.text.size() && cursor_.text[first] == ' ') ++first;
    cursor_.at = first;
    if (at_line_end(cursor_)) {
      skip_line(cursor_);
      continue;
    }
    if (comments_ == TableComments::skipped && is_comment(cursor_.text.substr(first, 4))) {
      while (!at_line_end(cursor_)) ++cursor_.at;
      comment_ = trimmed(cursor_.text.substr(first + 1, cursor_.at - first - 1));
      skip_line(cursor_);
      continue;
    }
    row_start_ = start;
    cursor_.at = start;
    return true;
  }
  return false;
}

bool TableRows::next() {
  fields_.clear();
  starts_.clear();
  unescaped_.clear();
  comment_ = {};
  if (!skip_to_row()) return false;
  while (true) {
    take_field();
    if (at_line_end(cursor_)) break;
    ++cursor_.at;  // the separator
  }
  skip_line(cursor_);
  return true;
}

void TableRows::take_field() {
  const std::string_view text = cursor_.text;
  while (!at_end(cursor_) &&
         (text[cursor_.at] == ' ' || (text[cursor_.at] == '\t' && separator_ != '\t')))
    ++cursor_.at;
  if (fields_.size() == most_table_fields) {
    fail(cursor_, cursor_.at,
         "the row has more than " + std::to_string(most_table_fields) + " columns",
         "keep the columns of the points");
  }
  starts_.push_back(cursor_.at);
  const bool is_quoted = !at_end(cursor_) && text[cursor_.at] == '"';
  fields_.push_back(is_quoted ? quoted_field() : plain_field());
}

std::string_view TableRows::plain_field() {
  const std::string_view text = cursor_.text;
  const std::size_t start = cursor_.at;
  std::size_t at = start;
  while (at < text.size() && text[at] != separator_ && !is_line_end(text[at])) ++at;
  cursor_.at = at;
  return trimmed(text.substr(start, at - start));
}

std::string_view TableRows::quoted_field() {
  const std::string_view text = cursor_.text;
  const std::size_t open = cursor_.at;
  bool has_quotes = false;
  std::size_t close = text.find('"', open + 1);
  while (close != std::string_view::npos && text.substr(close + 1).starts_with('"')) {
    has_quotes = true;
    close = text.find('"', close + 2);
  }
  if (close == std::string_view::npos)
    fail(cursor_, open, "a quote is not closed", "close it, or obtain the file again");
  cursor_.at = close + 1;
  if (!plain_field().empty())
    fail(cursor_, close + 1, "text follows a closing quote",
         "put the whole field in quotes, and double the quotes within it");
  const std::string_view inside = text.substr(open + 1, close - open - 1);
  if (!has_quotes) return trimmed(inside);
  std::string& plain = unescaped_.emplace_back();
  for (std::size_t i = 0; i < inside.size(); ++i) {
    plain += inside[i];
    if (inside[i] == '"') ++i;
  }
  return trimmed(plain);
}

}  // namespace mien::motion

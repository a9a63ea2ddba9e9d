#include "motion/text/text_cursor.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>

namespace mien::motion {

namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
bool is_line_end(char c) { return c == '\n' || c == '\r'; }
bool is_space(char c) { return is_blank(c) || is_line_end(c); }
bool is_brace(char c) { return c == '{' || c == '}'; }
bool is_continuation(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

std::string_view word_at(const TextCursor& cursor) {
  size_t end = cursor.at;
  while (end < cursor.text.size() && !is_space(cursor.text[end]) && !is_brace(cursor.text[end])) {
    ++end;
  }
  return cursor.text.substr(cursor.at, end - cursor.at);
}

[[noreturn]] void refuse_number(const TextCursor& cursor, std::string_view meaning) {
  const std::string_view word = word_at(cursor);
  if (word.empty()) {
    fail(cursor, cursor.at, "expected a number, " + std::string(meaning),
         at_end(cursor) ? "the text ends here; the file may be truncated" : "add the number");
  }
  const bool comma = word.find(',') != std::string_view::npos;
  fail(cursor, cursor.at, in_quotes(word) + " is not a valid number, " + std::string(meaning),
       comma ? "write decimals with a point and separate numbers by spaces"
             : "give a finite decimal number below 1e12");
}

/// Numbers too small for a double are zero; std::from_chars does not distinguish them from too
/// large ones.
bool is_underflow(std::string_view word) {
  return std::abs(std::strtod(std::string(word).c_str(), nullptr)) < 1.0;
}

}  // namespace

TextCursor start_of(std::string_view text, std::string file) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  return {text, std::move(file)};
}

Place place_at(const TextCursor& cursor, size_t index) {
  int line = cursor.first_line;
  size_t line_start = 0;
  const std::string_view before = cursor.text.substr(0, index);
  for (size_t i = 0; i < before.size(); ++i) {
    const bool ends =
        before[i] == '\n' ||
        (before[i] == '\r' && (i + 1 >= cursor.text.size() || cursor.text[i + 1] != '\n'));
    if (!ends) continue;
    ++line;
    line_start = i + 1;
  }
  const std::string_view in_line = before.substr(line_start);
  const auto continued = std::count_if(in_line.begin(), in_line.end(), is_continuation);
  return {cursor.file, line, static_cast<int>(in_line.size()) - static_cast<int>(continued) + 1};
}

void fail(const TextCursor& cursor, size_t index, std::string_view wrong, std::string_view remedy) {
  const std::string_view rest = cursor.text.substr(std::min(index, cursor.text.size()));
  const bool ends_with_it = !rest.empty() && std::none_of(rest.begin(), rest.end(), is_space);
  throw Error(place_at(cursor, index), wrong,
              ends_with_it
                  ? std::string(remedy) + "; the text ends with this word and may be truncated"
                  : std::string(remedy));
}

bool same_word(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](char x, char y) { return lower(x) == lower(y); });
}

bool at_end(const TextCursor& cursor) { return cursor.at >= cursor.text.size(); }

bool at_line_end(const TextCursor& cursor) {
  return at_end(cursor) || is_line_end(cursor.text[cursor.at]);
}

void skip_blanks(TextCursor& cursor) {
  while (!at_end(cursor) && is_blank(cursor.text[cursor.at])) ++cursor.at;
}

void skip_space(TextCursor& cursor) {
  while (!at_end(cursor) && is_space(cursor.text[cursor.at])) ++cursor.at;
}

void skip_line(TextCursor& cursor) {
  while (!at_line_end(cursor)) ++cursor.at;
  if (cursor.text.substr(cursor.at).starts_with("\r\n")) ++cursor.at;
  if (!at_end(cursor)) ++cursor.at;
}

std::string_view next_word(TextCursor& cursor) {
  skip_space(cursor);
  if (at_end(cursor)) return {};
  const std::string_view word =
      is_brace(cursor.text[cursor.at]) ? cursor.text.substr(cursor.at, 1) : word_at(cursor);
  cursor.at += word.size();
  return word;
}

std::string_view next_word_on_line(TextCursor& cursor) {
  skip_blanks(cursor);
  const size_t start = cursor.at;
  while (!at_end(cursor) && !is_space(cursor.text[cursor.at])) ++cursor.at;
  return cursor.text.substr(start, cursor.at - start);
}

double parse_number(TextCursor& cursor, std::string_view meaning) {
  skip_space(cursor);
  const char* const end = cursor.text.data() + cursor.text.size();
  const char* start = cursor.text.data() + cursor.at;
  if (start + 1 < end && start[0] == '+' && start[1] != '-') ++start;
  double value = 0.0;
  const std::from_chars_result result = std::from_chars(start, end, value);
  if (result.ec == std::errc::result_out_of_range && is_underflow(word_at(cursor))) {
    value = 0.0;
  } else if (result.ec != std::errc{}) {
    refuse_number(cursor, meaning);
  }
  const bool whole = result.ptr == end || is_space(*result.ptr) || is_brace(*result.ptr);
  if (!whole || !(std::abs(value) < 1e12)) refuse_number(cursor, meaning);
  cursor.at = static_cast<size_t>(result.ptr - cursor.text.data());
  return value;
}

long parse_count(TextCursor& cursor, std::string_view meaning) {
  skip_space(cursor);
  const std::string_view word = word_at(cursor);
  std::int32_t value = -1;
  const std::from_chars_result result =
      std::from_chars(word.data(), word.data() + word.size(), value);
  if (result.ec != std::errc{} || result.ptr != word.data() + word.size() || value < 0) {
    fail(cursor, cursor.at, in_quotes(word) + " is not a valid count, " + std::string(meaning),
         "give a whole number, 0 or more");
  }
  cursor.at += word.size();
  return value;
}

}  // namespace mien::motion

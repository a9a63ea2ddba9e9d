#include <algorithm>
#include <array>

#include "pipeline/base/documents/csv.h"

namespace mien::pipeline {

namespace {

constexpr char mark = '\'';

std::string_view without_digits(std::string_view text) {
  while (!text.empty() && text.front() >= '0' && text.front() <= '9') text.remove_prefix(1);
  return text;
}

/// "-1", "+0.5", "-1e-07", or the text for a missing number.
bool is_number(std::string_view text) {
  if (text.starts_with('-') || text.starts_with('+')) text.remove_prefix(1);
  if (text == "inf" || text == "nan") return true;
  std::string_view rest = without_digits(text);
  std::size_t digits = text.size() - rest.size();
  if (rest.starts_with('.')) {
    const std::string_view after = without_digits(rest.substr(1));
    digits += rest.size() - 1 - after.size();
    rest = after;
  }
  if (digits == 0) return false;
  if (rest.empty()) return true;
  if (rest.front() != 'e' && rest.front() != 'E') return false;
  rest.remove_prefix(1);
  if (rest.starts_with('-') || rest.starts_with('+')) rest.remove_prefix(1);
  return !rest.empty() && without_digits(rest).empty();
}

/// A number, or a range as written in tables: "-1–1". Spreadsheets do not interpret that dash as a
/// sign.
bool is_of_numbers(std::string_view text) {
  constexpr std::string_view dash = "–";
  const std::size_t at = text.find(dash);
  if (at == std::string_view::npos) return is_number(text);
  return is_number(text.substr(0, at)) && is_number(text.substr(at + dash.size()));
}

}  // namespace

bool looks_like_formula(std::string_view field) {
  constexpr std::array<std::string_view, 11> beginnings = {
      "=", "+", "-", "@", "\t", "\r", "\n", "\uFF1D", "\uFF0B", "\uFF0D", "\uFF20"};
  field.remove_prefix(std::min(field.find_first_not_of(mark), field.size()));
  field.remove_prefix(std::min(field.find_first_not_of(' '), field.size()));
  return std::ranges::any_of(beginnings, [&](auto one) { return field.starts_with(one); }) &&
         !is_of_numbers(field);
}

std::string with_formula_mark(std::string field) {
  if (looks_like_formula(field)) field.insert(field.begin(), mark);
  return field;
}

std::string without_formula_mark(std::string field) {
  if (field.starts_with(mark) && looks_like_formula(field)) field.erase(field.begin());
  return field;
}

}  // namespace mien::pipeline

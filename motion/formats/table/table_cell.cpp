#include "motion/formats/table/table_cell.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <string>

#include "motion/text/text_cursor.h"

namespace mien::motion {

namespace {

constexpr std::size_t most_digits = 64;

TableCell number_or_text(double value) {
  if (std::isnan(value)) return {TableCell::missing, 0.0};
  if (!(std::abs(value) < 1e12)) return {TableCell::text, 0.0};
  return {TableCell::number, value};
}

/// The whole field as a number with a decimal point; a text if it is none.
TableCell plain_number(std::string_view field) {
  if (field.starts_with('+') && !field.starts_with("+-")) field.remove_prefix(1);
  double value = 0.0;
  const char* const end = field.data() + field.size();
  const auto [stop, error] = std::from_chars(field.data(), end, value);
  if (stop != end || field.empty()) return {TableCell::text, 0.0};
  if (error == std::errc{}) return number_or_text(value);
  // Too small for a double is zero; std::from_chars does not distinguish it from too large.
  const bool is_tiny = error == std::errc::result_out_of_range && field.size() <= most_digits &&
                       std::abs(std::strtod(std::string(field).c_str(), nullptr)) < 1.0;
  return {is_tiny ? TableCell::number : TableCell::text, 0.0};
}

bool is_missing_word(std::string_view field) {
  constexpr std::array<std::string_view, 5> words = {"na", "n/a", "#n/a", "null", "none"};
  return std::ranges::any_of(words, [&](std::string_view word) { return same_word(field, word); });
}

bool has_one_comma(std::string_view field) {
  return field.size() <= most_digits && std::ranges::count(field, ',') == 1 &&
         field.find('.') == std::string_view::npos;
}

}  // namespace

TableCell read_cell(std::string_view field, DecimalMarks& marks) {
  if (field.empty()) return {};
  const TableCell plain = plain_number(field);
  if (plain.kind != TableCell::text) {
    if (marks.may_be_commas && field.find('.') != std::string_view::npos) marks.has_points = true;
    return plain;
  }
  if (marks.may_be_commas && has_one_comma(field)) {
    std::array<char, most_digits> digits{};
    std::ranges::replace_copy(field, digits.begin(), ',', '.');
    const TableCell with_comma = plain_number({digits.data(), field.size()});
    if (with_comma.kind == TableCell::number) marks.has_commas = true;
    return with_comma;
  }
  return {is_missing_word(field) ? TableCell::missing : TableCell::text, 0.0};
}

}  // namespace mien::motion

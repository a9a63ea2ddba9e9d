#include "motion/formats/fbx/fbx_words.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <string>
#include <system_error>

namespace mien::motion {

std::int64_t as_integer(double number) {
  if (!(std::abs(number) < 9.2e18)) return 0;
  return static_cast<std::int64_t>(number);
}

bool is_fbx_separator(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\v' || c == '\f' || c == ',';
}

void skip_fbx_separators(std::string_view& text) {
  size_t i = 0;
  while (i < text.size()) {
    if (text[i] == ';') {
      i = std::min(text.find_first_of("\r\n", i), text.size());
    } else if (is_fbx_separator(text[i])) {
      ++i;
    } else {
      break;
    }
  }
  text.remove_prefix(i);
}

std::string_view fbx_word(std::string_view text) {
  size_t i = 0;
  while (i < text.size() && !is_fbx_separator(text[i]) && text[i] != '"' && text[i] != ';') ++i;
  return text.substr(0, std::max<size_t>(i, 1));
}

const char* parse_fbx_decimal(const char* start, const char* end, double& number) {
  if (start + 1 < end && *start == '+' && start[1] != '-') ++start;
  const std::from_chars_result result = std::from_chars(start, end, number);
  if (result.ec == std::errc::result_out_of_range) {
    const std::string word(start, result.ptr);
    number = std::strtod(word.c_str(), nullptr);
    return std::abs(number) < 1.0 ? result.ptr : nullptr;
  }
  return result.ec == std::errc{} ? result.ptr : nullptr;
}

}  // namespace mien::motion

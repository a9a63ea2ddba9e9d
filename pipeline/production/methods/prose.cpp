#include "pipeline/production/methods/prose.h"

#include <algorithm>

#include <fmt/format.h>

namespace mien::pipeline {

std::string count_of(std::size_t count, const std::string& one, const std::string& many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

std::string listed(const Names& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) text += i + 1 == names.size() ? " and " : ", ";
    text += names[i];
  }
  return text;
}

std::string sentence_start(const std::string& sentence) {
  const std::size_t end = sentence.find_first_not_of("0123456789");
  if (end == 0 || end == std::string::npos || sentence[end] != ' ') return sentence;
  if (end > 2) return "A total of " + sentence;
  constexpr const char* small[] = {"Zero",    "One",     "Two",       "Three",    "Four",
                                   "Five",    "Six",     "Seven",     "Eight",    "Nine",
                                   "Ten",     "Eleven",  "Twelve",    "Thirteen", "Fourteen",
                                   "Fifteen", "Sixteen", "Seventeen", "Eighteen", "Nineteen"};
  constexpr const char* units[] = {"",      "-one", "-two",   "-three", "-four",
                                   "-five", "-six", "-seven", "-eight", "-nine"};
  constexpr const char* tens[] = {"Twenty", "Thirty",  "Forty",  "Fifty",
                                  "Sixty",  "Seventy", "Eighty", "Ninety"};
  const int number = std::stoi(sentence.substr(0, end));
  const std::string words =
      number < 20 ? small[number] : std::string(tens[number / 10 - 2]) + units[number % 10];
  return words + sentence.substr(end);
}

void add_once(Names& names, const std::string& name) {
  if (std::ranges::find(names, name) == names.end()) names.push_back(name);
}

void Range::add(double value) {
  least = std::min(least, value);
  most = std::max(most, value);
  sum += value;
  ++count;
}

std::string range_text(const Range& range, int digits, const std::string& unit) {
  const std::string least = fmt::format("{:.{}f}", range.least, digits);
  const std::string most = fmt::format("{:.{}f}", range.most, digits);
  return least == most ? least + unit : "from " + least + " to " + most + unit;
}

std::string with_mean(const Range& range, int digits, const std::string& unit) {
  const std::string text = range_text(range, digits, unit);
  if (!text.starts_with("from ")) return text;
  return fmt::format("{} (mean {:.{}f}{})", text, range.mean(), digits, unit);
}

}  // namespace mien::pipeline

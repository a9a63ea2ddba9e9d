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

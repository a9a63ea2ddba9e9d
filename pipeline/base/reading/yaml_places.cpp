#include "pipeline/base/reading/yaml_places.h"

#include <algorithm>

#include "pipeline/base/documents/utf8.h"

namespace mien::pipeline {

YamlPlaces::YamlPlaces(std::string_view text, const std::string& file) : text_(text), file_(file) {
  if (text_.starts_with("\xEF\xBB\xBF")) text_.remove_prefix(3);
  std::string_view rest = text_;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find('\n'), rest.size() - 1) + 1;
    lines_.push_back(rest.substr(0, end));
    rest.remove_prefix(end);
  }
}

Place YamlPlaces::at(const YAML::Mark& mark) const {
  const auto column = static_cast<std::size_t>(mark.column);
  const bool goes_on = mark.line == last_.line && column >= last_.bytes;
  if (!goes_on) last_ = {mark.line, 0, 0};
  const std::string_view before = line(mark.line + 1).substr(0, column);
  last_.characters += count_characters(before.substr(std::min(last_.bytes, before.size())));
  last_.bytes = before.size();
  return {file_, mark.line + 1, static_cast<int>(last_.characters) + 1};
}

std::string_view YamlPlaces::line(int number) const {
  const auto index = static_cast<std::size_t>(number - 1);
  return index < lines_.size() ? lines_[index] : std::string_view();
}

std::string_view YamlPlaces::text_from(const YAML::Mark& mark) const {
  const std::string_view here = line(mark.line + 1);
  const auto column = static_cast<std::size_t>(mark.column);
  if (column >= here.size()) return {};
  return text_.substr(static_cast<std::size_t>(here.data() - text_.data()) + column);
}

}  // namespace mien::pipeline

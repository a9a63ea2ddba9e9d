#include "pipeline/study/studio/yaml_text.h"

#include <algorithm>
#include <cctype>
#include <set>
#include <string_view>

namespace mien::pipeline {

namespace {

using nlohmann::ordered_json;

/// Whether a text is itself in YAML, whatever it stands in.
bool is_itself(const std::string& text) {
  static const std::set<std::string> words = {"true", "false", "null", "yes", "no",
                                              "on",   "off",   "y",    "n"};
  if (text.empty() || std::isalpha(static_cast<unsigned char>(text[0])) == 0) return false;
  for (const unsigned char letter : text) {
    if (std::isalnum(letter) == 0 &&
        std::string_view("-_./").find(static_cast<char>(letter)) == std::string_view::npos)
      return false;
  }
  std::string lower = text;
  for (char& letter : lower) letter = static_cast<char>(std::tolower(letter));
  return !words.contains(lower);
}

std::string without_variables(std::string text) {
  for (std::size_t at = text.find("${"); at != std::string::npos; at = text.find("${", at + 3))
    text.insert(at, "$");
  return text;
}

/// JSON strings are YAML.
std::string text_line(const std::string& text) {
  return is_itself(text) ? text : quoted_yaml(text, '"');
}

}  // namespace

std::string quoted_yaml(const std::string& text, char quote) {
  const std::string plain = without_variables(text);
  const bool is_one_line = plain.find_first_of("\n\r\t") == std::string::npos;
  if (quote != '\'' || !is_one_line) return ordered_json(plain).dump();
  std::string quoted = "'";
  for (const char letter : plain) {
    quoted += letter;
    if (letter == '\'') quoted += letter;
  }
  return quoted + "'";
}

std::string yaml_line(const ordered_json& value) {
  if (value.is_string()) return text_line(value.get<std::string>());
  if (!value.is_structured()) return value.dump();
  std::string parts;
  for (const auto& [key, one] : value.items()) {
    if (!parts.empty()) parts += ", ";
    parts += value.is_object() ? text_line(key) + ": " + yaml_line(one) : yaml_line(one);
  }
  return value.is_object() ? "{" + parts + "}" : "[" + parts + "]";
}

std::string yaml_lines(const ordered_json& value, std::size_t indent, std::size_t width) {
  std::string line = yaml_line(value);
  if (!value.is_structured() || value.empty() || line.size() <= width) return line;
  const std::string margin = "\n" + std::string(indent, ' ');
  std::string lines;
  for (const auto& [key, one] : value.items()) {
    if (!lines.empty()) lines += margin;
    if (value.is_array()) {
      lines += "- " + yaml_lines(one, indent + 2, width);
      continue;
    }
    const std::string name = text_line(key) + ":";
    const std::string below = yaml_lines(one, indent + 2, width);
    const bool is_below = below.find('\n') != std::string::npos;
    lines += name + (is_below ? margin + "  " : " ") + below;
  }
  return lines;
}

std::string yaml_member(const std::string& name, const ordered_json& value, std::size_t column) {
  const std::size_t head = column + name.size() + 2;
  const std::string line = yaml_line(value);
  if (head + line.size() <= yaml_width) return yaml_line(name) + ": " + line;
  ordered_json map = ordered_json::object();
  map[name] = value;
  return yaml_lines(map, column, yaml_width - std::min(column, yaml_width));
}

std::string yaml_element(const ordered_json& value, std::size_t column) {
  if (!value.is_object() || value.empty())
    return yaml_lines(value, column, yaml_width - std::min(column, yaml_width));
  std::string lines;
  for (const auto& [key, one] : value.items()) {
    if (!lines.empty()) lines += "\n" + std::string(column, ' ');
    lines += yaml_member(key, one, column);
  }
  return lines;
}

}  // namespace mien::pipeline

#include "pipeline/farm/block_yaml.h"

#include <sstream>

#include <nlohmann/json.hpp>

namespace mien::pipeline {

namespace {

using nlohmann::ordered_json;

void add_map(const ordered_json& map, const std::string& indent, bool begins_row,
             std::string& text);

/// A text of lines each of which ends, and which YAML may not take for anything else.
bool is_block(const ordered_json& value) {
  if (!value.is_string()) return false;
  const std::string& text = value.get_ref<const std::string&>();
  if (!text.ends_with('\n') || text.ends_with("\n\n") || text.front() == ' ' ||
      text.front() == '\n') {
    return false;
  }
  return text.find_first_of("\t\r\x7f") == std::string::npos;
}

void add_block(const std::string& value, const std::string& indent, std::string& text) {
  text += " |\n";
  std::istringstream lines(value);
  for (std::string line; std::getline(lines, line);) text += indent + "  " + line + "\n";
}

bool has_maps(const ordered_json& value) {
  return value.is_array() && !value.empty() && value.front().is_object();
}

void add_value(const ordered_json& value, const std::string& indent, std::string& text) {
  if (value.is_object() && !value.empty()) {
    text += '\n';
    add_map(value, indent + "  ", false, text);
  } else if (has_maps(value)) {
    text += '\n';
    for (const ordered_json& row : value) {
      text += indent + "  - ";
      add_map(row, indent + "    ", true, text);
    }
  } else if (is_block(value)) {
    add_block(value.get<std::string>(), indent, text);
  } else {
    text += " " + value.dump() + "\n";  // JSON is YAML
  }
}

/// `begins_row`: the first key stands behind the dash of a list.
void add_map(const ordered_json& map, const std::string& indent, bool begins_row,
             std::string& text) {
  for (const auto& [key, value] : map.items()) {
    if (!begins_row) text += indent;
    begins_row = false;
    text += key + ":";
    add_value(value, indent, text);
  }
}

}  // namespace

std::string block_yaml(const ordered_json& map) {
  std::string text;
  add_map(map, "", false, text);
  return text;
}

}  // namespace mien::pipeline

#include "pipeline/manifest/reading/manifest_yaml.h"

#include <cctype>
#include <set>

#include "pipeline/base/reading/field_writer.h"
#include "pipeline/manifest/look/point_form.h"

namespace mien::pipeline {

namespace {

/// Whether a text is itself in YAML: neither a number nor a word with another meaning.
bool is_plain(const std::string& text) {
  static const std::set<std::string> words = {"true", "false", "null", "yes", "no",
                                              "on",   "off",   "y",    "n"};
  if (text.empty() || std::isalpha(static_cast<unsigned char>(text[0])) == 0) return false;
  for (const unsigned char letter : text) {
    if (std::isalnum(letter) == 0 && letter != '-' && letter != '_') return false;
  }
  return !words.contains(text);
}

/// JSON strings are YAML; "${" would begin a variable.
std::string text_of(std::string text) {
  if (is_plain(text)) return text;
  for (std::size_t at = text.find("${"); at != std::string::npos; at = text.find("${", at + 3))
    text.insert(at, "$");
  return nlohmann::json(text).dump();
}

/// On one line: {a: 1, b: [2, 3]}.
std::string line_of(const OrderedJson& value) {
  if (value.is_string()) return text_of(value.get<std::string>());
  if (!value.is_structured()) return value.dump();
  std::string parts;
  for (const auto& [key, one] : value.items()) {
    if (!parts.empty()) parts += ", ";
    parts += value.is_object() ? text_of(key) + ": " + line_of(one) : line_of(one);
  }
  return value.is_object() ? "{" + parts + "}" : "[" + parts + "]";
}

/// Rows of maps stand below each other, everything else on the key's line.
std::string part_of(const std::string& key, const OrderedJson& value) {
  const bool is_rows = value.is_array() && !value.empty() && value[0].is_object();
  if (!is_rows) return key + ": " + line_of(value) + "\n";
  std::string text = "\n" + key + ":\n";
  for (const OrderedJson& row : value) text += "  - " + line_of(row) + "\n";
  return text;
}

}  // namespace

std::string manifest_yaml(const Manifest& manifest, const std::filesystem::path& folder) {
  OrderedJson map = written(manifest, WritingOptions{.folder = folder.empty() ? "." : folder});
  if (map.contains("examples") && !map["examples"].contains("set")) map.erase("examples");
  std::string text;
  for (const auto& [key, value] : map.items()) text += part_of(key, value);
  return text;
}

}  // namespace mien::pipeline

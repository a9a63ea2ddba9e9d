#include "pipeline/base/documents/environment.h"

#include <cstdlib>

#include "pipeline/base/documents/utf8.h"

namespace mien::pipeline {

namespace {

bool is_name(std::string_view text) {
  if (text.empty() || (text[0] >= '0' && text[0] <= '9')) return false;
  for (const char c : text) {
    const bool letter = (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_';
    if (!letter && !(c >= '0' && c <= '9')) return false;
  }
  return true;
}

/// Appends the value of "NAME" or "NAME:-default".
void append_value(std::string_view inside, const Environment& environment, Expansion& result) {
  const std::size_t mark = inside.find(":-");
  const std::string name(inside.substr(0, mark));
  if (!is_name(name)) {
    result.wrong = "\"${" + std::string(inside) + "}\" is not a valid environment variable";
    result.remedy = "write ${NAME} or ${NAME:-default}";
    return;
  }
  const std::optional<std::string> value = environment(name);
  if (value && first_invalid_utf8(*value)) {
    result.wrong = "the environment variable " + name + " is not UTF-8 text";
    result.remedy = "set it to another value";
  } else if (mark != std::string_view::npos) {
    result.text += value && !value->empty() ? *value : std::string(inside.substr(mark + 2));
  } else if (value) {
    result.text += *value;
  } else {
    result.wrong = "the environment variable " + name + " is not set";
    result.remedy = "set it, or write ${" + name + ":-default}";
  }
}

}  // namespace

Environment process_environment() {
  return [](const std::string& name) -> std::optional<std::string> {
    const char* value = std::getenv(name.c_str());
    if (value == nullptr) return std::nullopt;
    return value;
  };
}

Expansion expand(std::string_view text, const Environment& environment) {
  Expansion result;
  while (!text.empty() && result.wrong.empty()) {
    const std::size_t start = text.find("${");
    result.text += text.substr(0, start);
    if (start == std::string_view::npos) break;
    if (start > 0 && text[start - 1] == '$') {
      result.text += '{';
      text.remove_prefix(start + 2);
      continue;
    }
    text.remove_prefix(start + 2);
    const std::size_t end = text.find('}');
    if (end == std::string_view::npos) {
      result.wrong = "\"${\" without \"}\"";
      result.remedy = "close it, or write \"$${\" for the characters themselves";
      break;
    }
    result.expanded = true;
    append_value(text.substr(0, end), environment, result);
    text.remove_prefix(end + 1);
  }
  return result;
}

}  // namespace mien::pipeline

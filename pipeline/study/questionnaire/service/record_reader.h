#pragma once

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "pipeline/base/documents/utf8.h"
#include "pipeline/study/questionnaire/service/record.h"

namespace mien::pipeline {

inline constexpr std::size_t max_name_characters = 64;
inline constexpr std::size_t max_parameter_characters = 200;
inline constexpr std::size_t max_comment_characters = 10'000;
inline constexpr double max_ms = 7.0 * 24 * 3600 * 1000;  // a week
inline constexpr double max_count = 1e6;

/// Reads the members of a JSON object. Every function throws RecordFault for a missing required
/// member, a wrong type, or a value out of range.
class RecordReader {
 public:
  explicit RecordReader(const nlohmann::json& text, const char* what) : text_(text), what_(what) {
    if (!text.is_object()) throw RecordFault(fmt::format("{} is not an object", what));
  }

  const nlohmann::json* find(const char* name) {
    read_members_.insert(name);
    const auto found = text_.find(name);
    return found == text_.end() || found->is_null() ? nullptr : &*found;
  }

  const nlohmann::json& required(const char* name) {
    const nlohmann::json* value = find(name);
    if (value == nullptr) throw RecordFault(fmt::format("{} has no \"{}\"", what_, name));
    return *value;
  }

  std::string name(const char* member) {
    const std::string value = string_of(required(member), member, max_name_characters);
    const bool is_plain = std::ranges::all_of(value, [](unsigned char one) {
      return std::isalnum(one) != 0 || one == '-' || one == '_' || one == '.' || one == ':';
    });
    if (value.empty() || !is_plain)
      throw RecordFault(fmt::format("\"{}\" is not a valid name", member));
    return value;
  }

  std::string text(const char* member, std::size_t longest) {
    const nlohmann::json* value = find(member);
    return value == nullptr ? std::string() : string_of(*value, member, longest);
  }

  std::optional<double> amount(const char* member, double most) {
    const nlohmann::json* value = find(member);
    if (value == nullptr) return std::nullopt;
    const double number =
        value->is_number() ? value->get<double>() : std::numeric_limits<double>::quiet_NaN();
    if (!(number >= 0.0 && number <= most))
      throw RecordFault(fmt::format("\"{}\" is not a number from 0 to {}", member, most));
    return number;
  }

  std::optional<int> count(const char* member) {
    const std::optional<double> number = amount(member, max_count);
    if (!number) return std::nullopt;
    if (*number != std::floor(*number))
      throw RecordFault(fmt::format("\"{}\" is not a whole number", member));
    return static_cast<int>(*number);
  }

  double required_amount(const char* member, double most) {
    required(member);
    return *amount(member, most);
  }

  bool boolean(const char* member) {
    const nlohmann::json& value = required(member);
    if (!value.is_boolean())
      throw RecordFault(fmt::format("\"{}\" is neither true nor false", member));
    return value.get<bool>();
  }

  /// Throws RecordFault if the object has members that were not read.
  void finish() const {
    for (const auto& [member, value] : text_.items())
      if (!read_members_.contains(member))
        throw RecordFault(fmt::format("{} has an unknown member", what_));
  }

 private:
  static std::string string_of(const nlohmann::json& value, const char* member,
                               std::size_t longest) {
    if (!value.is_string()) throw RecordFault(fmt::format("\"{}\" is not text", member));
    const std::string& text = value.get_ref<const std::string&>();
    if (count_characters(text) > longest)
      throw RecordFault(fmt::format("\"{}\" has more than {} characters", member, longest));
    return text;
  }

  const nlohmann::json& text_;
  const char* what_;
  std::set<std::string> read_members_;
};

}  // namespace mien::pipeline

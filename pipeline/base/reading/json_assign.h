#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>

#include <nlohmann/json.hpp>

#include "pipeline/base/documents/words.h"

namespace mien::pipeline {

// Reading values of a document that the schema has been held against: what has another type was
// told there, and leaves the target as it is.

/// The member, or nullptr.
inline const nlohmann::json* member(const nlohmann::json& object, const char* key) {
  if (!object.is_object()) return nullptr;
  const auto found = object.find(key);
  return found == object.end() ? nullptr : &*found;
}

inline void assign(const nlohmann::json* value, std::string& target) {
  if (value != nullptr && value->is_string()) target = value->get<std::string>();
}

inline void assign(const nlohmann::json* value, bool& target) {
  if (value != nullptr && value->is_boolean()) target = value->get<bool>();
}

inline void assign(const nlohmann::json* value, double& target) {
  if (value != nullptr && value->is_number()) target = value->get<double>();
}

inline void assign(const nlohmann::json* value, float& target) {
  if (value != nullptr && value->is_number()) target = value->get<float>();
}

inline void assign(const nlohmann::json* value, int& target) {
  if (value == nullptr || !value->is_number_integer()) return;
  const auto number = value->get<std::int64_t>();
  if (std::in_range<int>(number)) target = static_cast<int>(number);
}

inline void assign(const nlohmann::json* value, std::uint64_t& target) {
  if (value == nullptr || !value->is_number_integer() || *value < 0) return;
  target = value->get<std::uint64_t>();
}

template <class Number, std::size_t Count>
void assign(const nlohmann::json* value, std::array<Number, Count>& target) {
  if (value == nullptr || !value->is_array() || value->size() != Count) return;
  for (std::size_t i = 0; i < Count; ++i) assign(&(*value)[i], target[i]);
}

/// A number, or an array of numbers.
template <class Value>
void assign(const nlohmann::json* value, std::optional<Value>& target) {
  if (value == nullptr || value->is_number() != std::is_arithmetic_v<Value>) return;
  Value read{};
  assign(value, read);
  target = read;
}

template <class Enum>
inline void assign(const nlohmann::json* value, Enum& target, Words<Enum> words) {
  if (value == nullptr || !value->is_string()) return;
  for (const auto& [word, meaning] : words)
    if (*value == word) target = meaning;
}

}  // namespace mien::pipeline

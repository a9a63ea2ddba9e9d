#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <utility>

#include <nlohmann/json.hpp>

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

inline void assign(const nlohmann::json* value, int& target) {
  if (value == nullptr || !value->is_number_integer()) return;
  const auto number = value->get<std::int64_t>();
  if (std::in_range<int>(number)) target = static_cast<int>(number);
}

inline void assign(const nlohmann::json* value, std::uint64_t& target) {
  if (value == nullptr || !value->is_number_integer() || *value < 0) return;
  target = value->get<std::uint64_t>();
}

inline void assign(const nlohmann::json* value, std::array<int, 2>& target) {
  if (value == nullptr || !value->is_array() || value->size() != 2) return;
  assign(&(*value)[0], target[0]);
  assign(&(*value)[1], target[1]);
}

template <class Enum>
using Words = std::initializer_list<std::pair<const char*, Enum>>;

template <class Enum>
inline void assign(const nlohmann::json* value, Enum& target, Words<Enum> words) {
  if (value == nullptr || !value->is_string()) return;
  for (const auto& [word, meaning] : words) {
    if (*value == word) target = meaning;
  }
}

}  // namespace mien::pipeline

#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "motion/text/words.h"
#include "pipeline/base/reading/field_values.h"
#include "pipeline/base/reading/yaml_json.h"

namespace mien::pipeline {

// Reads values of a document that has been checked against the schema. A value of the wrong type,
// which that check has reported, leaves the target unchanged.

/// The member with that key, or null.
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

/// An optional number from a number, or an optional array from an array.
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
  target = meaning_of(words, value->get_ref<const std::string&>()).value_or(target);
}

/// How values of a type that has neither fields nor an `assign` are written in documents.
template <class Value>
struct ValueCodec;

template <>
struct ValueCodec<std::filesystem::path> {
  static void read(const DocumentValue& given, std::filesystem::path& value) {
    std::string text;
    assign(&given.value, text);
    if (!text.empty()) value = given.context.resolve(text);
  }
  static OrderedJson write(const std::filesystem::path& value, const WritingOptions& how) {
    if (value.empty()) return {};
    if (how.for_key) {
      if (how.files != nullptr) how.files->push_back(value);
      return value.filename().generic_string();
    }
    if (how.folder.empty()) return value.generic_string();
    return std::filesystem::proximate(std::filesystem::absolute(value),
                                      std::filesystem::absolute(how.folder))
        .generic_string();
  }
};

/// Values by name, in the order of the document.
template <class Value>
struct ValueCodec<std::vector<std::pair<std::string, Value>>> {
  static void read(const DocumentValue& given, std::vector<std::pair<std::string, Value>>& value) {
    if (!given.value.is_object()) return;
    value.clear();
    for (const std::string& key : written_order(given.value, given.path, given.context.places)) {
      const DocumentValue member{given.value[key], member_path(given.path, key), given.context};
      Value read_value{};
      pipeline::read(member, read_value);
      value.emplace_back(key, std::move(read_value));
    }
  }
  static OrderedJson write(const std::vector<std::pair<std::string, Value>>& value,
                           const WritingOptions& how) {
    if (value.empty()) return {};
    OrderedJson map = OrderedJson::object();
    for (const auto& [key, one] : value) map[key] = written(one, how);
    return map;
  }
};

/// Absent from the document if unset.
template <class Value>
struct ValueCodec<std::optional<Value>> {
  static void read(const DocumentValue& given, std::optional<Value>& value) {
    const nlohmann::json& json = given.value;
    if (std::is_arithmetic_v<Value> && !json.is_number() && !json.is_boolean()) return;
    Value read_value{};
    pipeline::read(given, read_value);
    value = std::move(read_value);
  }
  static OrderedJson write(const std::optional<Value>& value, const WritingOptions& how) {
    return value ? written(*value, how) : OrderedJson();
  }
};

/// An array, which replaces the previous elements.
template <class Value>
struct ValueCodec<std::vector<Value>> {
  static void read(const DocumentValue& given, std::vector<Value>& value) {
    if (!given.value.is_array()) return;
    value.clear();
    for (std::size_t i = 0; i < given.value.size(); ++i) {
      value.emplace_back();
      pipeline::read({given.value[i], element_path(given.path, i), given.context}, value.back());
    }
  }
  static OrderedJson write(const std::vector<Value>& value, const WritingOptions& how) {
    if (value.empty()) return {};
    OrderedJson array = OrderedJson::array();
    for (const Value& one : value) array.push_back(written(one, how));
    return array;
  }
};

template <class Value>
concept HasCodec = requires(const DocumentValue& given, Value& value) {
  ValueCodec<Value>::read(given, value);
};

}  // namespace mien::pipeline

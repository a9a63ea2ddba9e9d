#pragma once

#include <map>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "pipeline/base/reading/field_values.h"

namespace mien::pipeline {

/// Collects the paths and concerns of all options that a struct declares in its `fields_of`.
/// Elements of arrays are denoted by "[]": "stimuli[].output.presentation.card.text".
class FieldNames {
 public:
  explicit FieldNames(std::string prefix = "", unsigned inherited = concerns::nothing)
      : prefix_(std::move(prefix)), inherited_(inherited) {}

  /// Path → concerns; concerns::nothing for a map that only groups other options.
  const std::map<std::string, unsigned>& names() const { return names_; }

  template <class Value>
  void operator()(const char* key, Value&, unsigned concerned) {
    add(key, concerned);
    walk<std::remove_const_t<Value>>(key, concerned);
  }

  template <class Enum>
  void operator()(const char* key, Enum&, unsigned concerned, Words<std::remove_const_t<Enum>>) {
    add(key, concerned);
  }

  void group(const char* key, auto&& walk_group) {
    add(key, concerns::nothing);
    nested(key, inherited_, walk_group);
  }

  void whole(const char* key, auto& value, unsigned concerned) { (*this)(key, value, concerned); }

  template <class Element, class Prototype>
  void each(const char* key, std::vector<Element>&, unsigned concerned, Prototype&&) {
    add(key, concerned);
    walk<Element>(std::string(key) + "[]", concerned);
  }

  template <class Value, class Form>
  void by(const char* key, Value&, unsigned concerned, Form) {
    add(key, concerned);
    if constexpr (requires(FieldNames & inner) { Form::walk(inner); })
      nested(key, concerned, [](FieldNames& inner) { Form::walk(inner); });
  }

  template <class Value, class Form>
  void inside(Value&, unsigned, Form) {
    Form::walk(*this);
  }

  void add(const std::string& key, unsigned concerned) { names_[prefix_ + key] |= concerned; }
  /// Adds an option with the concerns of the enclosing one.
  void add(const std::string& key) { add(key, inherited_); }

  /// Adds the options of a struct at this level.
  template <class Value>
  void of() {
    Value value{};
    fields_of(*this, value);
  }

 private:
  template <class Value>
  struct ElementOf {};
  template <class Value>
  struct ElementOf<std::vector<Value>> {
    using Type = Value;
    static constexpr const char* mark = "[]";
  };
  template <class Value>
  struct ElementOf<std::optional<Value>> {
    using Type = Value;
    static constexpr const char* mark = "";
  };

  void nested(const std::string& key, unsigned concerned, auto&& walk_inner) {
    FieldNames inner(prefix_ + key + ".", concerned);
    walk_inner(inner);
    for (const auto& [path, concern] : inner.names_) names_[path] |= concern;
  }

  template <class Value>
  void walk(const std::string& key, unsigned concerned) {
    if constexpr (HasFields<Value>) {
      nested(key, concerned, [](FieldNames& inner) { inner.of<Value>(); });
    } else if constexpr (requires { typename ElementOf<Value>::Type; }) {
      walk<typename ElementOf<Value>::Type>(key + ElementOf<Value>::mark, concerned);
    }
  }

  std::string prefix_;
  unsigned inherited_;
  std::map<std::string, unsigned> names_;
};

}  // namespace mien::pipeline

#pragma once

#include <vector>

#include "pipeline/base/reading/field_values.h"
#include "pipeline/base/reading/value_codecs.h"

namespace mien::pipeline {

/// Merges a map into a struct: options that the map does not contain stay unchanged.
class FieldReader {
 public:
  explicit FieldReader(const DocumentValue& given) : given_(given) {}

  void operator()(const char* key, auto& value, unsigned concerned) {
    with(key, concerned, [&](const DocumentValue& member) { read(member, value); });
  }

  template <class Enum>
  void operator()(const char* key, Enum& value, unsigned concerned, Words<Enum> words) {
    with(key, concerned, [&](const DocumentValue& member) { assign(&member.value, value, words); });
  }

  void group(const char* key, auto&& walk) {
    with(key, concerns::nothing, [&](const DocumentValue& member) {
      FieldReader inner(member);
      walk(inner);
    });
  }

  template <class Value>
  void whole(const char* key, Value& value, unsigned concerned) {
    with(key, concerned, [&](const DocumentValue& member) {
      value = Value{};
      read(member, value);
    });
  }

  template <class Element, class Prototype>
  void each(const char* key, std::vector<Element>& list, unsigned concerned,
            Prototype&& prototype) {
    with(key, concerned, [&](const DocumentValue& member) {
      if (!member.value.is_array()) return;
      list.clear();
      for (std::size_t i = 0; i < member.value.size(); ++i) {
        list.push_back(prototype());
        read({member.value[i], element_path(member.path, i), member.context}, list.back());
      }
    });
  }

  template <class Value, class Form>
  void by(const char* key, Value& value, unsigned concerned, Form) {
    with(key, concerned, [&](const DocumentValue& member) { Form::read(member, value); });
  }

  template <class Value, class Form>
  void inside(Value& value, unsigned, Form) {
    Form::read(given_, value);
  }

 private:
  void with(const char* key, unsigned concerned, auto&& use) {
    if (!given_.value.is_object()) {
      if ((concerned & concerns::alone) != 0) use(given_);
      return;
    }
    const auto found = given_.value.find(key);
    if (found != given_.value.end()) use({*found, member_path(given_.path, key), given_.context});
  }

  const DocumentValue& given_;
};
template <class Value>
void read(const DocumentValue& given, Value& value) {
  if constexpr (HasFields<Value>) {
    FieldReader reader(given);
    fields_of(reader, value);
  } else if constexpr (HasCodec<Value>) {
    ValueCodec<Value>::read(given, value);
  } else {
    assign(&given.value, value);
  }
}

}  // namespace mien::pipeline

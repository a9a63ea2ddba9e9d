#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "pipeline/documents/concerns.h"
#include "pipeline/documents/places.h"
#include "pipeline/reading/json_assign.h"
#include "pipeline/reading/yaml_json.h"

namespace mien::pipeline {

// What walks the lists of options (concerns.h).

/// Text that is written in a fixed order.
using OrderedJson = nlohmann::ordered_json;

/// What reading a document needs beside its values.
struct ReadingContext {
  const Places& places;  ///< they tell in which order the members of a map were written
  std::function<std::filesystem::path(const std::string&)> resolve;  ///< from the document's folder
};

/// A value of a document that the schema has been held against.
struct Given {
  const nlohmann::json& value;
  std::string path;  ///< "stimuli[2].output"
  const ReadingContext& context;
};

/// How values are written: as a document says them, or for the key of an artifact. There, a file
/// counts by its name and contents: the name is written, and the file is added to `files`.
struct Writing {
  bool for_key = false;
  std::vector<std::filesystem::path>* files = nullptr;
  std::filesystem::path folder = {};  ///< of the document; paths are written from there
};

class FieldNames;

template <class Value>
concept HasFields = requires(FieldNames& names, Value& value) {
  fields_of(names, value);
};

// Reading ---------------------------------------------------------------------------------------

template <class Value>
void read(const Given& given, Value& value);

/// Lays a map over a struct: what it does not name stays as it is.
class FieldReader {
 public:
  explicit FieldReader(const Given& given) : given_(given) {}

  template <class Value>
  void operator()(const char* key, Value& value, unsigned concerned) {
    with(key, concerned, [&](const Given& member) { read(member, value); });
  }

  template <class Enum>
  void operator()(const char* key, Enum& value, unsigned concerned, Words<Enum> words) {
    with(key, concerned, [&](const Given& member) { assign(&member.value, value, words); });
  }

  template <class Walk>
  void group(const char* key, Walk&& walk) {
    with(key, concerns::nothing, [&](const Given& member) {
      FieldReader inner(member);
      walk(inner);
    });
  }

  template <class Value>
  void whole(const char* key, Value& value, unsigned concerned) {
    with(key, concerned, [&](const Given& member) {
      value = Value{};
      read(member, value);
    });
  }

  template <class Element, class Prototype>
  void each(const char* key, std::vector<Element>& list, unsigned concerned,
            Prototype&& prototype) {
    with(key, concerned, [&](const Given& member) {
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
    with(key, concerned, [&](const Given& member) { Form::read(member, value); });
  }

  template <class Value, class Form>
  void inside(Value& value, unsigned, Form) {
    Form::read(given_, value);
  }

 private:
  template <class Use>
  void with(const char* key, unsigned concerned, Use&& use) {
    if (!given_.value.is_object()) {
      if ((concerned & concerns::alone) != 0) use(given_);
      return;
    }
    const auto found = given_.value.find(key);
    if (found != given_.value.end()) use({*found, member_path(given_.path, key), given_.context});
  }

  const Given& given_;
};

/// How a type that has neither fields nor an `assign` (json_assign.h) stands in documents.
template <class Value>
struct ValueForm;

template <>
struct ValueForm<std::filesystem::path> {
  static void read(const Given& given, std::filesystem::path& value) {
    std::string text;
    assign(&given.value, text);
    if (!text.empty()) value = given.context.resolve(text);
  }
  static OrderedJson write(const std::filesystem::path& value, const Writing& how) {
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

/// Numbers by name, in the order of the document.
template <class Value>
struct ValueForm<std::vector<std::pair<std::string, Value>>> {
  static void read(const Given& given, std::vector<std::pair<std::string, Value>>& value) {
    if (!given.value.is_object()) return;
    value.clear();
    for (const std::string& key : written_order(given.value, given.path, given.context.places)) {
      const Given member{given.value[key], member_path(given.path, key), given.context};
      Value read_value{};
      pipeline::read(member, read_value);
      value.emplace_back(key, std::move(read_value));
    }
  }
  static OrderedJson write(const std::vector<std::pair<std::string, Value>>& value,
                           const Writing& how);
};

/// Unset where the document says nothing.
template <class Value>
struct ValueForm<std::optional<Value>> {
  static void read(const Given& given, std::optional<Value>& value) {
    const nlohmann::json& json = given.value;
    if (std::is_arithmetic_v<Value> && !json.is_number() && !json.is_boolean()) return;
    Value read_value{};
    pipeline::read(given, read_value);
    value = std::move(read_value);
  }
  static OrderedJson write(const std::optional<Value>& value, const Writing& how);
};

/// An array in place of what was there.
template <class Value>
struct ValueForm<std::vector<Value>> {
  static void read(const Given& given, std::vector<Value>& value) {
    if (!given.value.is_array()) return;
    value.clear();
    for (std::size_t i = 0; i < given.value.size(); ++i) {
      value.emplace_back();
      pipeline::read({given.value[i], element_path(given.path, i), given.context}, value.back());
    }
  }
  static OrderedJson write(const std::vector<Value>& value, const Writing& how);
};

/// A struct of truth values as an array of the names of those that are true.
template <class Flags>
struct WordSet {
  static void read(const Given& given, Flags& flags) {
    if (!given.value.is_array()) return;
    fields_of(
        [&](const char* word, bool& flag, unsigned) {
          flag = std::find(given.value.begin(), given.value.end(), word) != given.value.end();
        },
        flags);
  }
  static OrderedJson write(const Flags& flags, const Writing&) {
    OrderedJson words = OrderedJson::array();
    fields_of(
        [&](const char* word, bool flag, unsigned) {
          if (flag) words.push_back(word);
        },
        flags);
    return words;
  }
};

template <class Value>
concept HasForm = requires(const Given& given, Value& value) {
  ValueForm<Value>::read(given, value);
};

template <class Value>
void read(const Given& given, Value& value) {
  if constexpr (HasFields<Value>) {
    FieldReader reader(given);
    fields_of(reader, value);
  } else if constexpr (HasForm<Value>) {
    ValueForm<Value>::read(given, value);
  } else {
    assign(&given.value, value);
  }
}

// Writing ---------------------------------------------------------------------------------------

/// What a struct says of one option.
struct FieldEntry {
  std::string path;  ///< within the struct: "presentation.card.text"
  unsigned concerns = concerns::nothing;
  OrderedJson value;                         ///< null where it says nothing
  std::vector<std::filesystem::path> files;  ///< for a key: that it names
};

template <class Value>
OrderedJson written(const Value& value, const Writing& how);

/// Writes down everything that a struct says, option by option.
class FieldWriter {
 public:
  explicit FieldWriter(const Writing& how, std::string prefix = "")
      : how_(how), prefix_(std::move(prefix)) {}

  std::vector<FieldEntry> take() { return std::move(entries_); }

  template <class Value>
  void operator()(const char* key, const Value& value, unsigned concerns) {
    if constexpr (HasFields<const Value>) {
      nested(key, [&](FieldWriter& inner) { fields_of(inner, value); });
    } else {
      add(key, concerns, [&](const Writing& how) { return written(value, how); });
    }
  }

  template <class Enum>
  void operator()(const char* key, const Enum& value, unsigned concerns, Words<Enum> words) {
    for (const auto& [word, meaning] : words) {
      if (meaning == value) add(key, concerns, [&](const Writing&) { return OrderedJson(word); });
    }
  }

  template <class Walk>
  void group(const char* key, Walk&& walk) {
    nested(key, walk);
  }

  template <class Value>
  void whole(const char* key, const Value& value, unsigned concerns) {
    add(key, concerns, [&](const Writing& how) { return written(value, how); });
  }

  template <class Element, class Prototype>
  void each(const char* key, const std::vector<Element>& list, unsigned concerns,
            Prototype&& prototype);

  template <class Value, class Form>
  void by(const char* key, const Value& value, unsigned concerns, Form) {
    add(key, concerns, [&](const Writing& how) { return Form::write(value, how); });
  }

  template <class Value, class Form>
  void inside(const Value& value, unsigned concerns, Form) {
    const OrderedJson map = Form::write(value, how_);
    for (const auto& [key, member] : map.items())
      entries_.push_back({prefix_ + key, concerns, member, {}});
  }

 private:
  template <class Walk>
  void nested(const char* key, Walk&& walk) {
    FieldWriter inner(how_, prefix_ + key + ".");
    walk(inner);
    for (FieldEntry& entry : inner.take()) entries_.push_back(std::move(entry));
  }

  template <class Write>
  void add(const char* key, unsigned concerns, Write&& write) {
    FieldEntry entry{prefix_ + key, concerns, {}, {}};
    Writing how = how_;
    how.files = &entry.files;
    entry.value = write(how);
    entries_.push_back(std::move(entry));
  }

  const Writing& how_;
  std::string prefix_;
  std::vector<FieldEntry> entries_;
};

template <class Value>
std::vector<FieldEntry> entries_of(const Value& value, const Writing& how) {
  FieldWriter writer(how);
  fields_of(writer, value);
  return writer.take();
}

/// The entries in which one list says something else than the other, which is of the same struct,
/// and those that are always written.
std::vector<FieldEntry> differences(std::vector<FieldEntry> entries,
                                    const std::vector<FieldEntry>& base);

/// Entries as a map of maps.
OrderedJson nested_map(const std::vector<FieldEntry>& entries);

/// What is to be written so that `value` is read when it is laid over `base`.
template <class Value>
OrderedJson written_over(const Value& value, const Value& base, const Writing& how) {
  std::vector<FieldEntry> entries = differences(entries_of(value, how), entries_of(base, how));
  if (how.files != nullptr) {
    for (const FieldEntry& entry : entries)
      how.files->insert(how.files->end(), entry.files.begin(), entry.files.end());
  }
  return nested_map(entries);
}

template <class Value>
OrderedJson written(const Value& value, const Writing& how) {
  if constexpr (HasFields<const Value>) {
    return written_over(value, Value{}, how);
  } else if constexpr (HasForm<Value>) {
    return ValueForm<Value>::write(value, how);
  } else {
    static_assert(std::is_arithmetic_v<Value> || std::is_same_v<Value, std::string> ||
                  std::is_same_v<Value, std::array<int, 2>> ||
                  std::is_same_v<Value, std::array<int, 4>>);
    return value;
  }
}

template <class Value>
OrderedJson ValueForm<std::vector<std::pair<std::string, Value>>>::write(
    const std::vector<std::pair<std::string, Value>>& value, const Writing& how) {
  if (value.empty()) return {};
  OrderedJson map = OrderedJson::object();
  for (const auto& [key, one] : value) map[key] = written(one, how);
  return map;
}

template <class Value>
OrderedJson ValueForm<std::optional<Value>>::write(const std::optional<Value>& value,
                                                   const Writing& how) {
  return value ? written(*value, how) : OrderedJson();
}

template <class Value>
OrderedJson ValueForm<std::vector<Value>>::write(const std::vector<Value>& value,
                                                 const Writing& how) {
  if (value.empty()) return {};
  OrderedJson array = OrderedJson::array();
  for (const Value& one : value) array.push_back(written(one, how));
  return array;
}

template <class Element, class Prototype>
void FieldWriter::each(const char* key, const std::vector<Element>& list, unsigned concerns,
                       Prototype&& prototype) {
  add(key, concerns, [&](const Writing& how) {
    OrderedJson array;
    for (const Element& one : list) array.push_back(written_over(one, Element(prototype()), how));
    return array;
  });
}

// Names -----------------------------------------------------------------------------------------

/// Collects the paths of all options that a list knows and what they concern, elements of arrays as
/// "[]": "stimuli[].output.presentation.card.text".
class FieldNames {
 public:
  explicit FieldNames(std::string prefix = "", unsigned inherited = concerns::nothing)
      : prefix_(std::move(prefix)), inherited_(inherited) {}

  /// Path → what it concerns. Of a map that stands around others it is nothing by itself.
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

  template <class Walk>
  void group(const char* key, Walk&& walk_group) {
    add(key, concerns::nothing);
    nested(key, inherited_, walk_group);
  }

  template <class Value>
  void whole(const char* key, Value& value, unsigned concerned) {
    (*this)(key, value, concerned);
  }

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
  /// What concerns the same as the option around it.
  void add(const std::string& key) { add(key, inherited_); }

  /// The options of a struct, as if they stood here.
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

  template <class Walk>
  void nested(const std::string& key, unsigned concerned, Walk&& walk_inner) {
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

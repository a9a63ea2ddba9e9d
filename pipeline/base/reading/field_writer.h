#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "pipeline/base/reading/field_values.h"
#include "pipeline/base/reading/value_codecs.h"

namespace mien::pipeline {

/// The value of one option of a struct.
struct FieldEntry {
  std::string path;  ///< within the struct: "presentation.card.text"
  unsigned concerns = concerns::nothing;
  OrderedJson value;                         ///< null if omitted
  std::vector<std::filesystem::path> files;  ///< for an artifact's key: files named by the value
};

/// Writes all options of a struct.
class FieldWriter {
 public:
  /// Adds what it writes to `entries`.
  FieldWriter(const WritingOptions& how, std::vector<FieldEntry>& entries, std::string prefix = "")
      : how_(how), entries_(entries), prefix_(std::move(prefix)) {}

  template <class Value>
  void operator()(const char* key, const Value& value, unsigned concerns) {
    if constexpr (HasFields<const Value>) {
      nested(key, [&](FieldWriter& inner) { fields_of(inner, value); });
    } else {
      add(key, concerns, [&](const WritingOptions& how) { return written(value, how); });
    }
  }

  template <class Enum>
  void operator()(const char* key, const Enum& value, unsigned concerns, Words<Enum> words) {
    for (const auto& [word, meaning] : words)
      if (meaning == value)
        add(key, concerns, [&said = word](const WritingOptions&) { return OrderedJson(said); });
  }

  void group(const char* key, auto&& walk) { nested(key, walk); }

  void whole(const char* key, const auto& value, unsigned concerns) {
    add(key, concerns, [&](const WritingOptions& how) { return written(value, how); });
  }

  template <class Element, class Prototype>
  void each(const char* key, const std::vector<Element>& list, unsigned concerns,
            Prototype&& prototype);

  template <class Value, class Form>
  void by(const char* key, const Value& value, unsigned concerns, Form) {
    add(key, concerns, [&](const WritingOptions& how) { return Form::write(value, how); });
  }

  template <class Value, class Form>
  void inside(const Value& value, unsigned concerns, Form) {
    if (!is_selected(concerns)) return;
    const OrderedJson map = Form::write(value, of_members());
    for (const auto& [key, member] : map.items())
      entries_.push_back({prefix_ + key, concerns, member, {}});
  }

 private:
  void nested(const char* key, auto&& walk) {
    FieldWriter inner(how_, entries_, prefix_ + key + ".");
    walk(inner);
  }

  bool is_selected(unsigned concerns) const {
    if (how_.for_key && (concerns & concerns::unkeyed) != 0) return false;
    return how_.concerned == concerns::everything || (concerns & how_.concerned) != 0;
  }

  /// Members of a selected option are all written.
  WritingOptions of_members() const {
    WritingOptions how = how_;
    how.concerned = concerns::everything;
    return how;
  }

  void add(const char* key, unsigned concerns, auto&& write) {
    if (!is_selected(concerns)) return;
    FieldEntry entry{prefix_ + key, concerns, {}, {}};
    WritingOptions how = of_members();
    how.files = &entry.files;
    entry.value = write(how);
    entries_.push_back(std::move(entry));
  }

  const WritingOptions& how_;
  std::vector<FieldEntry>& entries_;
  std::string prefix_;
};

std::vector<FieldEntry> entries_of(const auto& value, const WritingOptions& how) {
  constexpr std::size_t usual_count = 64;
  std::vector<FieldEntry> entries;
  entries.reserve(usual_count);
  FieldWriter writer(how, entries);
  fields_of(writer, value);
  return entries;
}

/// The entries whose value differs from that of the entry of `base` with the same path, and those
/// that are always written; entries without a value (null) are omitted. `base` has the entries of
/// another value of the same struct. Fast if both are in the same order.
std::vector<FieldEntry> differences(std::vector<FieldEntry> entries,
                                    const std::vector<FieldEntry>& base);

/// Entries as a map of maps.
OrderedJson nested_map(const std::vector<FieldEntry>& entries);

/// The map that, merged into the value whose entries are `base`, results in `value`.
OrderedJson written_over(const auto& value, const std::vector<FieldEntry>& base,
                         const WritingOptions& how) {
  const std::vector<FieldEntry> entries = differences(entries_of(value, how), base);
  if (how.files != nullptr)
    for (const FieldEntry& entry : entries)
      how.files->insert(how.files->end(), entry.files.begin(), entry.files.end());
  return nested_map(entries);
}

template <class Value>
OrderedJson written(const Value& value, const WritingOptions& how) {
  if constexpr (HasFields<const Value>) {
    return written_over(value, entries_of(Value{}, how), how);
  } else if constexpr (HasCodec<Value>) {
    return ValueCodec<Value>::write(value, how);
  } else {
    static_assert(std::is_arithmetic_v<Value> || std::is_same_v<Value, std::string> ||
                  std::is_same_v<Value, std::array<int, 2>> ||
                  std::is_same_v<Value, std::array<double, 2>> ||
                  std::is_same_v<Value, std::array<std::string, 2>> ||
                  std::is_same_v<Value, std::array<int, 4>>);
    return value;
  }
}
template <class Element, class Prototype>
void FieldWriter::each(const char* key, const std::vector<Element>& list, unsigned concerns,
                       Prototype&& prototype) {
  add(key, concerns, [&](const WritingOptions& how) {
    OrderedJson array;
    const std::vector<FieldEntry> base = entries_of(Element(prototype()), how);
    for (const Element& one : list) array.push_back(written_over(one, base, how));
    return array;
  });
}

}  // namespace mien::pipeline

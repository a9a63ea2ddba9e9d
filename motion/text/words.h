#pragma once

#include <algorithm>
#include <cassert>
#include <initializer_list>
#include <optional>
#include <string_view>
#include <type_traits>
#include <utility>

namespace mien {

/// Words used in a document or table, with the values that they represent.
template <class Enum>
using Words = std::initializer_list<std::pair<const char*, Enum>>;

/// The first word for `value`. There must be one: otherwise an assertion fails, or the result is
/// empty if assertions are disabled.
template <class Enum>
std::string_view word_of(Words<Enum> words, std::type_identity_t<Enum> value) {
  const auto found = std::find_if(words.begin(), words.end(),
                                  [&](const auto& known) { return known.second == value; });
  assert(found != words.end());
  if (found == words.end()) return {};
  return found->first;
}

/// The value of a word; nothing if the word is unknown.
template <class Enum>
std::optional<Enum> meaning_of(Words<Enum> words, std::string_view word) {
  const auto found = std::find_if(words.begin(), words.end(),
                                  [&](const auto& known) { return known.first == word; });
  return found == words.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace mien

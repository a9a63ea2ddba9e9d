#pragma once

#include <algorithm>
#include <cassert>
#include <initializer_list>
#include <optional>
#include <string_view>
#include <type_traits>
#include <utility>

namespace mien {

/// Words of a document or table, and what they mean.
template <class Enum>
using Words = std::initializer_list<std::pair<const char*, Enum>>;

/// The first word that means `value`; there must be one: without it an assertion fails, and the
/// word is empty where assertions are off.
template <class Enum>
std::string_view word_of(Words<Enum> words, std::type_identity_t<Enum> value) {
  const auto found = std::find_if(words.begin(), words.end(),
                                  [&](const auto& known) { return known.second == value; });
  assert(found != words.end());
  if (found == words.end()) return {};
  return found->first;
}

/// What a word means; nothing where it is none of them.
template <class Enum>
std::optional<Enum> meaning_of(Words<Enum> words, std::string_view word) {
  const auto found = std::find_if(words.begin(), words.end(),
                                  [&](const auto& known) { return known.first == word; });
  return found == words.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace mien

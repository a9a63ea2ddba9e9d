#pragma once

#include <algorithm>
#include <cassert>
#include <initializer_list>
#include <string_view>
#include <type_traits>
#include <utility>

namespace mien {

/// Words of a document or table, and what they mean.
template <class Enum>
using Words = std::initializer_list<std::pair<const char*, Enum>>;

/// The first word that means `value`; there must be one.
template <class Enum>
std::string_view word_of(Words<Enum> words, std::type_identity_t<Enum> value) {
  const auto found = std::ranges::find(words, value, [](const auto& word) { return word.second; });
  assert(found != words.end());
  return found->first;
}

}  // namespace mien

#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace mien::pipeline {

/// A reference for a method.
struct Reference {
  std::string_view key;     ///< "rose1998"
  std::string_view label;   ///< citation in running text: "Rose, Cohen and Bodenheimer 1998"
  std::string_view bibtex;  ///< fields of its BibTeX entry, without the key
  std::string_view kind = "article";
  /// What is known of a work whose author, title or year is not, and what is missing: it cannot be
  /// cited and has no entry. Empty for others.
  std::string_view missing = {};
};

/// Returns all references that studies may name.
std::span<const Reference> all_references();

/// Returns the reference with that key, or nullptr.
const Reference* find_reference(std::string_view key);

/// Returns a BibTeX file with the entries of these keys, without duplicates, in the order of
/// all_references(), and an entry for the program itself.
std::string bibtex_of(const std::vector<std::string>& keys);

}  // namespace mien::pipeline

#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace mien::pipeline {

/// A work that a method is from.
struct Reference {
  std::string_view key;     ///< "rose1998"
  std::string_view label;   ///< as it is cited in a text: "Rose, Cohen and Bodenheimer 1998"
  std::string_view bibtex;  ///< the fields of its entry, after the key
  std::string_view kind = "article";
};

/// All that studies may rest on, by year. Where a source could not be identified whole, its `note`
/// says what is missing.
std::span<const Reference> all_references();

/// Nullptr without one of that key.
const Reference* find_reference(std::string_view key);

/// The entries of these keys as a BibTeX file, each once, in the order of all_references(), with
/// one for the program itself.
std::string bibtex_of(const std::vector<std::string>& keys);

}  // namespace mien::pipeline

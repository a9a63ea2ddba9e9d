#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "pipeline/base/documents/fault.h"
#include "pipeline/base/documents/places.h"

namespace mien::pipeline {

/// What a word or phrase says of a motion: an end of a scale.
struct WordMeaning {
  std::string scale;  ///< id
  int end = 0;        ///< −1 low, +1 high

  bool operator==(const WordMeaning&) const = default;
};

/// Words of degree, which modify the word that follows them.
enum class Grade { strengthened, softened, negated };

/// A language in which participants wrote. All keys are folded phrases.
struct Language {
  std::string name;                          ///< "finnish"
  std::vector<std::string> called;           ///< as participants name it: "suomi"
  std::map<std::string, Grade> grades;       ///< "very", "a little", "not"
  std::map<std::string, WordMeaning> words;  ///< "slowly"
};

/// Words of several languages and where on a study's scales they lie.
struct Lexicon {
  std::vector<Language> languages;
};

/// A phrase as the lexicon compares it: compatibility forms unified (NFKC), case folded, quotation
/// marks and backslashes left out, white space made single spaces. `text` is UTF-8.
std::string folded(std::string_view text);

/// The language that participants call so, or nullptr.
const Language* find_language(const Lexicon& lexicon, std::string_view called);

/// The members `languages` and `words` of a scales file that keeps its schema; an empty lexicon
/// without them. Adds faults: words of an unknown scale or language, a phrase that has two
/// meanings in a language, a name that two languages claim, words without languages.
Lexicon lexicon_from(const nlohmann::json& document, const std::vector<std::string>& scales,
                     const Places& places, std::vector<Fault>& faults);

}  // namespace mien::pipeline

#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "pipeline/base/documents/fault.h"
#include "pipeline/base/documents/places.h"

namespace mien::pipeline {

/// The meaning of a word or phrase: an end of a scale.
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
  std::vector<std::string> called;           ///< names used by participants: "suomi"
  std::map<std::string, Grade> grades;       ///< "very", "a little", "not"
  std::map<std::string, WordMeaning> words;  ///< "slowly"
};

/// Words of several languages and their positions on a study's scales.
struct Lexicon {
  std::vector<Language> languages;
};

/// Returns a phrase in the form in which the lexicon compares it: NFKC-normalized and case-folded,
/// without straight double quotation marks (") and backslashes, and with single spaces. `text` is
/// UTF-8.
std::string folded(std::string_view text);

/// Returns the language that participants call `called`, or nullptr.
const Language* find_language(const Lexicon& lexicon, std::string_view called);

/// Returns the lexicon in the members `languages` and `words` of a scales file that conforms to its
/// schema; it is empty if they are absent. Adds faults for words of an unknown scale or language, a
/// phrase with two meanings in one language, a name claimed by two languages, and words without
/// languages.
Lexicon lexicon_from(const nlohmann::json& document, const std::vector<std::string>& scales,
                     const Places& places, std::vector<Fault>& faults);

}  // namespace mien::pipeline

#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "pipeline/manifest/ratings/words/lexicon.h"

namespace mien::pipeline {

/// The position of a motion on a scale, as stated by a phrase.
struct Mention {
  std::string scale;   ///< id
  double value = 0.0;  ///< −2 … 2: ±1 unmodified, softened or negated, ±2 strengthened
};

/// The interpretation of a phrase.
struct PhraseReading {
  std::vector<Mention> mentions;
  /// For a phrase that consists only of degree modifiers: how they modify the verb.
  std::vector<Grade> degree;
  std::vector<std::pair<std::string, std::string>> respelled;  ///< as written, as read

  bool is_read() const { return !mentions.empty() || !degree.empty(); }
};

/// Interprets the text of one field. Commas, semicolons and slashes separate phrases. A phrase is
/// read from left to right; at each word, the longest matching entry of the lexicon is used.
/// Entries of all languages match, because participants mix languages; of equally long ones, that
/// of the participant's own language is preferred. Degree modifiers and negations apply to the next
/// word that has a position on a scale; a negated word counts 1 towards the opposite end, even if
/// strengthened. A word of at least seven letters with one letter too many or too few, or with two
/// letters transposed, is corrected to an entry of the participant's language that has the same
/// first letter, provided that all such entries have the same meaning. Other words are ignored.
PhraseReading read_phrase(std::string_view text, const Lexicon& lexicon, const Language& language);

/// Returns the value of a mention of `end` (−1 or +1) after its degree modifiers have been applied.
double graded(int end, const std::vector<Grade>& degree);

}  // namespace mien::pipeline

#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "pipeline/manifest/ratings/words/lexicon.h"

namespace mien::pipeline {

/// A phrase's position of a motion on a scale.
struct Mention {
  std::string scale;   ///< id
  double value = 0.0;  ///< −2 … 2: ±1 as said, ±2 strengthened; softened is ±1 too
};

/// The meaning that was read from a phrase.
struct PhraseReading {
  std::vector<Mention> mentions;
  /// Of a phrase of nothing but words of degree, which say how the verb is meant.
  std::vector<Grade> degree;
  std::vector<std::pair<std::string, std::string>> respelled;  ///< as written, as read

  bool is_read() const { return !mentions.empty() || !degree.empty(); }
};

/// Reads what a participant wrote in one field. Commas, semicolons and slashes separate phrases;
/// within one, the longest entry of the lexicon counts, first of the participant's own language,
/// then of the others, for people mix them. Words of degree and negations belong to the next word
/// that places the motion; a negation turns it to the scale's other end, unstrengthened. A word of
/// seven letters or more that has one letter too many or too few or two exchanged, but not the
/// first, is read as that entry of its own language if all such entries mean the same. Other words
/// are passed over.
PhraseReading read_phrase(std::string_view text, const Lexicon& lexicon, const Language& language);

/// The value that words of degree make of a mention of `end` (−1 or +1).
double graded(int end, const std::vector<Grade>& degree);

}  // namespace mien::pipeline

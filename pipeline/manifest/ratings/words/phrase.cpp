#include "pipeline/manifest/ratings/words/phrase.h"

#include <algorithm>
#include <optional>

#include "motion/text/nearest_word.h"
#include "pipeline/base/documents/utf8.h"

namespace mien::pipeline {

namespace {

constexpr std::size_t shortest_respelled = 7;  // letters

std::vector<std::vector<std::string>> parts_of(std::string_view text) {
  std::vector<std::vector<std::string>> parts(1);
  std::string word;
  const auto end_word = [&] {
    if (!word.empty()) parts.back().push_back(std::exchange(word, {}));
  };
  for (const char c : folded(text)) {
    const bool ends_part = c == ',' || c == ';' || c == '/';
    const bool ends_word = c == ' ' || c == '.' || c == '!' || c == '?';
    if (!ends_part && !ends_word) {
      word += c;
      continue;
    }
    end_word();
    if (ends_part) parts.emplace_back();
  }
  end_word();
  return parts;
}

std::string joined(const std::vector<std::string>& words, std::size_t first, std::size_t count) {
  std::string phrase = words[first];
  for (std::size_t i = 1; i < count; ++i) phrase += ' ' + words[first + i];
  return phrase;
}

const WordMeaning* meaning_of(const std::string& phrase, const Lexicon& lexicon,
                              const Language& language) {
  const auto own = language.words.find(phrase);
  if (own != language.words.end()) return &own->second;
  for (const Language& other : lexicon.languages) {
    const auto entry = other.words.find(phrase);
    if (entry != other.words.end()) return &entry->second;
  }
  return nullptr;
}

std::optional<Grade> grade_of(const std::string& phrase, const Lexicon& lexicon,
                              const Language& language) {
  const auto own = language.grades.find(phrase);
  if (own != language.grades.end()) return own->second;
  for (const Language& other : lexicon.languages) {
    const auto entry = other.grades.find(phrase);
    if (entry != other.grades.end()) return entry->second;
  }
  return std::nullopt;
}

/// A letter too many, one too few, or two exchanged. Another letter makes another word too easily:
/// wandering, wondering.
bool is_misspelling(const std::string& word, const std::string& entry) {
  if (entry.front() != word.front() || motion::edit_distance(word, entry) != 1) return false;
  return entry.size() != word.size() ||
         std::is_permutation(word.begin(), word.end(), entry.begin());
}

/// The entry of which a word is a misspelling, if it is unambiguous.
const std::string* respelled(const std::string& word, const Language& language) {
  if (count_characters(word) < shortest_respelled) return nullptr;
  const std::string* found = nullptr;
  for (const auto& [entry, meaning] : language.words) {
    if (!is_misspelling(word, entry)) continue;
    if (found != nullptr && !(language.words.at(*found) == meaning)) return nullptr;
    if (found == nullptr) found = &entry;
  }
  return found;
}

class PartReader {
 public:
  PartReader(const std::vector<std::string>& words, const Lexicon& lexicon,
             const Language& language, PhraseReading& reading)
      : words_(words), lexicon_(lexicon), language_(language), reading_(reading) {}

  void read() {
    bool only_grades = !words_.empty();
    std::vector<Grade> degree;
    std::size_t at = 0;
    while (at < words_.size()) {
      const std::size_t used = take(at, degree);
      only_grades = only_grades && used > 0 && !placed_;
      at += std::max<std::size_t>(used, 1);
    }
    if (only_grades) reading_.degree = degree;
  }

 private:
  /// How many words the entry at `at` takes; 0 where there is none.
  std::size_t take(std::size_t at, std::vector<Grade>& degree) {
    placed_ = false;
    for (std::size_t count = words_.size() - at; count > 0; --count) {
      const std::string phrase = joined(words_, at, count);
      if (const WordMeaning* meaning = meaning_of(phrase, lexicon_, language_)) {
        place(*meaning, degree);
        return count;
      }
      if (const auto grade = grade_of(phrase, lexicon_, language_)) {
        degree.push_back(*grade);
        return count;
      }
    }
    if (const std::string* entry = respelled(words_[at], language_)) {
      reading_.respelled.emplace_back(words_[at], *entry);
      place(language_.words.at(*entry), degree);
      return 1;
    }
    return 0;
  }

  void place(const WordMeaning& meaning, std::vector<Grade>& degree) {
    reading_.mentions.push_back({meaning.scale, graded(meaning.end, degree)});
    degree.clear();
    placed_ = true;
  }

  const std::vector<std::string>& words_;
  const Lexicon& lexicon_;
  const Language& language_;
  PhraseReading& reading_;
  bool placed_ = false;
};

}  // namespace

PhraseReading read_phrase(std::string_view text, const Lexicon& lexicon, const Language& language) {
  PhraseReading reading;
  for (const auto& part : parts_of(text)) PartReader(part, lexicon, language, reading).read();
  return reading;
}

double graded(int end, const std::vector<Grade>& degree) {
  const auto has = [&](Grade grade) {
    return std::find(degree.begin(), degree.end(), grade) != degree.end();
  };
  if (has(Grade::negated)) return -end;
  const bool strengthened = has(Grade::strengthened) && !has(Grade::softened);
  return strengthened ? 2.0 * end : end;
}

}  // namespace mien::pipeline

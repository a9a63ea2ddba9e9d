#include "pipeline/manifest/ratings/answers/word_answers.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <fmt/format.h>

#include "motion/text/excerpt.h"
#include "pipeline/manifest/ratings/words/phrase.h"

namespace mien::pipeline {

namespace {

constexpr double strongest = 2.0;  // of a mention

/// One row, read.
struct Understood {
  std::string participant;
  std::string stimulus;
  std::map<std::string, double> values;  ///< by scale
};

/// The columns that matter.
struct WordColumns {
  std::size_t participant = 0;
  std::size_t language = 0;
  std::size_t stimulus = 0;
  int verb = -1;
  std::vector<std::size_t> modifiers;
};

WordColumns columns_of(const CsvTable& table) {
  WordColumns columns;
  columns.participant = static_cast<std::size_t>(require_column(table, "participant"));
  columns.language = static_cast<std::size_t>(require_column(table, "language"));
  const int stimulus = find_column(table, "stimulus");
  columns.stimulus =
      static_cast<std::size_t>(stimulus >= 0 ? stimulus : require_column(table, "motion"));
  columns.verb = find_column(table, "verb");
  for (int number = 1;; ++number) {
    const int column = find_column(table, fmt::format("modifier{}", number));
    if (column < 0) break;
    columns.modifiers.push_back(static_cast<std::size_t>(column));
  }
  return columns;
}

using WordTally = std::map<std::pair<std::string, std::string>, WordCount>;

void count(WordTally& tally, const std::string& language, const std::string& text,
           const std::string& as = "") {
  WordCount& entry = tally[{language, text}];
  entry.language = language;
  entry.text = text;
  entry.as = as;
  ++entry.count;
}

std::vector<WordCount> most_frequent_first(const WordTally& tally) {
  std::vector<WordCount> counts;
  for (const auto& [key, entry] : tally) counts.push_back(entry);
  std::stable_sort(counts.begin(), counts.end(),
                   [](const WordCount& a, const WordCount& b) { return a.count > b.count; });
  return counts;
}

class WordsReader {
 public:
  WordsReader(const CsvTable& table, const ScaleSet& scales)
      : table_(table), lexicon_(scales.lexicon), columns_(columns_of(table)) {
    for (const Language& language : lexicon_.languages)
      coverage_.push_back({.language = language.name});
  }

  void read() {
    std::set<std::pair<std::string, std::string>> seen;
    for (const auto& row : table_.rows) {
      const CsvField& stimulus = row[columns_.stimulus];
      const std::string& participant = row[columns_.participant].text;
      if (!seen.emplace(participant, stimulus.text).second) {
        throw Error(place_of(table_, stimulus),
                    fmt::format("a second answer of participant {} about {}",
                                motion::in_quotes(participant), motion::in_quotes(stimulus.text)),
                    "keep one of them");
      }
      const std::string& called = row[columns_.language].text;
      if (const Language* language = find_language(lexicon_, called)) {
        read_row(row, *language);
      } else {
        count(left_out_, "", folded(called));
      }
    }
  }

  std::vector<Understood> answers;

  WordAnswers report() const {
    WordAnswers report;
    report.coverage = coverage_;
    report.not_understood = most_frequent_first(not_understood_);
    report.respelled = most_frequent_first(respelled_);
    report.left_out = most_frequent_first(left_out_);
    for (const auto& [name, stimulus] : stimuli_) report.stimuli.push_back(stimulus);
    return report;
  }

 private:
  void read_row(const std::vector<CsvField>& row, const Language& language) {
    WordCoverage& coverage =
        coverage_[static_cast<std::size_t>(&language - lexicon_.languages.data())];
    std::vector<Mention> mentions;
    std::vector<Grade> verb_degree;
    int modifiers = 0;
    int understood = 0;
    for (const std::size_t column : columns_.modifiers) {
      const std::string text = folded(row[column].text);
      if (text.empty()) continue;
      ++modifiers;
      const PhraseReading reading = read_phrase(text, lexicon_, language);
      if (reading.is_read()) {
        ++understood;
      } else {
        count(not_understood_, language.name, text);
      }
      take(reading, language, mentions);
      verb_degree.insert(verb_degree.end(), reading.degree.begin(), reading.degree.end());
    }
    if (columns_.verb >= 0) {
      const auto verb = static_cast<std::size_t>(columns_.verb);
      PhraseReading reading = read_phrase(row[verb].text, lexicon_, language);
      for (Mention& mention : reading.mentions) {
        if (std::abs(mention.value) == 1.0) {
          mention.value = graded(mention.value < 0 ? -1 : 1, verb_degree);
        }
      }
      take(reading, language, mentions);
    }
    if (modifiers > 0) ++coverage.answers;
    if (understood > 0) ++coverage.understood;
    coverage.modifiers += modifiers;
    coverage.modifiers_understood += understood;
    add_answer(row, mentions);
  }

  void take(const PhraseReading& reading, const Language& language,
            std::vector<Mention>& mentions) {
    mentions.insert(mentions.end(), reading.mentions.begin(), reading.mentions.end());
    for (const auto& [written, as] : reading.respelled) {
      count(respelled_, language.name, written, as);
    }
  }

  void add_answer(const std::vector<CsvField>& row, const std::vector<Mention>& mentions) {
    Understood answer{row[columns_.participant].text, row[columns_.stimulus].text, {}};
    for (const Mention& mention : mentions) {
      double& value = answer.values.emplace(mention.scale, 0.0).first->second;
      if (std::abs(mention.value) > std::abs(value)) {
        value = mention.value;
      } else if (mention.value == -value) {
        value = 0.0;
      }
    }
    StimulusCount& stimulus = stimuli_[answer.stimulus];
    stimulus.stimulus = answer.stimulus;
    ++stimulus.answers;
    if (!answer.values.empty()) ++stimulus.understood;
    answers.push_back(std::move(answer));
  }

  const CsvTable& table_;
  const Lexicon& lexicon_;
  WordColumns columns_;
  std::vector<WordCoverage> coverage_;
  WordTally not_understood_;
  WordTally respelled_;
  WordTally left_out_;
  std::map<std::string, StimulusCount> stimuli_;
};

std::set<std::string> mentioned_scales(const std::vector<Understood>& answers) {
  std::set<std::string> scales;
  for (const Understood& answer : answers) {
    for (const auto& [scale, value] : answer.values) scales.insert(scale);
  }
  return scales;
}

/// A mention of −2 … 2 in the scale's own range.
double on_scale(const Scale& scale, double value) {
  const double middle = (scale.least + scale.most) / 2.0;
  return middle + value / strongest * (scale.most - middle);
}

}  // namespace

bool holds_words(const CsvTable& table) {
  return find_column(table, "modifier1") >= 0 && find_column(table, "scale") < 0;
}

WordAnswers answers_from_words(const CsvTable& table, const ScaleSet& scales,
                               Unmentioned unmentioned) {
  if (scales.lexicon.languages.empty()) {
    throw Error(Place{table.file}, "holds words, but the scales file has no lexicon",
                "name a scales file with languages and words, such as "
                "manifests/walking-words.scales.yaml");
  }
  WordsReader reader(table, scales);
  reader.read();
  const std::set<std::string> mentioned = mentioned_scales(reader.answers);
  if (mentioned.empty()) {
    throw Error(Place{table.file}, "the lexicon matches none of the answers",
                "check the languages and words of both files");
  }
  WordAnswers result = reader.report();
  for (const Understood& answer : reader.answers) {
    for (const Scale& scale : scales.scales) {
      const auto value = answer.values.find(scale.id);
      const bool is_said = value != answer.values.end();
      if (!mentioned.contains(scale.id)) continue;
      if (!is_said && unmentioned == Unmentioned::no_answer) continue;
      result.answers.answers.push_back({answer.participant, answer.stimulus, scale.id,
                                        on_scale(scale, is_said ? value->second : 0.0)});
    }
  }
  return result;
}

}  // namespace mien::pipeline

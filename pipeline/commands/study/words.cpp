#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>

#include <fmt/format.h>
#include <fmt/ostream.h>

#include "pipeline/base/documents/files.h"
#include "pipeline/base/documents/table.h"
#include "pipeline/commands/line/installed_manifests.h"
#include "pipeline/commands/line/recording_options.h"
#include "pipeline/commands/study/study.h"
#include "pipeline/manifest/ratings/answers/word_answers.h"

namespace mien::pipeline {

namespace {

constexpr std::size_t shown_words = 20;

struct WordsOptions {
  std::string words;
  std::string lexicon;
  std::string out;
  std::string report;
  Unmentioned unmentioned = Unmentioned::neutral;
};

double percent(int part, int whole) { return whole > 0 ? 100.0 * part / whole : 0.0; }

constexpr auto coverage_columns = table_of<WordCoverage>(
    "coverage.csv", "language",
    {{"language", "", "the language", [](auto& r) { return r.language; }},
     {"answers", "", "answers with a modifier", [](auto& r) { return r.answers; }},
     {"understood", "", "of these answers, those with at least one modifier that is understood",
      [](auto& r) { return r.understood; }},
     {"modifiers", "", "number of modifiers", [](auto& r) { return r.modifiers; }},
     {"modifiers_understood", "", "of these modifiers, those that are understood",
      [](auto& r) { return r.modifiers_understood; }}});

/// Columns of a table of words that were not understood, or read as others.
constexpr auto words_table(std::string_view path) {
  return table_of<WordCount>(
      path, "a word",
      {{"language", "", "the language", [](auto& r) { return r.language; }},
       {"text", "", "as it was written", [](auto& r) { return r.text; }},
       {"read_as", "", "the word taken for it; empty: none", [](auto& r) { return r.as; }},
       {"count", "", "how often it was written", [](auto& r) { return r.count; }}});
}

constexpr auto not_understood_columns = words_table("not_understood.csv");
constexpr auto respelled_columns = words_table("respelled.csv");

constexpr auto stimulus_counts_columns = table_of<StimulusCount>(
    "answers_per_stimulus.csv", "stimulus",
    {{"stimulus", "", "id of the stimulus", [](auto& r) { return r.stimulus; }},
     {"answers", "", "answers in a language of the lexicon", [](auto& r) { return r.answers; }},
     {"understood", "", "of these answers, those that rate the stimulus on a scale",
      [](auto& r) { return r.understood; }}});

void write_report(const WordAnswers& words, const std::filesystem::path& folder) {
  write_tables(
      folder, {coverage_columns.of(words.coverage), not_understood_columns.of(words.not_understood),
               respelled_columns.of(words.respelled), stimulus_counts_columns.of(words.stimuli)});
}

void print_coverage(const WordAnswers& words, std::ostream& out) {
  for (const WordCoverage& language : words.coverage) {
    if (language.answers == 0) continue;
    fmt::print(out, "{}: {} of {} answers understood ({:.0f} %), {} of {} modifiers ({:.0f} %)\n",
               language.language, language.understood, language.answers,
               percent(language.understood, language.answers), language.modifiers_understood,
               language.modifiers, percent(language.modifiers_understood, language.modifiers));
  }
  for (const WordCount& language : words.left_out)
    fmt::print(out, "excluded: {} answers in \"{}\", a language not in the lexicon\n",
               language.count, language.text);
}

void print_stimuli(const WordAnswers& words, std::ostream& out) {
  const auto [least, most] = std::minmax_element(
      words.stimuli.begin(), words.stimuli.end(),
      [](const StimulusCount& a, const StimulusCount& b) { return a.answers < b.answers; });
  fmt::print(out, "{} stimuli, {} to {} answers each\n", words.stimuli.size(), least->answers,
             most->answers);
}

void print_words(const WordAnswers& words, std::ostream& out) {
  if (!words.respelled.empty()) {
    out << "corrected spellings:";
    for (std::size_t i = 0; i < std::min(shown_words, words.respelled.size()); ++i) {
      const WordCount& word = words.respelled[i];
      fmt::print(out, "{} {} → {}", i == 0 ? "" : ",", word.text, word.as);
    }
    out << '\n';
  }
  if (words.not_understood.empty()) return;
  out << "most frequent words not understood:\n";
  for (std::size_t i = 0; i < std::min(shown_words, words.not_understood.size()); ++i) {
    const WordCount& word = words.not_understood[i];
    fmt::print(out, "  {:4} × {} ({})\n", word.count, word.text, word.language);
  }
}

int turn_words_into_answers(const WordsOptions& options, const Console& console) {
  const ScaleSet scales = read_scales(resolve_input_file(options.lexicon, console));
  const WordAnswers words =
      answers_from_words(read_csv(options.words), scales, options.unmentioned);
  refuse_own_input(options.words, options.out);
  refuse_own_input(options.lexicon, options.out);
  write_file(options.out, to_csv(words.answers));
  if (!options.report.empty()) write_report(words, options.report);
  print_coverage(words, console.out);
  print_stimuli(words, console.out);
  print_words(words, console.out);
  fmt::print(console.out, "{}: {} answers\n", options.out, words.answers.answers.size());
  return exit_done;
}

}  // namespace

Command study_words_command() {
  const auto options = std::make_shared<WordsOptions>();
  return {
      .name = "words",
      .summary = "Convert free-text answers to answers on scales",
      .options = {argument("words", &options->words,
                           "CSV: participant, language, motion, verb, modifier1, modifier2 …"),
                  option(
                      "--lexicon", &options->lexicon,
                      "Scales file with languages and words (manifests/walking-words.scales.yaml)")
                      .required(),
                  option("-o,--output", &options->out, "CSV of answers to write").required(),
                  option("--report", &options->report,
                         "Folder for coverage.csv, not_understood.csv, respelled.csv and "
                         "answers_per_stimulus.csv"),
                  choice("--unmentioned", options->unmentioned,
                         {{"neutral", Unmentioned::neutral}, {"no-answer", Unmentioned::no_answer}},
                         "Value of an answer on scales that it does not mention: neutral (the "
                         "middle) or no-answer")},
      .notes =
          "On a scale from -2 to 2, a word counts 1 towards its end, also if softened (\"a "
          "little\"), and 2 if\n"
          "strengthened (\"very\"); a negated word counts towards the opposite end. The strongest "
          "mention of a scale\n"
          "in an answer counts.\n\n"
          "Example:\n"
          "  mien study words words.csv --lexicon manifests/walking-words.scales.yaml -o "
          "answers.csv",
      .run = [options](const Console& console) {
        return turn_words_into_answers(*options, console);
      }};
}

}  // namespace mien::pipeline

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>

#include <fmt/format.h>
#include <fmt/ostream.h>

#include "pipeline/base/documents/files.h"
#include "pipeline/commands/line/installed_manifests.h"
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

std::string coverage_csv(const WordAnswers& words) {
  CsvWriter csv({"language", "answers", "understood", "modifiers", "modifiers_understood"});
  for (const WordCoverage& language : words.coverage) {
    csv.row({language.language, std::to_string(language.answers),
             std::to_string(language.understood), std::to_string(language.modifiers),
             std::to_string(language.modifiers_understood)});
  }
  return csv.text();
}

std::string counts_csv(const std::vector<WordCount>& counts) {
  CsvWriter csv({"language", "text", "read_as", "count"});
  for (const WordCount& entry : counts) {
    csv.row({entry.language, entry.text, entry.as, std::to_string(entry.count)});
  }
  return csv.text();
}

std::string stimuli_csv(const WordAnswers& words) {
  CsvWriter csv({"stimulus", "answers", "understood"});
  for (const StimulusCount& stimulus : words.stimuli) {
    csv.row(
        {stimulus.stimulus, std::to_string(stimulus.answers), std::to_string(stimulus.understood)});
  }
  return csv.text();
}

void write_report(const WordAnswers& words, const std::filesystem::path& folder) {
  make_folder(folder);
  write_file(folder / "coverage.csv", coverage_csv(words));
  write_file(folder / "not_understood.csv", counts_csv(words.not_understood));
  write_file(folder / "respelled.csv", counts_csv(words.respelled));
  write_file(folder / "answers_a_stimulus.csv", stimuli_csv(words));
}

void tell_coverage(const WordAnswers& words, std::ostream& out) {
  for (const WordCoverage& language : words.coverage) {
    if (language.answers == 0) continue;
    fmt::print(out, "{}: {} of {} answers understood ({:.0f} %), {} of {} modifiers ({:.0f} %)\n",
               language.language, language.understood, language.answers,
               percent(language.understood, language.answers), language.modifiers_understood,
               language.modifiers, percent(language.modifiers_understood, language.modifiers));
  }
  for (const WordCount& language : words.left_out) {
    fmt::print(out, "excluded: {} answers in \"{}\", a language not in the lexicon\n",
               language.count, language.text);
  }
}

void tell_stimuli(const WordAnswers& words, std::ostream& out) {
  const auto [least, most] = std::minmax_element(
      words.stimuli.begin(), words.stimuli.end(),
      [](const StimulusCount& a, const StimulusCount& b) { return a.answers < b.answers; });
  fmt::print(out, "{} stimuli, {} to {} answers each\n", words.stimuli.size(), least->answers,
             most->answers);
}

void tell_words(const WordAnswers& words, std::ostream& out) {
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
  const ScaleSet scales = read_scales(given_or_installed(options.lexicon, console));
  const WordAnswers words =
      answers_from_words(read_csv(options.words), scales, options.unmentioned);
  write_file(options.out, to_csv(words.answers));
  if (!options.report.empty()) write_report(words, options.report);
  tell_coverage(words, console.out);
  tell_stimuli(words, console.out);
  tell_words(words, console.out);
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
                         "answers_a_stimulus.csv"),
                  choice("--unmentioned", options->unmentioned,
                         {{"neutral", Unmentioned::neutral}, {"no-answer", Unmentioned::no_answer}},
                         "Value of an answer on scales that it does not mention: neutral (the "
                         "middle) or no-answer")},
      .notes =
          "A word counts 1 of 2 towards its end of the scale, a strengthened one (\"very\") 2; a "
          "negated word counts\n"
          "towards the opposite end. The strongest mention of a scale in an answer counts. "
          "Example:\n"
          "  mien study words words.csv --lexicon manifests/walking-words.scales.yaml -o "
          "answers.csv",
      .run = [options](const Console& console) {
        return turn_words_into_answers(*options, console);
      }};
}

}  // namespace mien::pipeline

#include "pipeline/study/results/word_frequencies.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string_view>
#include <utility>

namespace mien::pipeline {

namespace {

constexpr std::array<std::string_view, 7> word_separators = {",",  ";",  "\n", "\r",
                                                             "、", "，", "；"};

/// Trims and lower-cases ASCII letters; case of others depends on the language.
std::string trimmed_small(std::string_view text) {
  constexpr std::string_view space = " \t";
  const std::size_t first = text.find_first_not_of(space);
  if (first == std::string_view::npos) return "";
  std::string word(text.substr(first, text.find_last_not_of(space) + 1 - first));
  for (char& letter : word)
    if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
  return word;
}

std::set<std::string> words_in(std::string_view text) {
  std::set<std::string> words;
  while (!text.empty()) {
    std::size_t end = text.size(), next = text.size();
    for (const std::string_view separator : word_separators) {
      const std::size_t at = text.find(separator);
      if (at < end) {
        end = at;
        next = at + separator.size();
      }
    }
    const std::string word = trimmed_small(text.substr(0, end));
    if (!word.empty()) words.insert(word);
    text.remove_prefix(next);
  }
  return words;
}

using People = std::set<std::string>;

void append_counts(const std::string& stimulus, const std::string& item,
                   const std::map<std::string, People>& words, std::vector<WordFrequency>& all) {
  People respondents;
  for (const auto& [word, people] : words) respondents.insert(people.begin(), people.end());
  const std::size_t first = all.size();
  for (const auto& [word, people] : words)
    all.push_back({stimulus, item, word, static_cast<int>(people.size()),
                   static_cast<int>(respondents.size())});
  std::stable_sort(
      all.begin() + static_cast<std::ptrdiff_t>(first), all.end(),
      [](const WordFrequency& a, const WordFrequency& b) { return a.people > b.people; });
}

}  // namespace

std::vector<WordFrequency> word_frequencies_of(const AnswerSet& answer_set) {
  std::map<std::pair<std::string, std::string>, std::map<std::string, People>> given;
  for (const Remark& answer : answer_set.words)
    for (const std::string& word : words_in(answer.text))
      given[{answer.stimulus, answer.item}][word].insert(answer.participant);
  std::vector<WordFrequency> all;
  for (const ReportedStimulus& stimulus : answer_set.stimuli)
    for (const auto& [about, words] : given)
      if (about.first == stimulus.id) append_counts(stimulus.id, about.second, words, all);
  return all;
}

}  // namespace mien::pipeline

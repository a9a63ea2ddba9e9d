#include <fmt/format.h>

#include "motion/text/excerpt.h"
#include "pipeline/study/results/gathered_answers.h"

namespace mien::pipeline {

std::string counted(std::size_t count, const std::string& one, const std::string& several) {
  return fmt::format("{} {}", count, count == 1 ? one : several);
}

std::string people_sentence(const Gathered& gathered) {
  const std::size_t all = gathered.attention.size();
  return fmt::format("{} of {} analysed", gathered.people.size(),
                     counted(all, "participant", "participants"));
}

std::vector<std::string> unfinished_sentences(const Gathered& gathered) {
  std::vector<std::string> sentences;
  for (const Unfinished& one : gathered.unfinished)
    sentences.push_back(
        fmt::format("participant {} did not finish ({} of {} trials): {}",
                    motion::in_quotes(one.participant), one.trials, one.planned,
                    gathered.without_unfinished ? "excluded" : "answers given are included"));
  return sentences;
}

}  // namespace mien::pipeline

#include "pipeline/study/adaptive/round_numbers.h"

#include <algorithm>
#include <charconv>
#include <numeric>

namespace mien::pipeline {

namespace {

/// The first file of each file's round, where files that share stimuli are of one round.
std::vector<std::size_t> first_files(const std::vector<Answers>& files) {
  std::vector<std::size_t> first(files.size());
  std::iota(first.begin(), first.end(), std::size_t{0});
  std::map<std::string, std::size_t> file_of;
  for (std::size_t f = 0; f < files.size(); ++f)
    for (const Answer& answer : files[f].answers) {
      const std::size_t other = first[file_of.emplace(answer.stimulus, f).first->second];
      const std::size_t own = first[f];
      if (other != own) std::ranges::replace(first, std::max(own, other), std::min(own, other));
    }
  return first;
}

}  // namespace

std::optional<int> round_in_name(const std::string& stimulus) {
  constexpr std::string_view prefix = "round";
  if (!stimulus.starts_with(prefix)) return std::nullopt;
  int number = 0;
  const char* end = stimulus.data() + stimulus.size();
  const auto [rest, error] = std::from_chars(stimulus.data() + prefix.size(), end, number);
  if (error != std::errc() || number < 1 || rest == end || *rest != '-') return std::nullopt;
  return number;
}

std::map<std::string, int> round_numbers(const std::vector<Answers>& files) {
  std::map<std::string, int> rounds;
  bool is_named = false;
  for (const Answers& file : files)
    for (const Answer& answer : file.answers) {
      const std::optional<int> number = round_in_name(answer.stimulus);
      is_named = is_named || number;
      rounds[answer.stimulus] = number.value_or(1);
    }
  if (is_named) return rounds;
  const std::vector<std::size_t> first = first_files(files);
  int count = 0;
  for (std::size_t f = 0; f < files.size(); ++f) {
    if (first[f] != f) continue;
    ++count;
    for (std::size_t other = f; other < files.size(); ++other)
      if (first[other] == f)
        for (const Answer& answer : files[other].answers) rounds[answer.stimulus] = count;
  }
  return rounds;
}

}  // namespace mien::pipeline

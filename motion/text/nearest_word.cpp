#include "motion/text/nearest_word.h"

#include <algorithm>
#include <array>
#include <vector>

#include "motion/text/excerpt.h"

namespace mien::motion {

namespace {

/// Longer names are not compared: the time is proportional to the product of both lengths.
constexpr size_t longest_word = 200;

std::string lowered(std::string_view word) {
  std::string result(word);
  for (char& c : result) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return result;
}

std::string with_halves_exchanged(const std::string& word) {
  const size_t hyphen = word.find('-');
  if (hyphen == std::string::npos) return word;
  return word.substr(hyphen + 1) + "-" + word.substr(0, hyphen);
}

/// The only candidate of which the word is the first part: "limit" of "limit_s".
std::optional<std::string> only_beginning_with(std::string_view word,
                                               std::span<const std::string> candidates) {
  const auto begins = [&](const std::string& candidate) {
    return candidate.size() > word.size() && candidate.starts_with(word) &&
           (candidate[word.size()] == '-' || candidate[word.size()] == '_');
  };
  const auto first = std::ranges::find_if(candidates, begins);
  if (word.empty() || first == candidates.end()) return std::nullopt;
  if (std::any_of(first + 1, candidates.end(), begins)) return std::nullopt;
  return *first;
}

}  // namespace

int edit_distance(std::string_view from, std::string_view to) {
  // Lowrance and Wagner 1975. Row and column 0 are a border no path can cross.
  const size_t rows = from.size() + 2;
  const size_t columns = to.size() + 2;
  std::vector<int> table(rows * columns);
  const auto cost = [&](size_t i, size_t j) -> int& { return table[i * columns + j]; };
  const int border = static_cast<int>(from.size() + to.size());
  for (size_t i = 0; i < rows; ++i) cost(i, 0) = border;
  for (size_t j = 0; j < columns; ++j) cost(0, j) = border;
  for (size_t i = 1; i < rows; ++i) cost(i, 1) = static_cast<int>(i - 1);
  for (size_t j = 1; j < columns; ++j) cost(1, j) = static_cast<int>(j - 1);

  std::array<size_t, 256> last_row_of{};  // where each letter was last seen in `from`
  for (size_t i = 1; i <= from.size(); ++i) {
    size_t last_match = 0;
    for (size_t j = 1; j <= to.size(); ++j) {
      const size_t row = last_row_of[static_cast<unsigned char>(to[j - 1])];
      const size_t column = last_match;
      const bool same = from[i - 1] == to[j - 1];
      if (same) last_match = j;
      const int gap = static_cast<int>((i - row - 1) + 1 + (j - column - 1));
      cost(i + 1, j + 1) = std::min({cost(i, j) + (same ? 0 : 1), cost(i + 1, j) + 1,
                                     cost(i, j + 1) + 1, cost(row, column) + gap});
    }
    last_row_of[static_cast<unsigned char>(from[i - 1])] = i;
  }
  return cost(rows - 1, columns - 1);
}

std::optional<std::string> nearest_word(std::string_view word,
                                        std::span<const std::string> candidates) {
  if (word.size() > longest_word) return std::nullopt;
  const std::string meant = lowered(word);
  const std::string exchanged = with_halves_exchanged(meant);
  int nearest = std::max(1, static_cast<int>(word.size()) / 3) + 1;
  std::optional<std::string> best;
  for (const std::string& candidate : candidates) {
    // A letter more or less is a step of its own.
    if (std::max(word.size(), candidate.size()) - std::min(word.size(), candidate.size()) >=
        static_cast<size_t>(nearest))
      continue;
    const std::string name = lowered(candidate);
    const int distance = std::min(edit_distance(meant, name), edit_distance(exchanged, name));
    if (distance >= nearest) continue;
    nearest = distance;
    best = candidate;
  }
  return best ? best : only_beginning_with(word, candidates);
}

std::string did_you_mean(std::string_view word, std::span<const std::string> candidates) {
  if (const auto near = nearest_word(word, candidates))
    return "did you mean " + in_quotes(*near) + "?";
  std::string list;
  for (const std::string& candidate :
       candidates.first(std::min(max_listed_names, candidates.size()))) {
    list += (list.empty() ? "use one of " : ", ") + in_quotes(candidate);
  }
  if (candidates.size() <= max_listed_names) return list;
  return list + ", … (" + std::to_string(candidates.size()) + " in all)";
}

}  // namespace mien::motion

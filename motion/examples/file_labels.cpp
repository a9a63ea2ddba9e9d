#include "motion/examples/file_labels.h"

#include <algorithm>

#include <fnmatch.h>

namespace mien::motion {

namespace {

constexpr std::string_view separators = "_. ";

bool is_separator(char c) { return separators.find(c) != std::string_view::npos; }

/// How many stems' characters agree from the start (or, `reversed`, from the end).
size_t shared_length(std::span<const std::string> stems, bool reversed) {
  const auto at = [&](const std::string& stem, size_t i) {
    return reversed ? stem[stem.size() - 1 - i] : stem[i];
  };
  size_t shared = stems.front().size();
  for (const std::string& stem : stems) {
    shared = std::min(shared, stem.size());
    size_t i = 0;
    while (i < shared && at(stem, i) == at(stems.front(), i)) ++i;
    shared = i;
  }
  return shared;
}

/// The alternatives of the braces that open at `pattern`; npos in `end` when nothing closes them.
struct Braces {
  std::vector<std::string_view> alternatives;
  size_t end = std::string_view::npos;  ///< after the closing one
};

Braces braces_at(std::string_view pattern, size_t open) {
  Braces braces;
  int depth = 0;
  size_t start = open + 1;
  for (size_t i = open; i < pattern.size(); ++i) {
    if (pattern[i] == '{') ++depth;
    const bool closes = pattern[i] == '}' && --depth == 0;
    if (!closes && !(pattern[i] == ',' && depth == 1)) continue;
    braces.alternatives.push_back(pattern.substr(start, i - start));
    start = i + 1;
    if (!closes) continue;
    braces.end = start;
    break;
  }
  return braces;
}

bool matches_without_braces(std::string_view pattern, std::string_view name) {
  return fnmatch(std::string(pattern).c_str(), std::string(name).c_str(), FNM_NOESCAPE) == 0;
}

}  // namespace

bool matches_glob(std::string_view pattern, std::string_view name) {
  const size_t open = pattern.find('{');
  if (open == std::string_view::npos) return matches_without_braces(pattern, name);
  const Braces braces = braces_at(pattern, open);
  if (braces.end == std::string_view::npos) return matches_without_braces(pattern, name);
  return std::any_of(braces.alternatives.begin(), braces.alternatives.end(),
                     [&](std::string_view alternative) {
                       std::string chosen(pattern.substr(0, open));
                       chosen.append(alternative).append(pattern.substr(braces.end));
                       return matches_glob(chosen, name);
                     });
}

std::vector<std::string> labels_from_names(std::span<const std::string> stems) {
  std::vector<std::string> labels(stems.begin(), stems.end());
  if (stems.size() < 2) return labels;
  const std::string& first = stems.front();
  size_t prefix = shared_length(stems, false);
  while (prefix > 0 && !is_separator(first[prefix - 1])) --prefix;
  size_t suffix = shared_length(stems, true);
  while (suffix > 0 && !is_separator(first[first.size() - suffix])) --suffix;
  for (std::string& label : labels) {
    if (label.size() <= prefix + suffix) return {stems.begin(), stems.end()};
    label = label.substr(prefix, label.size() - prefix - suffix);
  }
  return labels;
}

}  // namespace mien::motion

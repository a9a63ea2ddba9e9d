#include "motion/examples/file_labels.h"

#include <algorithm>
#include <regex>

#include "motion/error.h"
#include "motion/text/excerpt.h"

namespace mien::motion {

namespace {

constexpr std::string_view separators = "_. ";

bool is_separator(char c) { return separators.find(c) != std::string_view::npos; }

/// Length of the set "[…]" at the start of `pattern`, brackets included; 0 when it is not closed.
size_t set_length(std::string_view pattern) {
  // A bracket right after the opening (and "!") belongs to the set.
  const size_t first = pattern.size() > 1 && pattern[1] == '!' ? 3 : 2;
  const size_t closing = pattern.find(']', std::min(first, pattern.size()));
  return closing == std::string_view::npos ? 0 : closing + 1;
}

bool in_set(std::string_view set, char c) {
  set = set.substr(1, set.size() - 2);
  const bool negated = set.starts_with('!');
  if (negated) set.remove_prefix(1);
  bool found = false;
  for (size_t i = 0; i < set.size(); ++i) {
    if (i + 2 < set.size() && set[i + 1] == '-') {
      found = found || (set[i] <= c && c <= set[i + 2]);
      i += 2;
    } else {
      found = found || set[i] == c;
    }
  }
  return found != negated;
}

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
  // Where to go on after the last star when what follows it does not fit.
  size_t p = 0;
  size_t n = 0;
  size_t star = std::string_view::npos;
  size_t starred = 0;
  while (n < name.size()) {
    const size_t set = p < pattern.size() && pattern[p] == '[' ? set_length(pattern.substr(p)) : 0;
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      starred = n;
    } else if (set > 0 && in_set(pattern.substr(p, set), name[n])) {
      p += set;
      ++n;
    } else if (set == 0 && p < pattern.size() && (pattern[p] == '?' || pattern[p] == name[n])) {
      ++p;
      ++n;
    } else if (star != std::string_view::npos) {
      p = star + 1;
      n = ++starred;
    } else {
      return false;
    }
  }
  while (p < pattern.size() && pattern[p] == '*') ++p;
  return p == pattern.size();
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

std::vector<std::string> labels_by_pattern(std::span<const std::string> stems,
                                           const std::string& pattern) {
  std::regex expression;
  try {
    expression.assign(pattern);
  } catch (const std::regex_error&) {
    throw Error("the label pattern " + in_quotes(pattern) + " is no regular expression",
                "write one such as \"walk_(.*)_[0-9]+\", its group being the label");
  }
  std::vector<std::string> labels;
  for (const std::string& stem : stems) {
    std::smatch match;
    if (!std::regex_search(stem, match, expression)) {
      throw Error(Place{stem},
                  "the label pattern " + in_quotes(pattern) + " does not match this name",
                  "widen the pattern or leave the file out by include");
    }
    const auto group = std::find_if(match.begin() + 1, match.end(),
                                    [](const std::ssub_match& part) { return part.matched; });
    labels.push_back(group == match.end() ? match.str() : group->str());
  }
  return labels;
}

}  // namespace mien::motion

#include "motion/text/glob.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include <fnmatch.h>

namespace mien::motion {

namespace {

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

}  // namespace mien::motion

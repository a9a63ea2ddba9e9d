#include "motion/points/point_names.h"

#include <cstddef>
#include <map>
#include <set>

#include "motion/text/excerpt.h"

namespace mien::motion {

namespace {

std::string points_are(std::size_t count) {
  return count == 1 ? "1 point has" : std::to_string(count) + " points have";
}

}  // namespace

std::vector<std::string> distinct_point_names(std::vector<std::string> names,
                                              std::vector<std::string>& notes) {
  std::size_t unnamed = 0;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (!names[i].empty()) continue;
    names[i] = "point_" + std::to_string(i + 1);
    ++unnamed;
  }
  const std::set<std::string> given(names.begin(), names.end());
  std::set<std::string> used;
  std::map<std::string, int> times;  // so that many equal names do not take quadratic time
  std::vector<std::string> repeated;
  for (std::string& name : names) {
    if (used.insert(name).second) continue;
    int& number = times.try_emplace(name, 1).first->second;
    if (number == 1) repeated.push_back(name);
    std::string other;
    do other = name + "_" + std::to_string(++number);
    while (given.contains(other) || used.contains(other));
    used.insert(other);
    name = other;
  }
  if (unnamed > 0) {
    notes.push_back(points_are(unnamed) +
                    " no name in the file: such points are named by their place, as in point_3.");
  }
  if (!repeated.empty()) {
    notes.push_back("Names that occur more than once are numbered, as in " +
                    excerpt(repeated.front()) + "_2: " + listed(repeated) + ".");
  }
  return names;
}

}  // namespace mien::motion

#include "motion/points/marker_sets.h"

#include <algorithm>
#include <array>
#include <utility>

#include "motion/points/marker_names.h"
#include "motion/points/rig_joint_roles.h"
#include "motion/text/words.h"

namespace mien::motion {

namespace {

constexpr Words<Landmark> landmark_words = {
    {"pelvis", Landmark::pelvis},
    {"spine", Landmark::spine},
    {"chest", Landmark::chest},
    {"neck", Landmark::neck},
    {"head", Landmark::head},
    {"clavicle", Landmark::clavicle},
    {"shoulder", Landmark::shoulder},
    {"elbow", Landmark::elbow},
    {"wrist", Landmark::wrist},
    {"hip", Landmark::hip},
    {"knee", Landmark::knee},
    {"ankle", Landmark::ankle},
    {"ball of the foot", Landmark::toe},
    {"middle of the hips", Landmark::mid_hips},
    {"middle of the shoulders", Landmark::mid_shoulders},
    {"middle of the head", Landmark::head_centre},
    {"top of the head", Landmark::head_top},
    {"hand", Landmark::hand},
    {"tip of the foot", Landmark::toe_tip},
    {"nose", Landmark::nose},
    {"eye", Landmark::eye},
    {"ear", Landmark::ear},
    {"mouth", Landmark::mouth},
    {"front of the head", Landmark::head_front},
    {"back of the head", Landmark::head_back},
    {"side of the head", Landmark::head_side},
    {"front iliac spine", Landmark::front_iliac_spine},
    {"back iliac spine", Landmark::back_iliac_spine},
    {"sacrum", Landmark::sacrum},
    {"iliac crest", Landmark::iliac_crest},
    {"acromion", Landmark::acromion},
    {"seventh cervical vertebra", Landmark::cervical_7},
    {"back", Landmark::back},
    {"trunk", Landmark::trunk},
    {"jugular notch", Landmark::jugular_notch},
    {"sternum", Landmark::sternum},
    {"upper arm", Landmark::upper_arm},
    {"outer elbow", Landmark::outer_elbow},
    {"inner elbow", Landmark::inner_elbow},
    {"forearm", Landmark::forearm},
    {"wrist at the thumb", Landmark::thumb_side_of_wrist},
    {"wrist at the little finger", Landmark::finger_side_of_wrist},
    {"trochanter", Landmark::trochanter},
    {"thigh", Landmark::thigh},
    {"outer knee", Landmark::outer_knee},
    {"inner knee", Landmark::inner_knee},
    {"shank", Landmark::shank},
    {"outer ankle", Landmark::outer_ankle},
    {"inner ankle", Landmark::inner_ankle},
    {"heel", Landmark::heel},
    {"first metatarsal", Landmark::first_metatarsal},
    {"second metatarsal", Landmark::second_metatarsal},
    {"fifth metatarsal", Landmark::fifth_metatarsal},
    {"foot", Landmark::foot},
};

/// Letters and digits in lower case.
std::string plain(std::string_view name) {
  std::string word;
  for (const char c : name) {
    if (c >= 'A' && c <= 'Z') word += static_cast<char>(c - 'A' + 'a');
    if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')) word += c;
  }
  return word;
}

/// Length of the beginning, up to a separator, that all names share: of "Anna_LASI", "Anna_RASI".
std::size_t shared_beginning(std::span<const std::string> names) {
  if (names.size() < 2) return 0;
  std::size_t shared = names.front().size();
  for (const std::string& name : names) {
    std::size_t same = 0;
    while (same < std::min(shared, name.size()) && name[same] == names.front()[same]) ++same;
    shared = same;
  }
  const std::size_t separator = names.front().substr(0, shared).find_last_of("_ .-");
  return separator == std::string::npos ? 0 : separator + 1;
}

/// The names without a subject and without the beginning that they share.
std::vector<std::string> short_names(std::span<const std::string> points) {
  const std::size_t beginning = shared_beginning(points);
  std::vector<std::string> names;
  for (const std::string& point : points) {
    const std::size_t colon = point.rfind(':');
    names.push_back(point.substr(colon == std::string::npos ? beginning : colon + 1));
  }
  return names;
}

/// The spellings of one table, ready to be looked up.
using Spellings = std::vector<std::pair<std::string, Role>>;

void add_spellings(std::span<const MarkerName> names, Spellings& spellings) {
  constexpr std::array<std::pair<std::string_view, Side>, 4> sides = {
      {{"L", Side::left}, {"Left", Side::left}, {"R", Side::right}, {"Right", Side::right}}};
  for (const auto& [pattern, landmark] : names) {
    const std::size_t star = pattern.find('*');
    if (star == std::string_view::npos) {
      spellings.push_back({plain(pattern), {landmark, Side::middle}});
      continue;
    }
    for (const auto& [word, side] : sides) {
      std::string spelling(pattern);
      spelling.replace(star, 1, word);
      spellings.push_back({plain(spelling), {landmark, side}});
    }
  }
}

std::vector<std::optional<Role>> roles_of(const std::vector<std::string>& names,
                                          const Spellings& spellings) {
  std::vector<std::optional<Role>> roles(names.size());
  for (std::size_t point = 0; point < names.size(); ++point) {
    const auto found = std::find_if(spellings.begin(), spellings.end(),
                                    [&](const auto& known) { return known.first == names[point]; });
    if (found != spellings.end()) roles[point] = found->second;
  }
  return roles;
}

int known_count(const std::vector<std::optional<Role>>& roles) {
  return static_cast<int>(
      std::count_if(roles.begin(), roles.end(), [](const auto& role) { return role.has_value(); }));
}

bool has(const MarkerSet& set, const Role& role) {
  return std::find(set.roles.begin(), set.roles.end(), std::optional(role)) != set.roles.end();
}

std::vector<std::string> missing_points(const MarkerSet& set, std::span<const MarkerName> names) {
  std::vector<std::string> missing;
  for (const auto& [pattern, landmark] : names) {
    const std::size_t star = pattern.find('*');
    if (star == std::string_view::npos) {
      if (!has(set, {landmark, Side::middle})) missing.emplace_back(pattern);
      continue;
    }
    const bool is_alone = pattern.size() > 1 && plain(pattern) == pattern.substr(star == 0 ? 1 : 0);
    for (const Side side : {Side::left, Side::right}) {
      if (has(set, {landmark, side}) || has(set, {landmark, Side::middle})) continue;
      const bool is_long = is_alone || pattern.find('_') != std::string_view::npos || star > 0;
      std::string name(pattern);
      name.replace(star, 1,
                   side == Side::left ? (is_long ? "left" : "L") : (is_long ? "right" : "R"));
      missing.push_back(std::move(name));
    }
  }
  return missing;
}

/// The parts that a body needs and that cannot be found from the points.
std::vector<std::string> missing_parts(const MarkerSet& set) {
  using enum Landmark;
  std::vector<std::string> missing;
  const auto count = [&](std::initializer_list<Landmark> landmarks, Side side) {
    std::size_t points = 0;
    for (const Landmark landmark : landmarks) points += set.points_of(landmark, side).size();
    return points;
  };
  for (const Side side : {Side::left, Side::right}) {
    const std::string word = side == Side::left ? "left " : "right ";
    const bool has_thigh = count({thigh}, side) >= 3;
    const bool has_shank = count({shank}, side) >= 3;
    const bool has_foot =
        count({heel, foot, toe_tip, first_metatarsal, second_metatarsal, fifth_metatarsal}, side) >=
        3;
    if (count({hip, front_iliac_spine}, side) == 0) missing.push_back(word + "hip");
    if (count({knee, outer_knee}, side) == 0 && !(has_thigh && has_shank)) {
      missing.push_back(word + "knee");
    }
    if (count({ankle, outer_ankle}, side) == 0 && !(has_shank && has_foot)) {
      missing.push_back(word + "ankle");
    }
  }
  return missing;
}

}  // namespace

std::vector<int> MarkerSet::points_of(Landmark landmark, Side side) const {
  std::vector<int> points;
  for (std::size_t point = 0; point < roles.size(); ++point) {
    if (roles[point] == Role{landmark, side}) points.push_back(static_cast<int>(point));
  }
  return points;
}

MarkerSet recognised_marker_set(std::span<const std::string> points) {
  constexpr int fewest = 4;
  const std::vector<std::string> spelled = short_names(points);
  std::vector<std::string> names;
  for (const std::string& name : spelled) names.push_back(plain(name));
  MarkerSet best;
  best.roles.resize(points.size());
  const MarkerNames* found = nullptr;
  int most = fewest - 1;
  for (const MarkerNames& set : known_marker_sets()) {
    Spellings spellings;
    add_spellings(set.names, spellings);
    const int count = known_count(roles_of(names, spellings));
    if (count <= most) continue;
    most = count;
    found = &set;
  }
  std::vector<std::optional<Role>> as_rig = rig_joint_roles(spelled);
  if (known_count(as_rig) > most) {
    best.name = "joints of a rig";
    best.roles = std::move(as_rig);
  } else if (found) {
    Spellings spellings;
    add_spellings(found->names, spellings);
    add_spellings(marker_abbreviations(), spellings);
    best.name = found->set;
    best.roles = roles_of(names, spellings);
    best.missing_points = missing_points(best, found->names);
  }
  best.missing_parts = missing_parts(best);
  return best;
}

std::string words_for(const Role& role) {
  const std::string word(word_of(landmark_words, role.landmark));
  if (role.side == Side::middle) return word;
  return (role.side == Side::left ? "left " : "right ") + word;
}

}  // namespace mien::motion

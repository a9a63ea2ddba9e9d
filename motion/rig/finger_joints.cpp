#include "motion/rig/finger_joints.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <string>

#include "motion/rig/joint_word.h"

namespace mien::motion {

namespace {

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool is_capital(char c) { return std::isupper(static_cast<unsigned char>(c)) != 0; }
bool is_word_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

/// Words in lower case and numbers: "LeftFinger12" → left, finger, 12.
std::vector<std::string> parts_of_name(std::string_view name) {
  if (const size_t colon = name.rfind(':'); colon != std::string_view::npos)
    name.remove_prefix(colon + 1);
  std::vector<std::string> parts;
  for (size_t i = 0; i < name.size(); ++i) {
    const char c = name[i];
    if (!is_digit(c) && !is_word_letter(c)) continue;
    const char before = i > 0 ? name[i - 1] : ' ';
    const bool next_is_small =
        i + 1 < name.size() && is_word_letter(name[i + 1]) && !is_capital(name[i + 1]);
    const bool begins_word =
        is_word_letter(c) &&
        (!is_word_letter(before) || (is_capital(c) && (!is_capital(before) || next_is_small)));
    if (begins_word || (is_digit(c) && !is_digit(before))) parts.emplace_back();
    parts.back() += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return parts;
}

bool contains(std::string_view word, std::string_view part) {
  return word.find(part) != std::string_view::npos;
}

std::optional<Finger> finger_of_word(std::string_view word) {
  if (contains(word, "thumb")) return Finger::thumb;
  if (contains(word, "index") || contains(word, "pointer")) return Finger::index;
  if (contains(word, "middle") || word == "mid") return Finger::middle;
  if (word.ends_with("ring")) return Finger::ring;
  if (contains(word, "pinky") || contains(word, "pinkie") || contains(word, "little"))
    return Finger::little;
  return std::nullopt;
}

bool is_segment_word(std::string_view word) {
  constexpr std::string_view words[] = {"metacarpal", "proximal", "medial",
                                        "mediate",    "distal",   "intermediate"};
  return std::find(std::begin(words), std::end(words), word) != std::end(words);
}

/// "second" before "pp": fingers of MVN, counted from the thumb.
std::optional<Finger> finger_of_mvn(std::string_view count, std::string_view bone) {
  constexpr std::string_view counts[] = {"first", "second", "third", "fourth", "fifth"};
  constexpr std::string_view bones[] = {"mc", "pp", "mp", "dp"};
  if (std::find(std::begin(bones), std::end(bones), bone) == std::end(bones)) return std::nullopt;
  const auto found = std::find(std::begin(counts), std::end(counts), count);
  if (found == std::end(counts)) return std::nullopt;
  return Finger(found - std::begin(counts));
}

std::vector<int> joints_below(const Skeleton& rig, int wrist) {
  std::vector<bool> is_below(static_cast<size_t>(rig.size()), false);
  std::vector<int> below;
  if (wrist < 0) return below;
  is_below[static_cast<size_t>(wrist)] = true;
  for (int j = wrist + 1; j < rig.size(); ++j) {
    const int parent = rig.joints[static_cast<size_t>(j)].parent;
    if (!is_below[static_cast<size_t>(parent)]) continue;
    is_below[static_cast<size_t>(j)] = true;
    below.push_back(j);
  }
  return below;
}

/// How a rig counts "Finger1": the number of the thumb. Biped begins with 0, Rokoko with 1; of
/// fingers without 0 and 5, those of Biped lack the thumb.
int number_of_thumb(const std::vector<FingerName>& names) {
  bool states_segments = false;
  int most = -1;
  for (const FingerName& each : names) {
    if (!each.is_known || each.number < 0) continue;
    if (each.number == 0) return 0;
    most = std::max(most, each.number);
    states_segments = states_segments || each.states_segment;
  }
  return most == fingers_per_hand || states_segments ? 1 : 0;
}

/// Number at the end of a name, side letters left out; −1 without one.
int number_in(const std::string& name) {
  int number = -1;
  for (const std::string& part : parts_of_name(name))
    if (is_digit(part.front()) && part.size() < 4) number = std::stoi(part);
  return number;
}

/// The joints below one wrist, and which finger each belongs to.
struct HandTree {
  const Skeleton& rig;
  std::vector<int> joints;
  std::vector<int> fingers;  ///< Finger, or −1
};

HandTree hand_tree(const Skeleton& rig, int wrist) {
  HandTree tree{rig, joints_below(rig, wrist), {}};
  std::vector<FingerName> names;
  for (const int joint : tree.joints)
    names.push_back(read_finger_name(rig.joints[static_cast<size_t>(joint)].name));
  const int thumb = number_of_thumb(names);
  for (size_t k = 0; k < names.size(); ++k) {
    int finger = -1;
    if (names[k].is_known && !names_an_end(rig.joints[static_cast<size_t>(tree.joints[k])].name)) {
      finger = names[k].number < 0 ? static_cast<int>(names[k].finger) : names[k].number - thumb;
    }
    tree.fingers.push_back(finger < fingers_per_hand ? finger : -1);
  }
  return tree;
}

/// The longest chain of joints of one finger, from the wrist outwards.
std::vector<int> chain_of(const HandTree& tree, int finger) {
  std::vector<std::vector<int>> chains(static_cast<size_t>(tree.rig.size()));
  std::vector<int> longest;
  for (size_t k = 0; k < tree.joints.size(); ++k) {
    const auto joint = static_cast<size_t>(tree.joints[k]);
    chains[joint] = chains[static_cast<size_t>(tree.rig.joints[joint].parent)];
    if (tree.fingers[k] == finger) chains[joint].push_back(tree.joints[k]);
    if (chains[joint].size() > longest.size()) longest = chains[joint];
  }
  return longest;
}

/// The joint that marks the end of a finger, which no joint of a finger is; −1 if there is none.
int end_below(const HandTree& tree, int last) {
  for (size_t k = 0; k < tree.joints.size(); ++k) {
    const bool is_child = tree.rig.joints[static_cast<size_t>(tree.joints[k])].parent == last;
    if (is_child && tree.fingers[k] < 0) return tree.joints[k];
  }
  return -1;
}

void find_finger(const HandTree& tree, bool left, Finger finger, FingerJoints& found) {
  std::vector<int> chain = chain_of(tree, static_cast<int>(finger));
  if (chain.empty()) return;
  const auto name_of = [&](int joint) { return tree.rig.joints[static_cast<size_t>(joint)].name; };
  int end = end_below(tree, chain.back());
  if (chain.size() == joints_per_finger + 1 && number_in(name_of(chain.front())) == 1 &&
      number_in(name_of(chain.back())) == joints_per_finger + 1) {
    end = chain.back();
    chain.pop_back();
  }
  const size_t most = joints_per_finger;
  const size_t first = chain.size() > most ? chain.size() - most : 0;
  for (size_t k = first; k < chain.size(); ++k) {
    const int joint = finger_joint(left, finger, static_cast<int>(k - first));
    found.joints[static_cast<size_t>(joint)] = chain[k];
  }
  const int of_all = (left ? 0 : fingers_per_hand) + static_cast<int>(finger);
  found.ends[static_cast<size_t>(of_all)] = end;
}

bool has_finger(const FingerJoints& found, bool left, Finger finger) {
  return found.joints[static_cast<size_t>(finger_joint(left, finger, 0))] >= 0;
}

bool is_whole_enough(const FingerJoints& found, bool left) {
  const auto has = [&](Finger finger) { return has_finger(found, left, finger); };
  if (!has(Finger::index) || !has(Finger::middle)) return false;
  return has(Finger::thumb) || (has(Finger::ring) && has(Finger::little));
}

void forget_hand(FingerJoints& found, bool left) {
  const int first = left ? 0 : joints_per_hand;
  const int first_end = left ? 0 : fingers_per_hand;
  std::fill_n(found.joints.begin() + first, joints_per_hand, -1);
  std::fill_n(found.ends.begin() + first_end, fingers_per_hand, -1);
}

}  // namespace

FingerName read_finger_name(std::string_view name) {
  FingerName read;
  const std::vector<std::string> parts = parts_of_name(name);
  for (size_t k = 0; k < parts.size(); ++k) {
    const std::string_view next = k + 1 < parts.size() ? std::string_view(parts[k + 1]) : "";
    read.states_segment = read.states_segment || is_segment_word(parts[k]);
    if (read.is_known) continue;
    if (const auto finger = finger_of_word(parts[k])) {
      read.is_known = true;
      read.finger = *finger;
    } else if (const auto of_mvn = finger_of_mvn(parts[k], next)) {
      read.is_known = true;
      read.finger = *of_mvn;
    } else if (parts[k].ends_with("finger") && !next.empty() && is_digit(next.front())) {
      read.number = next.front() - '0';
      read.is_known = read.number <= fingers_per_hand;
    }
  }
  return read;
}

FingerJoints finger_joints(const Skeleton& rig, int left_wrist, int right_wrist) {
  FingerJoints found;
  found.joints.fill(-1);
  found.ends.fill(-1);
  for (const bool left : {true, false}) {
    const HandTree tree = hand_tree(rig, left ? left_wrist : right_wrist);
    for (int finger = 0; finger < fingers_per_hand; ++finger)
      find_finger(tree, left, Finger(finger), found);
    found.is_hand[left ? 0 : 1] = is_whole_enough(found, left);
    if (!found.is_hand[left ? 0 : 1]) forget_hand(found, left);
  }
  return found;
}

}  // namespace mien::motion

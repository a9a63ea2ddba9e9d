#include "motion/rig/joint_word.h"

#include <algorithm>
#include <cctype>
#include <initializer_list>
#include <vector>

namespace mien::motion {

namespace {

using Side = JointWord::Side;
using namespace joint_words;

constexpr std::string_view finger_words[] = {"thumb", "finger", "pinky"};
constexpr std::string_view short_finger_words[] = {"index", "middle", "ring", "little"};
constexpr std::string_view face_words[] = {"head", "neck", "skull", "jaw", "eye", "face"};

/// Parts of a name that say nothing about the joint.
constexpr std::string_view padding[] = {"bip",   "j",    "c",    "jnt",      "joint",
                                        "bone",  "def",  "bind", "org",      "jbip",
                                        "biped", "skel", "char", "character"};

bool is_body_word(std::string_view word) {
  for (Words words : {Words(pelvis_words), Words(head_words), Words(upper_arm_words),
                      Words(shoulder_words), Words(forearm_words), Words(wrist_words),
                      Words(thigh_words), Words(hip_words), Words(shank_words), Words(ankle_words),
                      Words(foot_words), Words(toe_words), Words(clavicle_words)}) {
    if (is_among(words, word)) return true;
  }
  return word == "hipjoint";
}

bool is_upper(char c) { return std::isupper(static_cast<unsigned char>(c)) != 0; }
bool is_lower(char c) { return std::islower(static_cast<unsigned char>(c)) != 0; }
bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

/// Splits at everything that is no letter, at "aB" and before the last capital of "ABc".
std::vector<std::string> tokens_of(std::string_view name) {
  std::vector<std::string> tokens;
  bool open = false;
  for (size_t i = 0; i < name.size(); ++i) {
    const char c = name[i];
    if (!is_letter(c)) {
      open = false;
      continue;
    }
    const bool after_lower = i > 0 && is_lower(name[i - 1]);
    const bool before_lower = i + 1 < name.size() && is_lower(name[i + 1]);
    const bool after_upper = i > 0 && is_upper(name[i - 1]);
    if (!open || (is_upper(c) && (after_lower || (after_upper && before_lower)))) {
      tokens.emplace_back();
    }
    open = true;
    tokens.back() += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return tokens;
}

Side side_of(std::string_view token) {
  if (token == "left" || token == "l" || token == "lft") return Side::left;
  if (token == "right" || token == "r" || token == "rgt" || token == "rt") return Side::right;
  return Side::middle;
}

/// "lfemur", "rightfoot": the side is stuck to the word.
void unstick_side(JointWord& joint) {
  for (std::string_view prefix : {"left", "right", "l", "r"}) {
    if (!joint.word.starts_with(prefix)) continue;
    const std::string rest = joint.word.substr(prefix.size());
    if (!is_body_word(rest)) continue;
    joint.side = prefix.front() == 'l' ? Side::left : Side::right;
    joint.word = rest;
    return;
  }
}

bool begins_with_any(std::string_view word, std::initializer_list<Words> lists) {
  for (const Words list : lists) {
    for (const std::string_view known : list) {
      if (word.starts_with(known)) return true;
    }
  }
  return false;
}

}  // namespace

bool is_among(Words words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

JointWord joint_word(std::string_view name) {
  if (const size_t colon = name.rfind(':'); colon != std::string_view::npos) {
    name.remove_prefix(colon + 1);
  }
  if (name.starts_with("mixamorig")) name.remove_prefix(9);
  JointWord joint;
  std::string padded;
  for (const std::string& token : tokens_of(name)) {
    padded += token;
    if (const Side side = side_of(token); side != Side::middle && joint.side == Side::middle) {
      joint.side = side;
    } else if (!is_among(padding, token)) {
      joint.word += token;
    }
  }
  if (joint.word.empty()) joint.word = padded;
  if (joint.side == Side::middle) unstick_side(joint);
  return joint;
}

BodyRegion body_region_of(const JointWord& joint) {
  const std::string_view word = joint.word;
  if (word == "armature") return BodyRegion::other;
  if (begins_with_any(word, {face_words})) return BodyRegion::head;
  if (is_among(short_finger_words, word) ||
      begins_with_any(word, {upper_arm_words, shoulder_words, forearm_words, wrist_words,
                             clavicle_words, finger_words})) {
    return BodyRegion::arm;
  }
  const bool is_hip = joint.side != Side::middle && begins_with_any(word, {hip_words});
  if (is_hip || begins_with_any(word, {thigh_words, shank_words, ankle_words, foot_words,
                                       Words(toe_words).first(3)})) {
    return BodyRegion::leg;
  }
  return BodyRegion::other;
}

bool names_an_end(std::string_view name) {
  std::string lower;
  for (const char c : name) lower += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  for (const std::string_view ending : {"end", "nub", "tip", "site", "effector"}) {
    if (lower.ends_with(ending)) return true;
  }
  return false;
}

bool names_a_part_of_the_face(std::string_view name) {
  constexpr std::string_view parts[] = {"jaw",    "eye",   "leye",  "reye",  "brow", "lid",
                                        "tongue", "teeth", "tooth", "mouth", "lip",  "chin",
                                        "cheek",  "nose",  "face",  "hair",  "ear"};
  return begins_with_any(joint_word(name).word, {Words(parts)});
}

}  // namespace mien::motion

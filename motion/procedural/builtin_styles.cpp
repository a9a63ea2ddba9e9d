#include "motion/error.h"
#include "motion/procedural/affective_walk.h"
#include "motion/procedural/builtin_sets.h"
#include "motion/procedural/expressive_walks.h"

namespace mien::motion {

namespace {

std::vector<NamedStyle> ten_walks() {
  return {{"normal", WalkStyle{}},    {"brisk", brisk_walk()},   {"slow", slow_walk()},
          {"happy", happy_walk()},    {"sad", sad_walk()},       {"angry", angry_walk()},
          {"proud", proud_walk()},    {"afraid", afraid_walk()}, {"tired", tired_walk()},
          {"relaxed", relaxed_walk()}};
}

std::vector<NamedStyle> circumplex_walks() {
  std::vector<NamedStyle> styles;
  for (const Emotion& emotion : circumplex_emotions()) {
    const WalkStyle own = affective_walk(emotion.valence, emotion.arousal);
    const std::string name(emotion.name);
    styles.push_back({name + "-fast", at_pace(own, 1.25)});
    styles.push_back({name + "-normal", own});
    styles.push_back({name + "-slow", at_pace(own, 0.75)});
  }
  return styles;
}

}  // namespace

std::vector<std::string_view> builtin_set_names() { return {"walks-10", "walks-27", "actors"}; }

std::vector<NamedStyle> builtin_styles(std::string_view name) {
  if (name == "walks-10") return ten_walks();
  if (name == "walks-27") return circumplex_walks();
  std::string known;
  for (const std::string_view set : builtin_set_names()) {
    if (!known.empty()) known += ", ";
    known += set;
  }
  throw Error("there is no built-in set \"" + std::string(name) + "\"", "choose one of: " + known);
}

}  // namespace mien::motion

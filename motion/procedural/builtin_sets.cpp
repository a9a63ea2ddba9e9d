#include "motion/procedural/builtin_sets.h"

#include <utility>

#include "motion/modify/posture.h"
#include "motion/procedural/expressive_walks.h"
#include "motion/procedural/knock.h"
#include "motion/procedural/walker.h"

namespace mien::motion {

namespace {

std::vector<NamedStyle> acted_walks() {
  return {{"neutral", WalkStyle{}},    {"afraid", afraid_walk()}, {"angry", angry_walk()},
          {"confident", proud_walk()}, {"happy", happy_walk()},   {"relaxed", relaxed_walk()},
          {"sad", sad_walk()},         {"tired", tired_walk()}};
}

Pose posed(const Skeleton& body, const std::vector<PostureChange>& changes, double fps) {
  return with_posture(stand(standing_pose(body), fps, body).clip, changes).poses.front();
}

void add_example(const std::string& name, Example example, ExampleSet& set) {
  example.name = name;
  example.clip.name = name;
  set.examples.push_back(std::move(example));
}

void add_actor(const std::string& actor, const Skeleton& body, double fps, ExampleSet& set) {
  for (const auto& [emotion, style] : acted_walks()) {
    add_example(actor + "-walk-" + emotion, walk(style, fps, body), set);
  }
  add_example(actor + "-knock-neutral", knock({}, fps, body), set);
  add_example(actor + "-knock-angry", knock(angry_knock(), fps, body), set);
  add_example(actor + "-knock-sad", knock(sad_knock(), fps, body), set);
  using enum PostureUnit;
  add_example(actor + "-stand-neutral", stand(standing_pose(body), fps, body), set);
  add_example(actor + "-stand-sad",
              stand(posed(body, {{head_flexion, 28.0}, {chest_flexion, 8.0}}, fps), fps, body),
              set);
  add_example(
      actor + "-stand-strong",
      stand(posed(body, {{shoulder_abduction, 18.0}, {chest_flexion, -5.0}}, fps), fps, body), set);
}

/// Walks, knocks and standing poses of a woman and a man.
ExampleSet two_actors(double frames_per_second) {
  ExampleSet set;
  set.name = "actors";
  set.simulated = true;
  set.blendable = false;
  add_actor("woman", standard_female_body(), frames_per_second, set);
  add_actor("man", standard_body(1.8), frames_per_second, set);
  return set;
}

}  // namespace

std::vector<std::string> builtin_example_names(std::string_view name) {
  std::vector<std::string> names;
  if (name == "actors") {
    // The names do not depend on the frame rate, and a low one is soon made.
    for (const Example& example : two_actors(10.0).examples) names.push_back(example.name);
  } else {
    for (const NamedStyle& style : builtin_styles(name)) names.push_back(style.name);
  }
  return names;
}

ExampleSet builtin_examples(std::string_view name, double frames_per_second) {
  if (name == "actors") return two_actors(frames_per_second);
  const Skeleton body = standard_body();
  ExampleSet set;
  set.name = name;
  set.simulated = true;
  for (const auto& [style_name, style] : builtin_styles(name)) {
    Example example = walk(style, frames_per_second, body);
    example.name = style_name;
    example.clip.name = style_name;
    set.examples.push_back(std::move(example));
  }
  return set;
}

}  // namespace mien::motion

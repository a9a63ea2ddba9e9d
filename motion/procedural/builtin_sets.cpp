#include "motion/procedural/builtin_sets.h"

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

using Makers = std::vector<ExampleMaker>;

template <class Make>
void add_maker(const std::string& name, const Make& make, Makers& makers) {
  makers.push_back({name, [=] {
                      Example example = make();
                      example.name = name;
                      example.clip.name = name;
                      return example;
                    }});
}

void add_actor(const std::string& actor, const Skeleton& body, double fps, Makers& makers) {
  const auto add_walk = [&](const std::string& name, const WalkStyle& style) {
    add_maker(
        actor + "-walk-" + name, [=] { return walk(style, fps, body); }, makers);
  };
  const auto add_knock = [&](const std::string& name, const KnockStyle& style) {
    add_maker(
        actor + "-knock-" + name, [=] { return knock(style, fps, body); }, makers);
  };
  const auto add_pose = [&](const std::string& name, const std::vector<PostureChange>& changes) {
    add_maker(
        actor + "-stand-" + name,
        [=] {
          const Pose pose = changes.empty() ? standing_pose(body) : posed(body, changes, fps);
          return stand(pose, fps, body);
        },
        makers);
  };
  for (const auto& [emotion, style] : acted_walks()) add_walk(emotion, style);
  add_knock("neutral", {});
  add_knock("angry", angry_knock());
  add_knock("sad", sad_knock());
  using enum PostureUnit;
  add_pose("neutral", {});
  add_pose("sad", {{head_flexion, 28.0}, {chest_flexion, 8.0}});
  add_pose("strong", {{shoulder_abduction, 18.0}, {chest_flexion, -5.0}});
}

void add_further_walks(const std::string& actor, const Skeleton& body, double fps, Makers& makers) {
  const std::vector<NamedStyle> styles = {
      {"excited", excited_walk()}, {"strong", strong_walk()}, {"weak", weak_walk()}};
  for (const auto& [emotion, style] : styles)
    add_maker(
        actor + "-walk-" + emotion, [=, style = style] { return walk(style, fps, body); }, makers);
}

constexpr std::string_view actors = "actors";

}  // namespace

std::vector<ExampleMaker> builtin_example_makers(std::string_view name, double frames_per_second) {
  Makers makers;
  if (name == actors) {
    add_actor("woman", standard_female_body(), frames_per_second, makers);
    add_actor("man", standard_body(1.8), frames_per_second, makers);
    // After all others, so that those keep their places.
    add_further_walks("woman", standard_female_body(), frames_per_second, makers);
    add_further_walks("man", standard_body(1.8), frames_per_second, makers);
    return makers;
  }
  for (const auto& [style_name, style] : builtin_styles(name))
    add_maker(
        style_name, [=, style = style] { return walk(style, frames_per_second, standard_body()); },
        makers);
  return makers;
}

std::vector<std::string> builtin_example_names(std::string_view name) {
  std::vector<std::string> names;
  for (const ExampleMaker& maker : builtin_example_makers(name)) names.push_back(maker.name);
  return names;
}

// The actors' walks, knocks and poses are no motions between which there are others.
ExampleSet empty_example_set(std::string_view name) {
  ExampleSet set;
  set.name = name;
  set.simulated = true;
  set.blendable = name != actors;
  return set;
}

ExampleSet builtin_examples(std::string_view name, double frames_per_second) {
  ExampleSet set = empty_example_set(name);
  for (const ExampleMaker& maker : builtin_example_makers(name, frames_per_second))
    set.examples.push_back(maker.make());
  return set;
}

}  // namespace mien::motion

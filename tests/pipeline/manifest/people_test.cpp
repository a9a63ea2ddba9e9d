#include "pipeline/manifest/people.h"

#include <optional>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "pipeline/base/reading/field_writer.h"
#include "pipeline/manifest/checks/manifest_reader.h"
#include "pipeline/manifest/look/point_form.h"

namespace mien::pipeline {
namespace {

ManifestReading people_reading(const std::string& stimuli) {
  return parse_manifest(
      "mien: 1\nstudy: s\nexamples: {set: builtin:walks-10}\nstimuli:\n" + stimuli,
      "/nowhere/m.yaml", [](const std::string&) { return std::nullopt; });
}

Manifest people_manifest(const std::string& stimuli) {
  ManifestReading reading = people_reading(stimuli);
  EXPECT_TRUE(reading.faults.empty()) << Faults(reading.faults).what();
  return std::move(reading.manifest);
}

std::string people_faults(const std::string& stimuli) {
  return Faults(people_reading(stimuli).faults).what();
}

constexpr char two_pairs[] =
    "  - id: one\n"
    "    people: [{weights: {sad: 1}, place: {x: -1}}, {weights: {happy: 1}, place: {x: 1}}]\n"
    "  - id: two\n"
    "    people: [{weights: {proud: 1}, place: {x: -1}}, {weights: {tired: 1}, place: {x: 1}}]\n";

std::string example_of(const Person& person) { return person.motion.weights.at(0).first; }

TEST(PeopleOfAStimulus, AreNamedByTheirNumberAndHaveMotionsOfTheirOwn) {
  const Manifest manifest = people_manifest(
      "  - {id: walk, weights: {sad: 1}}\n"
      "  - id: greet\n"
      "    interpolation: {foot_lock: false}\n"
      "    people: [{weights: {sad: 1}, place: {}}, {name: host, weights: {happy: 1}, place: "
      "{}}]\n");
  const Stimulus& greet = manifest.stimuli[1];
  ASSERT_EQ(greet.people.size(), 2u);
  EXPECT_EQ(greet.people[0].name, "a");
  EXPECT_EQ(greet.people[0].motion.path, "stimuli[1].people[0]");
  EXPECT_EQ(greet.people[1].motion.id, "greet.host");
  EXPECT_FALSE(greet.people[0].motion.interpolation.foot_lock);
  EXPECT_FALSE(is_blend(greet));
  std::string ids;
  for (const Stimulus* motion : motion_sources(manifest)) ids += motion->id + " ";
  EXPECT_EQ(ids, "walk greet.a greet.host ");
  EXPECT_EQ(film_showing(manifest, "greet.host"), &greet);
  EXPECT_EQ(film_showing(manifest, "walk"), &manifest.stimuli[0]);
  EXPECT_EQ(film_showing(manifest, "greet.b"), nullptr);
}

TEST(PeopleOfAStimulus, AreWrittenAndReadAgain) {
  const Manifest manifest = people_manifest(
      "  - id: greet\n"
      "    look: {figure: mannequin}\n"
      "    people:\n"
      "      - {name: host, weights: {sad: 1}, place: {x: -0.5, z: 0.25, turn: 90}}\n"
      "      - {path: [{walk: 2}], start: -0.5, modify: {emotion: sad},\n"
      "         look: {figure: {mannequin: {build: 0.9}}, hands: hidden, colour: "
      "\"#d55e00\"}}\n");
  const OrderedJson text = written(manifest, WritingOptions{});
  const ManifestReading again = parse_manifest(text.dump(), "/nowhere/m.yaml",
                                               [](const std::string&) { return std::nullopt; });
  EXPECT_TRUE(again.faults.empty()) << Faults(again.faults).what();
  EXPECT_EQ(written(again.manifest, WritingOptions{}), text);
  const Person& second = again.manifest.stimuli.at(0).people.at(1);
  EXPECT_EQ(second.start, -0.5);
  EXPECT_EQ(second.colour, "#d55e00");
  EXPECT_EQ(std::get<scenes::MannequinOptions>(*second.figure).build, 0.9);
  EXPECT_EQ(second.hands, scenes::Hands::hidden);
  EXPECT_EQ(second.motion.look.hands, scenes::Hands::hidden);
  EXPECT_FALSE(again.manifest.stimuli[0].people[0].hands);
  EXPECT_EQ(again.manifest.stimuli[0].people[0].place->turn, 90.0);
}

TEST(PeopleOfAStimulus, ExchangeTheirMotionsAsSwapSays) {
  const std::string pairs =
      std::string(two_pairs).replace(std::string(two_pairs).find("  - id: two"), 11,
                                     "    swap: {b: two}\n  - id: two") +
      "    swap: {b: one, a: one.b}\n";
  const Manifest manifest = people_manifest(pairs);
  const auto& [one, two] = std::pair(manifest.stimuli[0].people, manifest.stimuli[1].people);
  EXPECT_EQ(example_of(one[0]), "sad");
  EXPECT_EQ(example_of(one[1]), "tired");
  EXPECT_EQ(example_of(two[0]), "happy");
  EXPECT_EQ(example_of(two[1]), "happy");
  EXPECT_EQ(two[1].motion.id, "two.b");
  EXPECT_EQ(two[0].place->x, -1.0);
  // What was written is what was stated, so that a second reading does not exchange them back.
  const OrderedJson text = written(manifest, WritingOptions{});
  const Manifest again = parse_manifest(text.dump(), "/nowhere/m.yaml", [](const std::string&) {
                           return std::nullopt;
                         }).manifest;
  EXPECT_EQ(example_of(again.stimuli[0].people[1]), "tired");
  EXPECT_EQ(example_of(again.stimuli[1].people[1]), "happy");
}

TEST(PeopleOfAStimulus, AreRefusedASwapWithNobody) {
  const auto with_swap = [](const std::string& swap) {
    return people_faults(std::string(two_pairs) + "    swap: " + swap + "\n");
  };
  EXPECT_NE(with_swap("{c: one}")
                .find("m.yaml:9:12: stimuli[1].swap.c: \"c\" is not a person of "
                      "this stimulus"),
            std::string::npos)
      << with_swap("{c: one}");
  EXPECT_NE(with_swap("{a: ones}").find("did you mean \"one\"?"), std::string::npos);
  EXPECT_NE(with_swap("{a: two}").find("this is the person's own motion"), std::string::npos);
  EXPECT_NE(
      people_faults("  - {id: a, weights: {sad: 1}, swap: {a: b}}\n").find("there are no people"),
      std::string::npos);
}

TEST(PeopleOfAStimulus, KeepTheirSpaceUnlessSomebodyFromAFileHasAPlace) {
  const auto keeps = [](const std::string& people) {
    return keeps_captured_space(
        people_reading("  - {id: a, people: [" + people + "]}\n").manifest.stimuli.at(0));
  };
  EXPECT_TRUE(keeps("{clip: a.bvh}, {clip: b.bvh}"));
  EXPECT_TRUE(keeps("{clip: a.bvh}, {clip: b.bvh}, {weights: {sad: 1}, place: {x: 2}}"));
  EXPECT_FALSE(keeps("{clip: a.bvh}, {clip: b.bvh, place: {}}"));
  EXPECT_FALSE(keeps("{weights: {sad: 1}, place: {}}, {path: [{walk: 1}]}"));
}

}  // namespace
}  // namespace mien::pipeline

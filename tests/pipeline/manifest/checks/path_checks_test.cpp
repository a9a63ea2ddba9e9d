#include <ostream>
#include <string>

#include <gtest/gtest.h>

#include "pipeline/base/documents/fault.h"
#include "pipeline/manifest/checks/manifest_reader.h"
#include "pipeline/manifest/reading/manifest_yaml.h"

namespace mien::pipeline {
namespace {

struct BadPath {
  std::string path;   ///< what stands after `path:`
  std::string place;  ///< line and column, option, and what is wrong, as far as it is told
};

void PrintTo(const BadPath& bad, std::ostream* out) { *out << bad.path; }

class PathChecksTest : public testing::TestWithParam<BadPath> {};

std::vector<Fault> faults_of(const std::string& path) {
  const std::string text = "mien: 1\nstudy: s\nstimuli:\n  - id: a\n    path: " + path + "\n";
  return parse_manifest(text, "m.yaml",
                        [](const std::string&) { return std::optional<std::string>(); })
      .faults;
}

TEST_P(PathChecksTest, IsToldOnceWithPlaceAndRemedy) {
  const std::vector<Fault> faults = faults_of(GetParam().path);
  std::string all;
  for (const Fault& fault : faults) all += to_string(fault) + "\n";
  ASSERT_EQ(faults.size(), 1U) << all;
  const std::string told = to_string(faults.front());
  EXPECT_NE(told.find(GetParam().place), std::string::npos) << told;
  EXPECT_FALSE(faults.front().remedy.empty()) << told;
}

INSTANTIATE_TEST_SUITE_P(
    All, PathChecksTest,
    testing::Values(
        BadPath{"[]", ":5:11: stimuli[0].path: has 0 elements"},
        BadPath{"{script: []}", ":5:20: stimuli[0].path.script: has 0 elements"},
        BadPath{"walk", ":5:11: stimuli[0].path: must be a list or a map"},
        BadPath{"{pace: 1}", "stimuli[0].path: has none of script, points"},
        BadPath{"[{walk: 1, turn: 90}]", "stimuli[0].path[0]: walk and turn exclude each other"},
        BadPath{"[{mood: {sad: 1}}]", "stimuli[0].path[0]: has none of walk, turn, stand"},
        BadPath{"[{run: 1, walk: 1}]", "stimuli[0].path[0].run: unknown key"},
        BadPath{"[{walk: 0}]", ":5:19: stimuli[0].path[0].walk: 0 is out of range"},
        BadPath{"[{walk: 1, pace: 0}]",
                ":5:28: stimuli[0].path[0].pace: this is too slow for a walk"},
        BadPath{"[{walk: 1, pace: 3}]", "stimuli[0].path[0].pace: 3 is out of range"},
        BadPath{"[{stand: 1, pace: 1}]", "stimuli[0].path[0].pace: standing has no pace"},
        BadPath{"[{turn: 0}]", "stimuli[0].path[0].turn: this is not a turn"},
        BadPath{"[{turn: 90, curve: 20}]",
                "stimuli[0].path[0].curve: only walks can follow a curve"},
        BadPath{"[{stand: 1, curve: 20}]",
                "stimuli[0].path[0].curve: only walks can follow a curve"},
        BadPath{"[{walk: 1, mood: {sadd: 1}}]",
                ":5:29: stimuli[0].path[0].mood.sadd: the set has no walk of this name; did you "
                "mean \"sad\"?"},
        BadPath{"[{walk: 1, mood: {sad: 0}}]", "stimuli[0].path[0].mood: all weights are 0"},
        BadPath{"{set: builtin:walks-11, script: [{walk: 1}]}", "stimuli[0].path.set"},
        BadPath{"{set: builtin:walks-27, script: [{walk: 1, mood: {brisk: 1}}]}",
                "stimuli[0].path.script[0].mood.brisk: the set has no walk of this name"},
        BadPath{"{points: [[0, 0]]}", "stimuli[0].path.points: has 1 element but"},
        BadPath{"{points: [[0, 0], [0, 0.01]]}",
                "stimuli[0].path.points[1]: only 10 mm from the point before"},
        BadPath{"{points: [[0, 0], [0, 5], [0, 5]]}",
                "stimuli[0].path.points[2]: only 0 mm from the point before"},
        BadPath{"{points: [[0, 0], [0, 1, 2]]}", "stimuli[0].path.points[1]: has 3 elements"},
        BadPath{"{points: [[0, 0], [0, 9000]]}", "stimuli[0].path.points: this would take about"},
        BadPath{"{points: [[0, 0], [0, 5]], pace: 0}", "stimuli[0].path.pace: 0 is out of range"},
        BadPath{"{points: [[0, 0], [0, 5]], moods: [{at: 2, mood: {sad: 1}}, {at: 1, mood: {sad: "
                "1}}]}",
                "stimuli[0].path.moods[1].at: this is not later than the previous change"},
        BadPath{"[{walk: 2, mood: {quickness: 0.5, sad: 1}}]",
                "stimuli[0].path[0].mood.sad: this is not an adjective, but the other names of "
                "this mood are"},
        BadPath{"[{walk: 2, mood: {quickness: 1.5}}]",
                "stimuli[0].path[0].mood.quickness: adjectives range from 0 to 1"},
        BadPath{"{points: [[0, 0], [0, 5]], moods: [{at: 99, mood: {sad: 1}}]}",
                "stimuli[0].path.moods[0].at: the walk ends earlier, after at most 20 s"},
        BadPath{"{script: [{walk: 1}], moods: [{at: 2, mood: {sad: 1}}]}",
                "stimuli[0].path.moods: in a script, moods belong to steps"},
        BadPath{"[{walk: 400}, {walk: 300}]", ":5:11: stimuli[0].path: this would take about 12"}));

/// Moods of a graph are recipes of emotions.
TEST(PathChecks, AGraphsMoodsAreRecipes) {
  const std::string graph = "graph: [none.bvh], script: [{walk: 1, mood: ";
  const std::vector<Fault> faults = faults_of("{" + graph + "{sadd: 1}}]}");
  ASSERT_FALSE(faults.empty());
  std::string all;
  for (const Fault& fault : faults) all += to_string(fault) + "\n";
  EXPECT_NE(all.find("path.script[0].mood.sadd: there is no recipe for \"sadd\""),
            std::string::npos)
      << all;
  EXPECT_EQ(all.find("the set has no walk"), std::string::npos) << all;
}

TEST(PathChecks, AcceptsWhatCanBeWalked) {
  for (const std::string path :
       {"[{walk: 3}, {turn: 90}, {stand: 1, mood: {sad: 1}}]", "[{turn: 720, pace: 0}]",
        "{points: [[0, 0], [0, 2], [1, 3]], pace: 0.5, mood: {happy: 2, sad: 0}}",
        "{set: 'builtin:walks-27', script: [{walk: 1, curve: -20, pace: 1.2}]}"}) {
    EXPECT_TRUE(faults_of(path).empty()) << path << to_string(faults_of(path).front());
  }
}

/// Read, written and read again it is the same.
TEST(PathChecks, AreWrittenAsTheyAreRead) {
  for (const std::string path :
       {"[{walk: 3, curve: 5}, {turn: 90}, {stand: 1, mood: {sad: 1}}]",
        "{set: 'builtin:walks-27', points: [[0, 0], [0.5, 2]], pace: 0.5, moods: [{at: 1, mood: "
        "{happy-slow: 1}}]}"}) {
    const std::string text = "mien: 1\nstudy: s\nstimuli:\n  - {id: a, path: " + path + "}\n";
    const auto none = [](const std::string&) { return std::optional<std::string>(); };
    const ManifestReading once = parse_manifest(text, "m.yaml", none);
    const ManifestReading again = parse_manifest(manifest_yaml(once.manifest, ""), "m.yaml", none);
    ASSERT_TRUE(again.faults.empty());
    EXPECT_EQ(again.manifest.stimuli.at(0).walk, once.manifest.stimuli.at(0).walk);
    EXPECT_TRUE(once.manifest.stimuli.at(0).walk.has_value());
  }
}

}  // namespace
}  // namespace mien::pipeline

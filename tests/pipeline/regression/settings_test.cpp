#include "pipeline/regression/settings.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "pipeline/regression/approved_study.h"
#include "pipeline/regression/rendition.h"

namespace mien::pipeline {
namespace {

TEST(Settings, ThatChangeAreToldWithWhatTheyWere) {
  const std::vector<Setting> before = {{"weights.sad", Aspect::motion, "0.4"},
                                       {"look.camera.view", Aspect::scene, "\"side\""},
                                       {"seed", Aspect::drawing, "1"}};
  const std::vector<Setting> now = {{"weights.sad", Aspect::motion, "0.5"},
                                    {"seed", Aspect::drawing, "1"},
                                    {"output.shutter", Aspect::drawing, "180"}};
  const std::vector<SettingChange> changes = changes_between(before, now);
  ASSERT_EQ(changes.size(), 3u);
  EXPECT_EQ(change_text(changes[0]), "weights.sad 0.4 → 0.5");
  EXPECT_EQ(change_text(changes[1]), "look.camera.view \"side\" was removed");
  EXPECT_EQ(change_text(changes[2]), "output.shutter 180 is new");
  EXPECT_TRUE(changes_between(now, now).empty());
}

TEST(Settings, OfAStimulusHaveTheAspectThatTheyChangeFirst) {
  const test::TemporaryFolder scratch;
  const test::ChangedStudy study = test::approved_study().copied(scratch.path() / "study");
  const auto rendition = test::rendition_of(study, scratch.path() / "store");
  const Manifest& manifest = rendition->manifest();
  const auto settings =
      settings_of(*find_stimulus(manifest, "someone"), manifest, rendition->files());
  const auto aspect_of = [&](const std::string& path) {
    const auto found = std::ranges::find(settings, path, &Setting::path);
    EXPECT_NE(found, settings.end()) << path;
    return found == settings.end() ? "" : std::string(name_of(found->aspect));
  };
  EXPECT_EQ(aspect_of("weights.happy"), "motion");
  EXPECT_EQ(aspect_of("output.fps"), "motion");
  EXPECT_EQ(aspect_of("examples content"), "motion");
  EXPECT_EQ(aspect_of("look.figure content"), "scene");
  EXPECT_EQ(aspect_of("output.size"), "scene");
  EXPECT_EQ(aspect_of("output.quality"), "drawing");
  EXPECT_EQ(aspect_of("seed"), "drawing");
  EXPECT_EQ(aspect_of("output.video"), "video");
}

TEST(Settings, OfALookAreToldFromTheDefault) {
  const test::TemporaryFolder scratch;
  test::ChangedStudy study = test::approved_study().copied(scratch.path() / "study");
  const auto settings = [&] {
    const auto rendition = test::rendition_of(study, scratch.path() / "store");
    const Manifest& manifest = rendition->manifest();
    return settings_of(*find_stimulus(manifest, "blend"), manifest, rendition->files());
  };
  const std::vector<Setting> before = settings();
  study.stimulus("blend")["look"] = {{"camera", "side"}, {"figure", "mannequin"}};
  const std::vector<SettingChange> changes = changes_between(before, settings());
  std::vector<std::string> texts;
  for (const SettingChange& change : changes) texts.push_back(change_text(change));
  const auto has = [&](const char* text) { return std::ranges::find(texts, text) != texts.end(); };
  EXPECT_TRUE(has("look.camera.view \"three-quarter\" → \"side\"")) << texts.at(0);
  EXPECT_TRUE(has("look.figure \"stick\" → \"mannequin\"")) << texts.at(0);
}

TEST(Settings, OfALightThatMovedAreToldFromWhatItWasByDefault) {
  const test::TemporaryFolder scratch;
  const test::ChangedStudy study = test::approved_study().copied(scratch.path() / "study");
  const auto settings = [&] {
    const auto rendition = test::rendition_of(study, scratch.path() / "store");
    const Manifest& manifest = rendition->manifest();
    return settings_of(*find_stimulus(manifest, "tinted"), manifest, rendition->files());
  };
  study.change_text("my.set.yaml", "{azimuth: -28, elevation: 52,", "{");
  const std::vector<Setting> before = settings();
  study.change_text("my.set.yaml", "  - {", "  - {azimuth: 30, ");
  study.change_text("my.set.yaml", "#c08040", "#c08041");
  study.change_text("my.set.yaml", "below: [0.1,", "below: [0.12,");
  const std::vector<Setting> now = settings();
  const auto texts = [](const std::vector<SettingChange>& changes) {
    std::vector<std::string> told;
    for (const SettingChange& change : changes) told.push_back(change_text(change));
    std::ranges::sort(told);
    return told;
  };
  EXPECT_EQ(texts(changes_between(before, now)),
            (std::vector<std::string>{"set.ground.colour \"#c08040\" → \"#c08041\"",
                                      "set.lights[0].azimuth -28 → 30",
                                      "set.sky.below [0.1, 0.1, 0.1] → [0.12, 0.1, 0.1]"}));
  EXPECT_EQ(texts(changes_between(now, before)),
            (std::vector<std::string>{"set.ground.colour \"#c08041\" → \"#c08040\"",
                                      "set.lights[0].azimuth 30 → -28",
                                      "set.sky.below [0.12, 0.1, 0.1] → [0.1, 0.1, 0.1]"}));
}

TEST(Settings, OfALightThatIsAddedAreNew) {
  const std::vector<Setting> before = {{"set.lights[0].strength", Aspect::scene, "0.7"}};
  std::vector<Setting> now = before;
  now.push_back({"set.lights[1].strength", Aspect::scene, "0.2"});
  const std::vector<SettingChange> changes = changes_between(before, now);
  ASSERT_EQ(changes.size(), 1u);
  EXPECT_EQ(change_text(changes[0]), "set.lights[1].strength 0.2 is new");
}

/// Of a step without an emotion; else the recipe says what it was.
TEST(Settings, OfAStepAreToldFromTheDefaultUnlessItHasARecipe) {
  const auto told = [](const std::string& step, const Setting& first, const Setting& added) {
    const std::vector<Setting> before = {{step + first.path, Aspect::motion, first.value}};
    std::vector<Setting> now = before;
    now.push_back({step + added.path, Aspect::motion, added.value});
    std::string texts;
    for (const SettingChange& change : changes_between(before, now)) texts += change_text(change);
    for (const SettingChange& change : changes_between(now, before))
      texts += "; " + change_text(change);
    return texts;
  };
  const Setting paths = {"paths", Aspect::motion, "0.7"};
  const Setting sad = {"emotion", Aspect::motion, "\"sad\""};
  for (const std::string step : {"modify.", "modify[1]."}) {
    EXPECT_EQ(told(step, paths, {"tempo", Aspect::motion, "1.2"}),
              step + "tempo 1 → 1.2; " + step + "tempo 1.2 → 1");
    for (const Setting& first : {paths, sad})
      EXPECT_EQ(told(step, first, {"strength", Aspect::motion, "0.5"}),
                step + "strength 1 → 0.5; " + step + "strength 0.5 → 1");
    EXPECT_NE(told(step, sad, paths).find("paths 0.7 is new"), std::string::npos)
        << told(step, sad, paths);
  }
}

TEST(Settings, NameTheFilesThatAreOthers) {
  EXPECT_EQ(
      change_text({"examples content", Aspect::motion,
                   R"({"calm.bvh":"01","old.bvh":"02","sad.bvh":"03"})",
                   R"({"calm.bvh":"01","happy.bvh":"05","sad.bvh":"04"})"}),
      "examples content: old.bvh was removed, sad.bvh has changed (03 → 04), happy.bvh is new");
}

}  // namespace
}  // namespace mien::pipeline

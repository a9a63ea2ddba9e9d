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
  EXPECT_EQ(change_text(changes[1]), "look.camera.view \"side\" is gone");
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

}  // namespace
}  // namespace mien::pipeline

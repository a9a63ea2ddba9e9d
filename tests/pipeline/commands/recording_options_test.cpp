#include "pipeline/commands/line/recording_options.h"

#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "motion/refusal.h"
#include "pipeline/commands/line/examples_option.h"
#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

using test::refusal_of;

bool contains_words(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}

class NamedRecordings : public testing::Test {
 protected:
  /// A file of that name, whose contents do not matter.
  std::string file(const std::string& name) const {
    const std::string path = (folder_.path() / name).string();
    std::ofstream(path) << "any";
    return path;
  }

 private:
  test::TemporaryFolder folder_;
};

TEST_F(NamedRecordings, HaveATakeAfterTheHash) {
  const std::string walk = file("walk.fbx");
  EXPECT_EQ(named_recording(walk + "#Run").file, walk);
  EXPECT_EQ(named_recording(walk + "#Run").how.take, "Run");
  EXPECT_EQ(named_recording(walk).how.take, std::nullopt);
  EXPECT_EQ(named_recording(walk + "#Run", {.takes = {"Run"}}).how.take, "Run");
  EXPECT_EQ(named_recording("gone.fbx#Run").file, "gone.fbx#Run");
}

TEST_F(NamedRecordings, MayHaveAHashInTheirName) {
  file("walk.fbx");
  const std::string walk = file("walk.fbx#Run");
  EXPECT_EQ(named_recording(walk).file, walk);
  EXPECT_EQ(named_recording(walk).how.take, std::nullopt);
  EXPECT_EQ(named_recording(walk + "#2").file, walk);
  EXPECT_EQ(named_recording(walk + "#2").how.take, "2");
  const std::string numbered = file("walk #3.bvh");
  EXPECT_EQ(named_recording(numbered).file, numbered);
}

TEST_F(NamedRecordings, HaveOneTakeOnly) {
  const std::string walk = file("walk.fbx");
  const std::string said = refusal_of([&] { named_recording(walk + "#Run", {.takes = {"Walk"}}); });
  EXPECT_TRUE(contains_words(said, "names the take \"Run\" of this file, not \"Walk\"")) << said;
}

TEST_F(NamedRecordings, AreReadAsTheOptionsSay) {
  const NamedRecording named = named_recording(
      file("a.csv"), {.subjects = {"2"}, .rates = {50.0}, .joints = {"head,left hand"}});
  EXPECT_EQ(named.how.subject, "2");
  EXPECT_EQ(named.how.frames_per_second, 50.0);
  EXPECT_EQ(named.how.joints, (std::vector<std::string>{"head", "left hand"}));
}

TEST_F(NamedRecordings, TakeWhatIsGivenOnceWhereItApplies) {
  const std::vector<NamedRecording> files = named_recordings(
      {file("a.bvh"), file("b.glb"), file("c.npy"), file("d.fbx") + "#Run"},
      {.takes = {"Walk"}, .subjects = {"Ann"}, .rates = {50.0}, .joints = {"smpl"}});
  EXPECT_EQ(files[0].how, (motion::ReadOptions{.subject = "Ann", .frames_per_second = 50.0}));
  EXPECT_EQ(files[1].how,
            (motion::ReadOptions{.take = "Walk", .subject = "Ann", .frames_per_second = 50.0}));
  EXPECT_EQ(files[2].how, (motion::ReadOptions{.frames_per_second = 50.0, .joints = {"smpl"}}));
  EXPECT_EQ(files[3].how.take, "Run");
}

TEST_F(NamedRecordings, TakeWhatIsGivenForEachInTheirOrder) {
  const std::vector<NamedRecording> files =
      named_recordings({file("a.c3d"), file("b.glb")},
                       {.takes = {"", "Walk"}, .subjects = {"Ann", ""}, .rates = {50.0, 60.0}});
  EXPECT_EQ(files[0].how, (motion::ReadOptions{.subject = "Ann", .frames_per_second = 50.0}));
  EXPECT_EQ(files[1].how, (motion::ReadOptions{.take = "Walk", .frames_per_second = 60.0}));
}

// So that its reader says why.
TEST_F(NamedRecordings, AreAskedForWhatAppliesToNone) {
  const std::vector<NamedRecording> files =
      named_recordings({file("a.bvh"), file("b.bvh")}, {.takes = {"Walk"}});
  EXPECT_EQ(files[0].how.take, "Walk");
  EXPECT_EQ(files[1].how.take, std::nullopt);
}

TEST_F(NamedRecordings, RefuseOtherNumbersOfValues) {
  const std::vector<std::string> three = {file("a.glb"), file("b.glb"), file("c.glb")};
  const std::string said = refusal_of([&] { named_recordings(three, {.takes = {"1", "2"}}); });
  EXPECT_TRUE(contains_words(said, "--take was given 2 times for 3 files")) << said;
  EXPECT_TRUE(contains_words(said, "once for each")) << said;
  const std::string one = refusal_of([&] { named_recording(three[0], {.subjects = {"1", "2"}}); });
  EXPECT_TRUE(contains_words(one, "--subject was given 2 times for one file")) << one;
}

TEST(ExamplesOfTheCommandLine, AreReadAsTheOptionsSay) {
  const test::TemporaryFolder folder;
  std::ofstream(folder.path() / "a.bvh");
  const std::string single =
      refusal_of([&] { examples_of(folder.path().string(), {.takes = {"Walk"}}); });
  EXPECT_TRUE(contains_words(single, "none of the files can hold several motions")) << single;
  std::ofstream(folder.path() / "b.glb");
  const Examples examples =
      examples_of(folder.path().string(), {.takes = {"Walk"}, .rates = {50.0}});
  EXPECT_EQ(examples.how.take, "Walk");
  EXPECT_EQ(examples.how.fps, 50.0);
  const std::string said =
      refusal_of([] { examples_of("builtin:walks-10", {.subjects = {"Ann"}}); });
  EXPECT_TRUE(contains_words(said, "not to a built-in set")) << said;
}

}  // namespace
}  // namespace mien::pipeline

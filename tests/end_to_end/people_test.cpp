// Files of several people, and the options that choose among them.

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "end_to_end/program.h"
#include "end_to_end/two_people.h"

namespace mien::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

bool names(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// Ann walks happily; Bo, tired, starts two metres to her side. The files ann.bvh, bo.bvh and
/// both.bvh lie in the folder.
class People : public testing::Test {
 protected:
  void SetUp() override {
    blend("happy", "ann.bvh");
    blend("tired", "bo.bvh");
    const TwoPeople people = two_people(text_of(file("ann.bvh")), text_of(file("bo.bvh")));
    std::ofstream(file("both.bvh")) << people.both;
    std::ofstream(file("bo.bvh")) << people.second;
  }

  std::string file(const std::string& name) const { return (scratch_.path() / name).string(); }

  Ended still(std::vector<std::string> arguments, const std::string& picture) const {
    arguments.insert(arguments.begin(), "render");
    arguments.insert(arguments.end(), {"-o", file(picture), "--still", "0.2", "--size", "160x90",
                                       "--quality", "draft"});
    return run_mien(arguments);
  }

 private:
  void blend(const std::string& style, const std::string& name) const {
    ASSERT_EQ(run_mien({"motion", "blend", "--examples", "builtin:walks-10", "--weights",
                        style + "=1", "-o", file(name)})
                  .code,
              0);
  }

  Scratch scratch_;
};

TEST_F(People, AreListedAndChosenByNameOrNumber) {
  const Ended first = run_mien({"motion", "info", file("both.bvh"), "--json"});
  ASSERT_EQ(first.code, 0) << first.errors;
  const json found = json::parse(first.output);
  EXPECT_EQ(found["people"], (json{"Ann", "Bo"}));
  EXPECT_EQ(found["person"], "Ann");
  const Ended text = run_mien({"motion", "info", file("both.bvh"), "--subject", "2"});
  EXPECT_TRUE(names(text.output, "people   Ann, Bo (showing Bo)")) << text.output;
  // The second file has one person, who has the same name.
  const Ended same = run_mien(
      {"motion", "compare", file("both.bvh"), file("bo.bvh"), "--subject", "Bo", "--json"});
  ASSERT_EQ(same.code, 0) << same.errors;
  EXPECT_EQ(json::parse(same.output)["D"], 0.0);
}

TEST_F(People, AreComparedWithinOneFile) {
  const auto distance = [&](const std::string& first, const std::string& second) {
    const Ended ended = run_mien({"motion", "compare", file("both.bvh"), file("both.bvh"),
                                  "--subject", first, "--subject", second, "--json"});
    EXPECT_EQ(ended.code, 0) << ended.errors;
    return json::parse(ended.output);
  };
  EXPECT_EQ(distance("Ann", "1")["D"], 0.0);
  const json other = distance("Ann", "Bo");
  EXPECT_GT(other["D"], 0.01);
  EXPECT_EQ(other["people"], (json{{"target", "Ann"}, {"created", "Bo"}}));
  EXPECT_EQ(
      run_mien({"regress", file("both.bvh"), file("bo.bvh"), "--subject", "Bo", "--subject", "1"})
          .code,
      0);
}

TEST_F(People, WhoAreNotThereAreRefusedByEveryCommand) {
  const std::string both = file("both.bvh"), out = file("out.bvh");
  for (const std::vector<std::string>& command : {std::vector<std::string>{"motion", "info", both},
                                                  {"motion", "convert", both, out},
                                                  {"motion", "features", both},
                                                  {"motion", "lint", both},
                                                  {"motion", "modify", both, "sad", out},
                                                  {"motion", "compare", both, both},
                                                  {"motion", "stream", both, "paths: 1.2"},
                                                  {"regress", both, both},
                                                  {"render", both}}) {
    std::vector<std::string> arguments = command;
    arguments.insert(arguments.end(), {"--subject", "Cy"});
    const Ended ended = run_mien(arguments);
    EXPECT_EQ(ended.code, 2) << command[1];
    EXPECT_TRUE(names(ended.errors, "there is no subject \"Cy\"; it holds Ann, Bo"))
        << command[1] << ": " << ended.errors;
  }
  EXPECT_FALSE(fs::exists(out));
}

TEST_F(People, AreAllShownByRenderOnly) {
  const Ended info = run_mien({"motion", "info", file("both.bvh"), "--subject", "all"});
  EXPECT_EQ(info.code, 2);
  EXPECT_TRUE(names(info.errors, "choose one of these; only mien render shows everyone"))
      << info.errors;
}

TEST_F(People, AreModifiedAndStreamedLikeThoseInFilesOfTheirOwn) {
  const auto modified = [&](std::vector<std::string> arguments) {
    const Ended ended = run_mien(arguments);
    EXPECT_EQ(ended.code, 0) << ended.errors;
    return text_of(file("sad.bvh"));
  };
  const std::string sad = file("sad.bvh");
  const std::string from_both =
      modified({"motion", "modify", file("both.bvh"), "sad", sad, "--subject", "Bo"});
  EXPECT_EQ(from_both, modified({"motion", "modify", file("bo.bvh"), "sad", sad}));
  const Ended streamed =
      run_mien({"motion", "stream", file("both.bvh"), "paths: 1.2", "--subject", "Bo"});
  ASSERT_EQ(streamed.code, 0) << streamed.errors;
  EXPECT_EQ(streamed.output, run_mien({"motion", "stream", file("bo.bvh"), "paths: 1.2"}).output);
}

TEST_F(People, OfOneFileAreShownTogetherWhereTheyWere) {
  ASSERT_EQ(still({file("both.bvh"), "--subject", "all"}, "all.png").code, 0);
  ASSERT_EQ(still({file("both.bvh"), "--subject", "Bo"}, "bo.png").code, 0);
  EXPECT_NE(text_of(file("all.png")), text_of(file("bo.png")));
  // Everybody is where they were, so that point lights can be told apart.
  const std::vector<std::string> lights = {"--figure", "point-light"};
  ASSERT_EQ(still({file("both.bvh"), "--subject", "all", lights[0], lights[1]}, "a.png").code, 0);
  ASSERT_EQ(still({file("both.bvh"), "--subject", "Bo", lights[0], lights[1]}, "b.png").code, 0);
  EXPECT_NE(text_of(file("a.png")), text_of(file("b.png")));
  const Ended one = still({file("ann.bvh"), "--subject", "all"}, "one.png");
  EXPECT_EQ(one.code, 0) << one.errors;
}

TEST_F(People, OfOneFileAreAnOverlayInAManifest) {
  std::ofstream(file("two.yaml")) << R"(mien: 1
study: two
output: {size: [64, 36], fps: 10, cycles: 1, quality: draft, video: [gif]}
stimuli:
  - {id: ann, clip: {file: both.bvh, subject: Ann}}
  - {id: bo, clip: {file: both.bvh, subject: 2}}
overlays:
  - {target: ann, created: bo, layout: as-recorded}
)";
  const Ended ended = run_mien({"run", file("two.yaml"), "--out", file("out")});
  EXPECT_EQ(ended.code, 0) << ended.errors;
  EXPECT_TRUE(fs::exists(file("out") + "/two/videos/ann_with_bo.gif"));
}

}  // namespace
}  // namespace mien::test

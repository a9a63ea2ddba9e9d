#include "motion/examples/example_set.h"

#include <cmath>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "motion/formats/motion_file.h"
#include "motion/math/rotation.h"
#include "motion/modify/posture.h"
#include "motion/procedural/walker.h"
#include "motion/refusal.h"
#include "pipeline/temporary_folder.h"

#include "real_data.h"

namespace mien::motion {
namespace {

namespace fs = std::filesystem;

TEST(ExampleSet, OfNoFolderOrNoMatchIsRefused) {
  ExampleFolder folder;
  folder.path = fs::temp_directory_path() / "mien-no-such-folder";
  EXPECT_NE(test::refusal_of([&] { load_examples(folder); }).find("is not a readable folder"),
            std::string::npos);
  folder.path = fs::path(testing::TempDir()) / "mien-empty-folder";
  fs::create_directories(folder.path);
  std::ofstream(folder.path / "notes.txt") << "no motion";
  EXPECT_NE(test::refusal_of([&] { load_examples(folder); }).find("no motion file that matches"),
            std::string::npos);
}

TEST(ExampleSet, NamesAllFilesThatCannotBeUsed) {
  const test::TemporaryFolder own;
  ExampleFolder folder;
  folder.path = own.path();
  std::ofstream(folder.path / "broken.bvh") << "HIERARCHY\nROOT Hips\n";
  std::string said = test::refusal_of([&] { load_examples(folder); });
  EXPECT_TRUE(said.starts_with((folder.path / "broken.bvh").string() + ":")) << said;
  std::ofstream(folder.path / "empty.bvh") << "";
  std::ofstream(folder.path / "pose.bvh")
      << "HIERARCHY\nROOT Hips\n{\nOFFSET 0 0 0\nCHANNELS 6 Xposition Yposition Zposition "
         "Zrotation "
         "Xrotation Yrotation\nEnd Site\n{\nOFFSET 0 1 0\n}\n}\nMOTION\nFrames: 1\nFrame Time: "
         "0.1\n0 0 0 0 0 0\n";
  said = test::refusal_of([&] { load_examples(folder); });
  EXPECT_TRUE(said.starts_with(folder.path.string() + ": 3 files cannot be used: ")) << said;
  for (const char* part :
       {"broken.bvh:", " | ", "empty.bvh:", "pose.bvh: it holds fewer than two frames",
        "; mend them, or omit them with exclude"})
    EXPECT_NE(said.find(part), std::string::npos) << said;
}

TEST(ExampleSet, LeavesHiddenFilesOut) {
  ExampleFolder folder;
  folder.path = fs::path(testing::TempDir()) / "mien-hidden-files";
  fs::create_directories(folder.path);
  for (const char* name : {"walk.bvh", "._walk.bvh", ".walk.bvh"})
    std::ofstream(folder.path / name) << "HIERARCHY";
  EXPECT_EQ(example_files(folder), (std::vector<fs::path>{folder.path / "walk.bvh"}));
}

TEST(ExampleSet, TakesTablesOnlyByTheirEnding) {
  ExampleFolder folder;
  folder.path = fs::path(testing::TempDir()) / "mien-folder-with-tables";
  fs::create_directories(folder.path);
  for (const char* name : {"a.bvh", "b.bvh.gz", "answers.csv", "t.npz", "u.csv.gz"})
    std::ofstream(folder.path / name) << "x";
  const auto found = [&](const std::string& include) {
    folder.include = include;
    std::vector<std::string> names;
    for (const fs::path& file : example_files(folder)) names.push_back(file.filename().string());
    return names;
  };
  using Names = std::vector<std::string>;
  EXPECT_EQ(found("*"), (Names{"a.bvh", "b.bvh.gz"}));
  EXPECT_EQ(found("{a,b,t,u}*"), (Names{"a.bvh", "b.bvh.gz"}));
  EXPECT_EQ(found("*.csv"), Names{"answers.csv"});
  EXPECT_EQ(found("*.{npz,bvh}"), (Names{"a.bvh", "t.npz"}));
  EXPECT_EQ(found("{*.npz,*.csv.gz}"), (Names{"t.npz", "u.csv.gz"}));
  folder.include = "*.bvh*";
  EXPECT_EQ(example_names(folder), (Names{"a", "b"}));
}

TEST(ExampleSet, OfAWalkAndAGestureSaysWhichKeytimesWereFound) {
  const test::TemporaryFolder files;
  Clip walks = repeated(walk({}, 60.0, standard_body()).clip, 4);
  walks.loops = false;
  walks.cycle_displacement = Vec3::Zero();
  Clip wave = walks;
  for (int f = 0; f < wave.frame_count(); ++f) {
    Pose& pose = wave.poses[static_cast<std::size_t>(f)];
    pose = standing_pose(wave.body);
    pose.rotations[RightShoulder] = exp(Vec3(0, 0, 1.0 + std::sin(0.1 * f)));
  }
  write_motion(to_recording(walks), files.path() / "walk.bvh");
  write_motion(to_recording(walks), files.path() / "march.npz");
  write_motion(to_recording(wave), files.path() / "wave.bvh");
  ExampleFolder folder;
  folder.path = files.path();
  folder.include = "*.{bvh,npz}";
  const std::string refusal = test::refusal_of([&] { load_examples(folder); });
  const auto has = [&](const std::string& words) {
    return refusal.find(words) != std::string::npos;
  };
  // The one that differs comes first.
  EXPECT_TRUE(has("the same number of keytimes, but \"wave\" has ")) << refusal;
  EXPECT_TRUE(has("of the whole motion (no gait cycle was found: no heel strike); \"march\" has 7"))
      << refusal;
  EXPECT_TRUE(has("\"walk\" has 7: a gait cycle (frames ")) << refusal;
  EXPECT_TRUE(has("cycle: whole")) << refusal;
  folder.cycle = CycleChoice::whole;
  EXPECT_NO_THROW(load_examples(folder));
}

class RealExamples : public testing::Test {
 protected:
  void SetUp() override {
    const auto data = test::real_data();
    if (!data) GTEST_SKIP() << "no motion capture here: set MIEN_DATA to the folder that has it";
    mocap = *data / "mocap";
  }

  LoadedExamples load(const std::string& folder, const std::string& include) const {
    ExampleFolder source;
    source.path = mocap / folder;
    source.include = include;
    return load_examples(source);
  }

  fs::path mocap;
};

TEST_F(RealExamples, OfThirtyWalksStandOnOneBody) {
  const LoadedExamples loaded = load("bandai-namco-1", "*walk*.bvh");
  const std::vector<Example>& examples = loaded.set.examples;
  ASSERT_EQ(examples.size(), 30u);
  EXPECT_EQ(examples[0].name, "active_001");
  EXPECT_EQ(examples[0].clip.name, "dataset-1_walk_active_001");
  EXPECT_EQ(loaded.file_stems[0], "dataset-1_walk_active_001");
  for (const Example& example : examples) {
    EXPECT_EQ(example.keytimes.size(), 7u) << example.name;
    EXPECT_TRUE(example.clip.loops) << example.name;
    for (int j = 0; j < body_joint_count; ++j) {
      EXPECT_EQ(example.clip.body.joints[j].offset, examples[0].clip.body.joints[j].offset);
    }
  }
}

TEST_F(RealExamples, OfTwoActorsStandOnOneBody) {
  const LoadedExamples loaded = load("aalto-two-actors", "*.bvh");
  EXPECT_EQ(loaded.set.examples.size(), 24u);
  for (const Example& example : loaded.set.examples) EXPECT_EQ(example.keytimes.size(), 7u);
}

TEST_F(RealExamples, OfFarewellsKeepAsManyPausesAsAllHave) {
  const LoadedExamples loaded = load("bandai-namco-1", "*bye*.bvh");
  ASSERT_EQ(loaded.set.examples.size(), 15u);
  EXPECT_EQ(loaded.set.examples[0].name, "active");
  for (const Example& example : loaded.set.examples) {
    EXPECT_FALSE(example.clip.loops) << example.name;
    EXPECT_EQ(example.keytimes.size(), loaded.set.examples[0].keytimes.size()) << example.name;
    EXPECT_GE(example.keytimes.size(), 3u);
  }
}

TEST_F(RealExamples, OfFarewellsHaveAPeak) {
  ExampleFolder source;
  source.path = mocap / "bandai-namco-1";
  source.include = "*bye*.bvh";
  source.cycle = CycleChoice::start_peak_end;
  const LoadedExamples loaded = load_examples(source);
  ASSERT_EQ(loaded.set.examples.size(), 15u);
  for (const Example& example : loaded.set.examples) {
    EXPECT_EQ(example.keytimes.size(), 3u) << example.name;
  }
}

TEST_F(RealExamples, WithKeytimesByHandNeedThemForEveryFileAndNoOther) {
  ExampleFolder source;
  source.path = mocap / "bandai-namco-1";
  source.include = "*bye_*o*d*_001.bvh";
  source.keytimes = {{"dataset-1_bye_proud_001", {2.07, 2.27, 2.5}}};
  EXPECT_NE(test::refusal_of([&] {
              load_examples(source);
            }).find("\"dataset-1_bye_not-confident_001\" has no keytimes"),
            std::string::npos);
  source.keytimes.emplace_back("dataset-1_bye_not-confidnt_001", std::vector{1.0, 2.0, 3.0});
  EXPECT_NE(test::refusal_of([&] {
              load_examples(source);
            }).find("did you mean \"dataset-1_bye_not-confident_001\"?"),
            std::string::npos);
  source.keytimes.back() = {"dataset-1_bye_not-confident_001", {1.87, 2.03, 2.23}};
  source.keytimes.emplace_back("dataset-1_bye_old_001", std::vector{0.67, 1.33, 2.1});
  const LoadedExamples loaded = load_examples(source);
  ASSERT_EQ(loaded.set.examples.size(), 3u);
  for (const Example& example : loaded.set.examples) {
    EXPECT_FALSE(example.clip.loops);
    EXPECT_EQ(example.keytimes.size(), 3u) << example.name;
    EXPECT_NEAR(example.keytimes.back(), example.clip.duration_seconds(), 1e-12);
  }
}

TEST_F(RealExamples, OfWalksAndFarewellsMixedAreRefused) {
  EXPECT_NE(test::refusal_of([&] { load("bandai-namco-1", "*_sad_*.bvh"); }).find("keytimes"),
            std::string::npos);
}

TEST(Labels, AreWhatTellsNamesApart) {
  const std::vector<std::string> takes = {"dataset-1_walk_sad_001", "dataset-1_walk_sad_002",
                                          "dataset-1_walk_not-confident_001"};
  EXPECT_EQ(labels_from_names(takes),
            (std::vector<std::string>{"sad_001", "sad_002", "not-confident_001"}));
  const std::vector<std::string> single = {"dataset-1_bye_sad_001", "dataset-1_bye_normal_001"};
  EXPECT_EQ(labels_from_names(single), (std::vector<std::string>{"sad", "normal"}));
}

TEST(Labels, NeverCutWords) {
  const std::vector<std::string> names = {"walk_sadness", "walk_gladness"};
  EXPECT_EQ(labels_from_names(names), (std::vector<std::string>{"sadness", "gladness"}));
}

TEST(Labels, OfOneNameOrOfNestedNamesStayWhole) {
  EXPECT_EQ(labels_from_names(std::vector<std::string>{"walk_1"}),
            (std::vector<std::string>{"walk_1"}));
  const std::vector<std::string> nested = {"walk_", "walk_sad"};
  EXPECT_EQ(labels_from_names(nested), nested);
  EXPECT_TRUE(labels_from_names(std::vector<std::string>{}).empty());
}

}  // namespace
}  // namespace mien::motion

#include "house/rooms.h"

#include <fstream>

#include <gtest/gtest.h>

#include "pipeline/temporary_folder.h"

namespace mien::test {
namespace {

namespace fs = std::filesystem;
using Faults = std::vector<std::string>;

/// A tree of two rooms, the second of which may include the first.
class SmallHouse : public testing::Test {
 protected:
  void write(const std::string& file, const std::string& text) {
    fs::create_directories((tree() / file).parent_path());
    std::ofstream(tree() / file) << text;
  }

  void SetUp() override {
    write("motion/rooms.txt", "# floors\nmath: -\ngait: math\n");
    write("motion/math/filter.h", "#pragma once\n");
    write("motion/gait/stride.cpp", "#include \"motion/math/filter.h\"\n");
  }

  const fs::path& tree() const { return folder_.path(); }

 private:
  TemporaryFolder folder_;
};

TEST(Rooms, IncludeOnlyWhatTheirPlanAllows) {
  EXPECT_GT(include_lines(MIEN_SOURCE_DIR).size(), 1500u);
  EXPECT_EQ(faults_of_rooms(MIEN_SOURCE_DIR), Faults{});
}

TEST_F(SmallHouse, WithoutFaultsHasNone) { EXPECT_EQ(faults_of_rooms(tree()), Faults{}); }

TEST_F(SmallHouse, TellsFileLineAndArrowOfAnIncludeThatRunsBack) {
  write("motion/math/filter.h", "#pragma once\n\n#include \"motion/gait/stride.h\"\n");
  EXPECT_EQ(faults_of_rooms(tree()), Faults{"motion/math/filter.h:3: motion/math may not include "
                                            "motion/gait (motion/rooms.txt)"});
}

TEST_F(SmallHouse, TellsAnArrowThatNobodyUses) {
  write("motion/gait/stride.cpp", "");
  EXPECT_EQ(faults_of_rooms(tree()), Faults{"motion/gait does not include motion/math"});
}

TEST_F(SmallHouse, TellsARoomThatIsNotInThePlan) {
  write("motion/dance/step.cpp", "");
  EXPECT_EQ(faults_of_rooms(tree()),
            Faults{"motion/dance/step.cpp: rooms.txt does not name motion/dance"});
}

/// Two wings of pipeline, of which the second may include the first.
class SmallWings : public SmallHouse {
 protected:
  void SetUp() override {
    write("pipeline/wings.txt", "base: -\nfarm: base | motion\n");
    write("pipeline/base/documents/table.h", "#include \"pipeline/base/statistics/mean.h\"\n");
    write("pipeline/farm/slurm/job.cpp",
          "#include \"pipeline/base/documents/table.h\"\n#include \"motion/gait/stride.h\"\n");
    write("motion/gait/stride.h", "#include \"motion/math/filter.h\"\n");
  }
};

TEST(Wings, IncludeOnlyWhatTheirPlanAllows) {
  EXPECT_EQ(faults_of_wings(MIEN_SOURCE_DIR), Faults{});
}

TEST_F(SmallWings, WithoutFaultsHaveNone) { EXPECT_EQ(faults_of_wings(tree()), Faults{}); }

TEST_F(SmallWings, TellAnIncludeThatRunsBackFromAnyOfTheirRooms) {
  write("pipeline/base/documents/table.h", "#include \"pipeline/farm/slurm/job.h\"\n");
  EXPECT_EQ(faults_of_wings(tree()),
            Faults{"pipeline/base/documents/table.h:1: pipeline/base may not include "
                   "pipeline/farm (pipeline/wings.txt)"});
}

TEST_F(SmallWings, TellAWingThatIsNotInThePlan) {
  write("pipeline/tower/bell.h", "");
  EXPECT_EQ(faults_of_wings(tree()),
            Faults{"pipeline/tower/bell.h: wings.txt does not name pipeline/tower"});
}

TEST_F(SmallHouse, TellsAPlanThatRunsInACircle) {
  write("motion/rooms.txt", "math: gait\ngait: math\n");
  write("motion/math/filter.h", "#include \"motion/gait/stride.h\"\n");
  EXPECT_EQ(faults_of_rooms(tree()),
            Faults{"motion/math names motion/gait, which is not below it"});
}

}  // namespace
}  // namespace mien::test

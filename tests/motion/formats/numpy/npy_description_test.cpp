#include "motion/formats/numpy/npy_description.h"

#include <fstream>

#include <gtest/gtest.h>

#include "motion/formats/numpy/npy_positions.h"
#include "motion/refusal.h"
#include "motion/text/result_file.h"
#include "pipeline/temporary_folder.h"

namespace mien::motion {
namespace {

PointRecording two_points() {
  PointRecording points;
  points.name = "a";
  points.points = {"hip", "knee"};
  points.frames_per_second = 50.0;
  points.unit = "mm";
  points.metres_per_unit = 0.001;
  points.positions = {Vec3(1, 2, 3), Vec3(0, 0, 0), Vec3(4, 5, 6), Vec3(7, 8, 9)};
  points.seen = {true, false, true, true};
  return points;
}

class NpyDescriptions : public testing::Test {
 protected:
  NpyDescriptions() { write_result(file_, to_positions_npy(two_points())); }

  void describe(const std::string& text) { write_result(folder_.path() / "a.npy.json", text); }
  std::string refusal() const {
    return mien::test::refusal_of([&] { read_npy_positions(file_); });
  }

  mien::test::TemporaryFolder folder_;
  std::filesystem::path file_ = folder_.path() / "a.npy";
};

TEST_F(NpyDescriptions, StateNamesRateAndUnit) {
  EXPECT_NE(refusal().find("order of its 2 joints is not known"), std::string::npos) << refusal();
  describe(npy_description(two_points(), "+Z up"));
  const PointRecording read = read_npy_positions(file_);
  EXPECT_EQ(read.points, two_points().points);
  EXPECT_EQ(read.frames_per_second, 50.0);
  EXPECT_EQ(read.unit, "m");
  EXPECT_EQ(read.metres_per_unit, 1.0);
  EXPECT_EQ(read.seen, two_points().seen);
  EXPECT_LT((read.positions[3] - Vec3(0.007, 0.008, 0.009)).norm(), 1e-7);
}

TEST_F(NpyDescriptions, GiveWayToNamesButNotToARate) {
  describe(npy_description(two_points(), "+Z up"));
  ReadOptions how;
  how.frames_per_second = 20.0;
  EXPECT_EQ(read_npy_positions(file_, how).frames_per_second, 50.0);
  EXPECT_EQ(read_npy_positions(file_, how).points, two_points().points);
  how.joints = {"a", "b"};
  EXPECT_EQ(read_npy_positions(file_, how).points, how.joints);
}

TEST_F(NpyDescriptions, OfOtherFilesAreRefused) {
  PointRecording three = two_points();
  three.points.push_back("ankle");
  describe(npy_description(three, "+Z up"));
  EXPECT_NE(refusal().find("a.npy.json: names 3 points, but the array holds 2"), std::string::npos)
      << refusal();
  for (const char* text : {R"({"points": 2})", R"({"points": ["a", 2]})",
                           R"({"points": ["a", "b"], "frames_per_second": "fast"})",
                           R"({"points": ["a", "b"], "frames_per_second": 5, "unit": "ell"})",
                           R"({"points": ["a", "b"], "frames_per_second": 5})", R"({"points")"}) {
    describe(text);
    EXPECT_NE(refusal().find("a.npy.json"), std::string::npos) << text << ": " << refusal();
  }
  describe(R"({"points": ["a", "a"], "frames_per_second": 5, "unit": "m"})");
  EXPECT_NE(refusal(), "");
  describe(R"({"points": ["a", "b"], "frames_per_second": -5, "unit": "m"})");
  EXPECT_NE(refusal(), "");
  describe(R"({"other": "program"})");
  EXPECT_NE(refusal().find("order of its 2 joints is not known"), std::string::npos) << refusal();
}

}  // namespace
}  // namespace mien::motion

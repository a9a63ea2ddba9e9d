#include <algorithm>

#include <gtest/gtest.h>

#include "motion/formats/motion_file.h"
#include "motion/rig/body_mapping.h"

#include "injected_faults.h"
#include "real_data.h"

// What the lint says of motion capture as it is.

namespace mien::motion {
namespace {

using namespace mien::test;
namespace fs = std::filesystem;

class RealLint : public testing::Test {
 protected:
  void SetUp() override {
    const auto folder = real_data();
    if (!folder) GTEST_SKIP() << "no motion capture here: set MIEN_DATA to the folder that has it";
    mocap = *folder / "mocap";
  }

  std::vector<fs::path> files(const std::string& folder, const std::string& part) const {
    std::vector<fs::path> result;
    for (const auto& entry : fs::directory_iterator(mocap / folder)) {
      const std::string name = entry.path().filename().string();
      if (entry.path().extension() == ".bvh" && name.find(part) != std::string::npos) {
        result.push_back(entry.path());
      }
    }
    std::sort(result.begin(), result.end());
    return result;
  }

  fs::path mocap;
};

// In one walk the landing foot leaps sideways (seeded_faults_test.cpp).
TEST_F(RealLint, CapturedWalksHaveNoErrorsButALeapOfALandingFoot) {
  const std::vector<fs::path> walks = files("bandai-namco-1", "_walk_");
  EXPECT_EQ(walks.size(), 30U);
  for (const fs::path& file : walks) {
    if (file.stem() == "dataset-1_walk_active_001") continue;
    const Recording recording = read_motion(file);
    EXPECT_FALSE(has_errors(lint(recording))) << file << "\n" << all_of(lint(recording));
    const Clip clip = to_body(recording);
    EXPECT_FALSE(has_errors(lint(clip))) << file << "\n" << all_of(lint(clip));
    EXPECT_FALSE(has_errors(lint(clip, {}, &clip))) << file << "\n"
                                                    << all_of(lint(clip, {}, &clip));
  }
}

// Captures of this kind begin with the pose in which all angles were zero.
TEST_F(RealLint, ACaptureThatBeginsWithItsRestPoseIsJudgedWithoutIt) {
  const auto findings = lint(to_body(read_motion(mocap / "cmu" / "01_01.bvh")));
  const Finding* found = find(findings, "calibration-pose");
  ASSERT_TRUE(found) << all_of(findings);
  EXPECT_EQ(found->last, 0);
  EXPECT_FALSE(find(findings, "jump", "", 0, 2)) << all_of(findings);
  for (const char* take : {"02_01.amc", "02_02.amc", "02_03.amc"})
    EXPECT_FALSE(find(lint(to_body(read_motion(mocap / "cmu" / take))), "calibration-pose"));
}

// These takes were not cleaned: ankles and heads leap by 25–49° between frames 0.01 s apart in
// which they hardly move before and after, feet or the whole body (and so the hands) stop for
// single frames (seeded_faults_test.cpp), and what counts as the ball of the foot is the end of the
// toes, which dips as the foot rolls off.
TEST_F(RealLint, TwoActorsHaveNoErrorsButTornMarkersAndDippingToes) {
  const std::vector<fs::path> takes = files("aalto-two-actors", "");
  EXPECT_EQ(takes.size(), 24U);
  int clean = 0;
  for (const fs::path& file : takes) {
    const std::vector<Finding> findings = lint(to_body(read_motion(file)));
    if (!has_errors(findings)) ++clean;
    for (const Finding& finding : findings) {
      if (finding.severity != Severity::error) continue;
      const bool is_torn = finding.check == "jump" || finding.check == "joint-speed";
      const bool dips = finding.check == "penetration" && finding.measured < 0.04;
      EXPECT_TRUE(is_torn || dips) << file << " " << finding.sentence;
      const bool is_end = finding.joint.ends_with("Ankle") || finding.joint == "Head" ||
                          finding.joint.ends_with("Wrist");
      EXPECT_TRUE(!is_torn || is_end) << file << " " << finding.sentence;
    }
  }
  EXPECT_GE(clean, 24 - 7 - 3);  // seven leap, in three toes dip
}

// Flights, short plants, and limbs that turn far between two frames; once as captured, once as fast
// as nobody of them ran. In one take a foot stops for two frames as it swings.
TEST_F(RealLint, RunsHaveNoErrorsAtAnyRate) {
  std::vector<fs::path> runs = files("aalto-two-actors", "_run_fast");
  runs.push_back(mocap / "cmu" / "02_03.amc");
  EXPECT_EQ(runs.size(), 5U);
  for (const fs::path& file : runs) {
    for (const double pace : {1.0, 1.3}) {
      Clip clip = to_body(read_motion(file));
      clip.frames_per_second *= pace;
      for (const Clip& run : {clip, resampled(clip, 30.0)}) {
        std::vector<Finding> findings = lint(run);
        std::erase_if(findings, [&](const Finding& finding) {
          return file.stem() == "k_run_fast_k_run_slow_000_100" && finding.check == "jump" &&
                 finding.joint == "RightAnkle";
        });
        EXPECT_FALSE(has_errors(findings)) << file << " at " << run.frames_per_second << "\n"
                                           << all_of(findings);
      }
    }
  }
}

}  // namespace
}  // namespace mien::motion

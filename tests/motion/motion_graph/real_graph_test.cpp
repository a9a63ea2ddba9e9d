#include <algorithm>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "motion/formats/motion_file.h"
#include "motion/gait/contact.h"
#include "motion/gait/foot_lock.h"
#include "motion/lint/lint.h"
#include "motion/modify/foot_repair.h"
#include "motion/motion_graph/graph_walk.h"
#include "motion/rig/body_mapping.h"
#include "motion/rig/retarget.h"

#include "made_motions.h"
#include "random_walk.h"
#include "real_data.h"

// A graph of captured walks: thirty takes of one performer, in fifteen styles.

namespace mien::motion {
namespace {

using test::largest_acceleration;
using test::random_walk;

std::vector<Clip> captured_walks(const std::filesystem::path& folder) {
  std::vector<Clip> clips;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (entry.path().extension() != ".bvh" || name.find("_walk_") == std::string::npos) continue;
    clips.push_back(to_body(read_motion(entry.path())));
    clips.back().name = name;
  }
  std::sort(clips.begin(), clips.end(),
            [](const Clip& a, const Clip& b) { return a.name < b.name; });
  // One performer, but every take was calibrated by itself.
  const Skeleton body = clips.front().body;
  for (Clip& clip : clips) {
    const std::string name = clip.name;
    clip = retarget(clip, body);
    clip = with_still_feet(clip, foot_plants(clip));
    clip.name = name;
  }
  return clips;
}

/// Whether a finding is the leap of a landing foot that one take has itself.
bool is_leap_of_take(const Finding& finding, const std::vector<WalkFrame>& frames,
                     const std::vector<Clip>& takes) {
  const WalkFrame& at = frames[static_cast<size_t>(finding.first)];
  return finding.check == "jump" && finding.joint == "RightAnkle" && at.frame == 121 &&
         takes[static_cast<size_t>(at.clip)].name == "dataset-1_walk_active_001.bvh";
}

TEST(RealGraph, AMinuteAtRandomOverCapturedWalksNeitherSkatesNorPops) {
  const auto data = mien::test::real_data();
  if (!data) GTEST_SKIP() << "no motion capture here: set MIEN_DATA to the folder that has it";
  const std::vector<Clip> clips = captured_walks(*data / "mocap" / "bandai-namco-1");
  ASSERT_EQ(clips.size(), 30U);
  double source = 0.0;
  for (const Clip& clip : clips) source = std::max(source, largest_acceleration(clip));
  const MotionGraph graph = motion_graph(clips);
  EXPECT_GT(graph.transitions.size(), 500U);
  for (const std::uint64_t seed : {1, 2, 3}) {
    const GraphWalk walk = random_walk(graph, 60.0, seed);
    const Clip clip = motion_of(graph, walk);
    const std::vector<WalkFrame> frames = frames_of(graph, walk);
    EXPECT_LT(planted_drift(clip, plants_of(graph, frames)), 0.02);
    EXPECT_LT(largest_acceleration(clip), 1.1 * source);
    for (const Finding& finding : lint(clip)) {
      if (is_leap_of_take(finding, frames, clips)) continue;
      EXPECT_NE(finding.severity, Severity::error) << finding.sentence;
    }
  }
}

}  // namespace
}  // namespace mien::motion

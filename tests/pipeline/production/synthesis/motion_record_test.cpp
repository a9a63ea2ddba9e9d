#include "pipeline/production/synthesis/motion_record.h"

#include <cmath>
#include <functional>
#include <stdexcept>

#include <gtest/gtest.h>

#include "motion/procedural/builtin_sets.h"

namespace mien::pipeline {
namespace {

Synthesis some_synthesis() {
  Synthesis synthesis;
  synthesis.motion = motion::builtin_examples("walks-10").examples[0];
  synthesis.weights = Eigen::Vector2d(0.25, 0.75);
  synthesis.requested = {{"quickness", 0.5}};
  synthesis.reached = {{"quickness", 0.4}};
  synthesis.warnings = {"速さ 0.50 was asked for"};
  return synthesis;
}

std::string digest(const Synthesis& synthesis) {
  return parse_motion_record(motion_record(synthesis, synthesis.motion.clip)).digest;
}

TEST(MotionRecord, ReadsBackWhatItSays) {
  const Synthesis synthesis = some_synthesis();
  const MotionRecord record =
      parse_motion_record(motion_record(synthesis, motion::repeated(synthesis.motion.clip, 2)));
  EXPECT_EQ(record.shown_frames, 2 * synthesis.motion.clip.frame_count());
  EXPECT_EQ(record.warnings, synthesis.warnings);
  EXPECT_THROW(parse_motion_record("{}"), std::runtime_error);
  EXPECT_THROW(parse_motion_record("{\"digest\""), std::runtime_error);
}

TEST(MotionRecord, TheDigestMindsTheLastBitOfEveryNumber) {
  const Synthesis base = some_synthesis();
  const std::vector<std::function<void(Synthesis&)>> changes = {
      [](Synthesis& s) { s.motion.name += "x"; },
      [](Synthesis& s) { s.motion.keytimes[3] = std::nextafter(s.motion.keytimes[3], 9.0); },
      [](Synthesis& s) {
        double& x = s.motion.clip.poses[5].root_position.x();
        x = std::nextafter(x, 9.0);
      },
      [](Synthesis& s) {
        double& w = s.motion.clip.poses[7].rotations[motion::LeftKnee].w();
        w = std::nextafter(w, 9.0);
      },
      [](Synthesis& s) { s.motion.clip.body.joints[motion::Head].offset.y() += 1e-12; },
      [](Synthesis& s) { s.motion.clip.loops = false; },
      [](Synthesis& s) { s.weights[1] = std::nextafter(s.weights[1], 9.0); },
      [](Synthesis& s) { s.reached[0].second += 1e-12; },
      [](Synthesis& s) { s.warnings.clear(); }};
  EXPECT_EQ(digest(base), digest(some_synthesis()));
  for (std::size_t i = 0; i < changes.size(); ++i) {
    Synthesis changed = base;
    changes[i](changed);
    EXPECT_NE(digest(changed), digest(base)) << i;
  }
}

}  // namespace
}  // namespace mien::pipeline

#include "pipeline/production/report/lint_timeline.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace mien::pipeline {
namespace {

using motion::Finding;
using motion::Severity;

Finding finding(const std::string& check, const std::string& joint, int first, int last,
                Severity severity = Severity::error) {
  return {check, joint, first, last, 2.0, 1.0, "m", severity, "It is broken."};
}

/// What the picture says; all of it lies on the page and no word on another.
std::vector<DrawnText> texts_of(const LintedMotion& motion) {
  const Plot plot = lint_timeline(motion);
  const auto canvas = Canvas::pdf(plot.width, plot.height, plot.title);
  plot.draw(*canvas);
  const std::vector<DrawnText>& texts = canvas->texts();
  for (const DrawnText& text : texts) {
    EXPECT_GE(text.box.x, 0.0) << text.text;
    EXPECT_LE(text.box.right(), plot.width) << text.text;
    EXPECT_LE(text.box.bottom(), plot.height) << text.text;
    for (const DrawnText& other : texts) {
      if (&other == &text) continue;
      EXPECT_FALSE(overlap(text.box, other.box)) << text.text << " " << other.text;
    }
  }
  return texts;
}

long count_of(const std::vector<DrawnText>& texts, const std::string& words) {
  return std::count_if(texts.begin(), texts.end(), [&](const DrawnText& text) {
    return text.text.find(words) != std::string::npos;
  });
}

TEST(LintTimeline, NamesEveryRuleOnceAndEveryJoint) {
  LintedMotion motion = {"walk_001", 300, 30.0, true, {}};
  motion.findings = {finding("jump", "LeftKnee", 10, 10),
                     finding("self-intersection", "RightShoulder/LeftShoulder", 3, 200),
                     finding("foot-skate", "LeftAnkle", 0, 20, Severity::warning),
                     finding("foot-skate", "RightAnkle", 15, 40, Severity::warning),
                     finding("foot-skate", "LeftAnkle", 50, 80)};
  const auto texts = texts_of(motion);
  EXPECT_EQ(count_of(texts, "walk_001"), 1);
  EXPECT_EQ(count_of(texts, "3 errors, 2 warnings; 300 frames at 30 per second"), 1);
  EXPECT_EQ(count_of(texts, "foot-skate"), 1);
  EXPECT_EQ(count_of(texts, "LeftAnkle"), 1);
  EXPECT_EQ(count_of(texts, "RightAnkle"), 1);
}

TEST(LintTimeline, OfACleanMotionNamesWhatWasLookedAt) {
  EXPECT_EQ(count_of(texts_of({"walk", 90, 30.0, true, {}}), "limb-phase"), 1);
  EXPECT_EQ(count_of(texts_of({"walk", 90, 30.0, false, {}}), "limb-phase"), 0);
}

TEST(LintTimeline, GrowsWithItsRows) {
  LintedMotion motion = {"walk", 90, 30.0, false, {}};
  for (int i = 0; i < 60; ++i) {
    motion.findings.push_back(finding("joint-limit", "Joint" + std::to_string(i), i, 2 * i));
  }
  EXPECT_EQ(count_of(texts_of(motion), "Joint"), 60);
  EXPECT_GT(lint_timeline(motion).height, 60 * 12.0);
}

TEST(LintTimeline, IsTheSameTwice) {
  LintedMotion motion = {"walk", 90, 30.0, false, {finding("jump", "Head", 80, 95)}};
  EXPECT_EQ(as_svg(lint_timeline(motion)), as_svg(lint_timeline(motion)));
}

}  // namespace
}  // namespace mien::pipeline

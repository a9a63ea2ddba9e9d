#include "motion/lint/fit_residuals.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "motion/fitting/recorded_points.h"
#include "motion/fitting/virtual_points.h"
#include "motion/lint/lint.h"
#include "motion/rig/recording_clip.h"

namespace mien::motion {
namespace {

using namespace mien::motion::test;

/// A fit with one point, of a clip of 100 frames at 50 per second that begins with frame 10 of the
/// recording.
struct OneFit {
  FitQuality fit;
  Clip clip;

  OneFit() {
    fit.frames_per_second = 50.0;
    fit.recorded_frames = 120;
    fit.first_frame = 10;
    fit.points.push_back(
        {.name = "LCAL", .role = "left heel", .use = PointUse::used, .gaps = {}, .first_far = {}});
    clip.frames_per_second = 50.0;
    clip.poses.resize(100);
  }
};

TEST(FitResiduals, AreAFindingFromFortyMillimetresOn) {
  OneFit one;
  for (const double mm : {0.0, 14.1, 39.0, 40.0}) {
    one.fit.residual_mm = mm;
    EXPECT_TRUE(find_fit_residuals(one.fit, one.clip).empty()) << mm;
  }
  one.fit.residual_mm = 41.0;
  const std::vector<Finding> found = find_fit_residuals(one.fit, one.clip);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].check, "fit-residual");
  EXPECT_EQ(found[0].joint, "");
  EXPECT_EQ(found[0].first, 0);
  EXPECT_EQ(found[0].last, 99);
  EXPECT_EQ(found[0].measured, 41.0);
  EXPECT_EQ(found[0].threshold, 40.0);
  EXPECT_EQ(found[0].unit, "mm");
  EXPECT_EQ(found[0].severity, Severity::warning);
  one.fit.residual_mm = 81.0;
  EXPECT_EQ(find_fit_residuals(one.fit, one.clip)[0].severity, Severity::error);
}

TEST(FitResiduals, OfAPointNameItAndItsFrames) {
  OneFit one;
  FittedPoint& point = one.fit.points[0];
  point.residual_mm = 39.0;
  point.first_far = 30;
  point.last_far = 59;
  EXPECT_TRUE(find_fit_residuals(one.fit, one.clip).empty());
  point.residual_mm = 71.0;
  const std::vector<Finding> found = find_fit_residuals(one.fit, one.clip);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].joint, "LCAL");
  EXPECT_EQ(found[0].first, 20);
  EXPECT_EQ(found[0].last, 49);
  EXPECT_EQ(found[0].severity, Severity::warning);
  EXPECT_EQ(found[0].sentence,
            "The point \"LCAL\" is 71 mm (RMS) away from the fitted body: it may be mislabelled or "
            "have moved on the skin.");
}

TEST(FitResiduals, AreInTheFramesOfThePartThatIsShown) {
  OneFit one;
  FittedPoint& point = one.fit.points[0];
  point.residual_mm = 71.0;
  point.first_far = 30;  // 0.4 s after the start of the fitted motion
  point.last_far = 60;   // 1.0 s
  one.clip.frames_per_second = 100.0;
  one.clip.poses.resize(80);
  std::vector<Finding> found = find_fit_residuals(one.fit, one.clip, 0.5);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].first, 0);
  EXPECT_EQ(found[0].last, 50);
  EXPECT_TRUE(find_fit_residuals(one.fit, one.clip, 1.5).empty());
}

/// The walk with its left wrist, in some frames, a distance away in changing directions.
PointRecording with_jitter(double metres, int first, int last) {
  PointRecording points = recorded(truth(), canonical_joints());
  for (int frame = first; frame <= last; ++frame)
    points.positions[points.at(frame, LeftWrist)].x() += frame % 2 == 0 ? metres : -metres;
  return points;
}

TEST(FitResiduals, OfAFittedRecordingAreThoseOfItsWarnings) {
  const auto fit_of = [](double metres) { return fit_body(with_jitter(metres, 20, 60)); };
  const auto findings_of = [](const FittedMotion& fit) {
    return find_fit_residuals(fit, fit.clip);
  };
  const auto warns = [](const FittedMotion& fit) {
    return std::ranges::any_of(fit.warnings, [](const std::string& warning) {
      return warning.find("\"LeftWrist\"") != std::string::npos;
    });
  };
  const FittedMotion good = fit_of(0.005);
  EXPECT_TRUE(findings_of(good).empty());
  EXPECT_FALSE(warns(good));
  const FittedMotion bad = fit_of(0.3);
  const std::vector<Finding> found = findings_of(bad);
  const auto wrist = std::ranges::find(found, "LeftWrist", &Finding::joint);
  ASSERT_NE(wrist, found.end());
  EXPECT_TRUE(warns(bad));
  EXPECT_NEAR(wrist->first, 20, 2);
  EXPECT_NEAR(wrist->last, 60, 2);
  EXPECT_EQ(wrist->measured, bad.points[LeftWrist].residual_mm);
}

TEST(FitResiduals, AreOneOfTheChecks) {
  EXPECT_EQ(std::ranges::count(lint_checks(), "fit-residual", &LintCheck::id), 1);
}

}  // namespace
}  // namespace mien::motion

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "motion/fitting/fit.h"
#include "motion/fitting/trc_points.h"
#include "motion/skeleton/sole.h"

#include "real_data.h"

namespace mien::motion {
namespace {

struct RealWalk {
  const char* file;
  const char* set;
  const char* up;
};

/// Walks from OpenSim's tests and examples: two with only clusters on thighs and shanks, one with
/// joint centres and 45 % of its values missing.
TEST(RealPoints, OfWalkersGiveAPlausibleBody) {
  const auto data = mien::test::real_data();
  if (!data) GTEST_SKIP() << "no real data";
  for (const RealWalk& walk : {RealWalk{"walking5_markers", "Plug-in Gait", "+Z"},
                               RealWalk{"subject01_walk1", "OpenSim gait", "+Y"},
                               RealWalk{"walk_free_01", "OpenSim gait", "+Y"},
                               RealWalk{"markers_walk", "OpenSim gait", "+Y"}}) {
    SCOPED_TRACE(walk.file);
    const auto file = *data / "recordings" / "opensim" / (std::string(walk.file) + ".trc");
    if (!std::filesystem::exists(file)) GTEST_SKIP() << file;
    const FittedMotion fitted = fit_body(test::trc_points(file));
    const Skeleton& body = fitted.clip.body;
    EXPECT_EQ(fitted.marker_set, walk.set);
    EXPECT_EQ(fitted.axes.up, walk.up);
    EXPECT_LT(fitted.residual_mm, 12.0);
    EXPECT_LT(std::abs(fitted.raised), 0.03);
    const double stature = standing_height(body) + sole_depth(body);
    EXPECT_GT(stature, 1.5);
    EXPECT_LT(stature, 1.9);
    for (const BodyJoint joint : {LeftHip, LeftKnee, LeftAnkle, LeftToe}) {
      const double left = body.joints[joint].offset.norm();
      EXPECT_NEAR(left, body.joints[mirrored(joint)].offset.norm(), 0.1 * left) << name_of(joint);
    }
    double lowest = 1.0;
    for (const bool left : {true, false}) {
      for (const SolePoints& sole : sole_paths(fitted.clip, left)) {
        lowest = std::min({lowest, sole.heel.y(), sole.ball.y(), sole.tip.y()});
      }
    }
    EXPECT_NEAR(lowest, 0.0, 0.03);
    for (const FittedPoint& point : fitted.points) EXPECT_LT(point.residual_mm, 30.0) << point.name;
  }
}

}  // namespace
}  // namespace mien::motion

#include "motion/gait/foot_slide.h"

#include <gtest/gtest.h>

#include "motion/gait/foot_lock.h"
#include "motion/skeleton/body.h"
#include "motion/skeleton/sole.h"

namespace mien::motion {
namespace {

/// A left foot under a leg that hangs straight down, its sole on the floor, over ten frames.
class OneFoot : public testing::Test {
 protected:
  OneFoot() {
    clip_.body = standard_body();
    clip_.frames_per_second = 30.0;
    Pose pose;
    pose.rotations.assign(body_joint_count, Quat::Identity());
    clip_.poses.assign(10, pose);
    const double ball = soles().front().ball.y();
    for (Pose& each : clip_.poses) each.root_position.y() -= ball;
  }

  std::vector<SolePoints> soles() const { return sole_paths(clip_, true); }

  /// Turns the foot about a point of the floor, a little more each frame.
  void roll(const Vec3& axis, const Vec3& about, double radians) {
    for (std::size_t f = 0; f < clip_.poses.size(); ++f) {
      const Quat turn(Eigen::AngleAxisd(radians * static_cast<double>(f) / 9.0, axis));
      Pose& pose = clip_.poses[f];
      pose.rotations.front() = turn * pose.rotations.front();
      pose.root_position = about + turn * (pose.root_position - about);
    }
  }

  double slide() const { return planted_slide(clip_, {{true, 0, 9}}); }

  Clip clip_;
};

TEST_F(OneFoot, ThatStandsDoesNotSlide) { EXPECT_LT(slide(), 1e-12); }

TEST_F(OneFoot, ThatPivotsOnItsBallDoesNotSlide) {
  const Vec3 ball = soles().front().ball;
  roll(Vec3::UnitY(), ball, 0.6);
  EXPECT_GT((soles().back().heel - soles().front().heel).norm(), 0.05);
  EXPECT_LT(slide(), 1e-9);
}

/// The point that `planted_drift` follows lies above the heel's edge.
TEST_F(OneFoot, ThatRollsOnItsHeelsEdgeDoesNotSlide) {
  roll(Vec3::UnitX(), soles().front().heel, -0.35);
  EXPECT_LT(slide(), 1e-9);
  FootLockOptions whole;
  whole.lifted_metres = 1.0;
  EXPECT_GT(planted_drift(clip_, {{true, 0, 9}}, whole), 0.004);
}

/// Ten frames of 1 cm each; the plant begins in one cycle and ends in the next.
TEST_F(OneFoot, ThatIsPushedInALoopSlidesOnInTheNextCycle) {
  for (std::size_t f = 0; f < clip_.poses.size(); ++f)
    clip_.poses[f].root_position.x() += 0.01 * static_cast<double>(f);
  clip_.loops = true;
  clip_.cycle_displacement = Vec3(0.1, 0.0, 0.0);
  EXPECT_NEAR(planted_slide(clip_, {{true, 5, 14}}), 0.09, 1e-9);
}

TEST_F(OneFoot, ThatIsPushedSlidesByAsMuch) {
  for (std::size_t f = 0; f < clip_.poses.size(); ++f)
    clip_.poses[f].root_position.x() += 0.001 * static_cast<double>(f);
  EXPECT_NEAR(slide(), 0.009, 1e-9);
}

TEST_F(OneFoot, InTheAirTouchesNothing) {
  for (std::size_t f = 5; f < clip_.poses.size(); ++f) {
    clip_.poses[f].root_position.y() += 0.008;
    clip_.poses[f].root_position.z() += 0.02 * static_cast<double>(f);
  }
  EXPECT_LT(slide(), 1e-9);
}

}  // namespace
}  // namespace mien::motion

#include "motion/measures/differences/contact_difference.h"

#include <gtest/gtest.h>

#include "motion/changed_motion.h"
#include "motion/gait/contact.h"

namespace mien::motion {
namespace {

using namespace mien::test;

/// A stand of the left foot that begins and ends within the clip.
FootPlant left_stand(const Clip& clip) {
  for (const FootPlant& plant : foot_plants(clip)) {
    if (plant.left && plant.first > 5 && plant.last < clip.frame_count() - 5) return plant;
  }
  return {};
}

TEST(ContactDifference, OfAMotionToItselfIsNone) {
  const Clip walk = changeable_walk();
  for (const FootDifference& foot : contact_differences(walk, walk)) {
    EXPECT_EQ(foot.frames, 0);
    EXPECT_TRUE(foot.changes.empty());
    EXPECT_EQ(foot.slide_m, 0.0);
  }
}

TEST(ContactDifference, TellsAFootThatSlidesHalfACentimetre) {
  const Clip walk = changeable_walk();
  const FootPlant stand = left_stand(walk);
  ASSERT_GT(stand.last, stand.first);
  const auto feet = contact_differences(walk, with_sliding_foot(walk, stand, Vec3(0.005, 0, 0)));
  EXPECT_NEAR(feet[0].slide_m, 0.005, 1e-4);
  EXPECT_NEAR(feet[0].slide_seconds, stand.last / walk.frames_per_second, 1e-9);
  EXPECT_EQ(feet[1].slide_m, 0.0);
  EXPECT_EQ(feet[1].frames, 0);
}

TEST(ContactDifference, OfAFigureThatStandsElsewhereHasNoSlide) {
  const Clip walk = changeable_walk();
  for (const auto& foot : contact_differences(walk, set_elsewhere(walk, Vec3(0.3, 0, 0.1), 0.0))) {
    EXPECT_LT(foot.slide_m, 1e-12);
    EXPECT_EQ(foot.frames, 0);
  }
}

TEST(ContactDifference, TellsAStandThatIsGoneAndNoOther) {
  const Clip walk = changeable_walk();
  const FootPlant stand = left_stand(walk);
  Clip now = walk;
  for (int t = stand.first - 2; t <= stand.last + 2; ++t) {
    now.poses[t].rotations[LeftHip] =
        now.poses[t].rotations[LeftHip] * Quat(Eigen::AngleAxisd(-0.6, Vec3::UnitX()));
    now.poses[t].rotations[LeftKnee] =
        now.poses[t].rotations[LeftKnee] * Quat(Eigen::AngleAxisd(0.9, Vec3::UnitX()));
  }
  const auto feet = contact_differences(walk, now);
  const auto& changes = feet[0].changes;
  const auto gone = std::ranges::find(changes, ContactChange::Kind::gone, &ContactChange::kind);
  ASSERT_NE(gone, changes.end());
  EXPECT_NEAR(gone->begin_seconds, stand.first / walk.frames_per_second, 1e-9);
  EXPECT_NEAR(gone->end_seconds, (stand.last + 1) / walk.frames_per_second, 1e-9);
  EXPECT_GE(feet[0].frames, stand.last - stand.first);
  EXPECT_EQ(feet[1].frames, 0);
}

TEST(ContactDifference, TellsByHowMuchStandsComeLater) {
  const Clip walk = changeable_walk();
  const auto feet = contact_differences(without_first(walk, 2), walk);
  const double later = 2.0 / walk.frames_per_second;
  int shifted = 0;
  for (const FootDifference& foot : feet) {
    for (const ContactChange& change : foot.changes) {
      if (change.begin_seconds < 0.2 || change.end_seconds > walk.duration_seconds() - 0.3)
        continue;
      EXPECT_EQ(change.kind, ContactChange::Kind::shifted);
      EXPECT_NEAR(change.begin_shift, later, 0.51 / walk.frames_per_second);
      EXPECT_NEAR(change.end_shift, later, 0.51 / walk.frames_per_second);
      ++shifted;
    }
  }
  EXPECT_GE(shifted, 3);
}

TEST(ContactDifference, OfMotionsTooShortForContactsIsNone) {
  const Clip frame = without_last(changeable_walk(), changeable_walk().frame_count() - 1);
  for (const FootDifference& foot : contact_differences(frame, frame)) EXPECT_EQ(foot.frames, 0);
}

}  // namespace
}  // namespace mien::motion

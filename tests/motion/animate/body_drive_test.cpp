#include "motion/animate/body_drive.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "motion/procedural/walker.h"
#include "motion/skeleton/mirror.h"

namespace mien::motion {
namespace {

Clip walk_cycle() { return walk({}, 60.0, standard_body()).clip; }

double mean_of(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value / static_cast<double>(values.size());
  return sum;
}

double range_of(const std::vector<double>& values) {
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  return *most - *least;
}

const FoundDrive* found(const std::vector<FoundDrive>& drives, LimbMovement limb) {
  const auto at = std::find_if(drives.begin(), drives.end(),
                               [&](const FoundDrive& one) { return one.limb == limb; });
  return at == drives.end() ? nullptr : &*at;
}

TEST(BodyDrive, OfWalkingHandsAreTheOppositeLegs) {
  const std::vector<FoundDrive> drives = drives_of(walk_cycle());
  for (const auto& [limb, foot] :
       {std::pair(LimbMovement::left_hand_forward, BodyMovement::right_foot_forward),
        std::pair(LimbMovement::right_hand_forward, BodyMovement::left_foot_forward)}) {
    const FoundDrive* drive = found(drives, limb);
    ASSERT_NE(drive, nullptr);
    // With the leg of the other side, or against that of its own, which does the same.
    const bool is_opposite = drive->body == foot ? drive->correlation > 0 : drive->correlation < 0;
    EXPECT_TRUE(is_opposite || drive->body == BodyMovement::spine_turn);
    EXPECT_GT(std::abs(drive->correlation), 0.8);
  }
  EXPECT_TRUE(std::is_sorted(drives.begin(), drives.end(), [](const auto& a, const auto& b) {
    return std::abs(a.correlation) > std::abs(b.correlation);
  }));
}

/// The oracle: the regression by another formula, from differences of all pairs.
TEST(BodyDrive, IsTheRegressionOfLeastSquares) {
  const Clip clip = walk_cycle();
  for (const FoundDrive& drive : drives_of(clip)) {
    const std::vector<double> x = movement_of(clip, drive.body), y = movement_of(clip, drive.limb);
    double xx = 0.0, xy = 0.0, yy = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        xx += (x[i] - x[j]) * (x[i] - x[j]);
        xy += (x[i] - x[j]) * (y[i] - y[j]);
        yy += (y[i] - y[j]) * (y[i] - y[j]);
      }
    }
    EXPECT_NEAR(drive.slope, xy / xx, 1e-9);
    EXPECT_NEAR(drive.correlation, xy / std::sqrt(xx * yy), 1e-9);
    EXPECT_NEAR(drive.limb_range, range_of(y), 1e-12);
  }
}

TEST(BodyDrive, EditsScaleWhatFollowsTheBody) {
  // With bent arms, which reach everywhere.
  const Clip clip = with_drives(
      walk_cycle(), {{LimbMovement::left_hand_height, BodyMovement::pelvis_height, 1.0, 0.08}});
  const LimbMovement limb = LimbMovement::left_hand_forward;
  const BodyMovement body = BodyMovement::right_foot_forward;
  const std::vector<double> x = movement_of(clip, body), before = movement_of(clip, limb);
  const double slope = [&] {
    double xx = 0.0, xy = 0.0;
    const double mean_x = mean_of(x), mean_y = mean_of(before);
    for (std::size_t i = 0; i < x.size(); ++i) {
      xx += (x[i] - mean_x) * (x[i] - mean_x);
      xy += (x[i] - mean_x) * (before[i] - mean_y);
    }
    return xy / xx;
  }();
  const Clip made = with_drives(clip, {{limb, body, 0.4, 0.03}});
  const std::vector<double> after = movement_of(made, limb);
  for (std::size_t f = 0; f < x.size(); ++f)
    EXPECT_NEAR(after[f] - before[f], -0.6 * slope * (x[f] - mean_of(x)) + 0.03, 1e-6);
  EXPECT_LT(range_of(after), 0.7 * range_of(before));
  // The rest stays.
  EXPECT_EQ(movement_of(made, LimbMovement::right_hand_forward),
            movement_of(clip, LimbMovement::right_hand_forward));
  EXPECT_EQ(movement_of(made, body), x);
  EXPECT_TRUE(made.loops);
}

TEST(BodyDrive, WithoutAnEditChangesNothing) {
  const Clip clip = walk_cycle();
  const Clip made =
      with_drives(clip, {{LimbMovement::left_hand_side, BodyMovement::pelvis_side, 1.0, 0.0}});
  for (std::size_t f = 0; f < clip.poses.size(); ++f) {
    for (std::size_t j = 0; j < clip.poses[f].rotations.size(); ++j)
      EXPECT_EQ(made.poses[f].rotations[j].coeffs(), clip.poses[f].rotations[j].coeffs());
  }
}

TEST(BodyDrive, IsMirroredWithTheMotion) {
  const Clip clip = walk_cycle();
  const Clip other = mirrored(clip);
  for (const auto& [left, right] :
       {std::pair(LimbMovement::left_hand_forward, LimbMovement::right_hand_forward),
        std::pair(LimbMovement::left_hand_side, LimbMovement::right_hand_side),
        std::pair(LimbMovement::left_hand_height, LimbMovement::right_hand_height)}) {
    const auto a = movement_of(clip, left), b = movement_of(other, right);
    for (std::size_t f = 0; f < a.size(); ++f) EXPECT_NEAR(a[f], b[f], 1e-9);
  }
  for (const auto& [movement, sign] :
       {std::pair(BodyMovement::pelvis_side, -1.0), std::pair(BodyMovement::spine_lateral, -1.0),
        std::pair(BodyMovement::spine_turn, -1.0), std::pair(BodyMovement::spine_flexion, 1.0)}) {
    const auto a = movement_of(clip, movement), b = movement_of(other, movement);
    for (std::size_t f = 0; f < a.size(); ++f) EXPECT_NEAR(a[f], sign * b[f], 1e-9);
  }
}

}  // namespace
}  // namespace mien::motion

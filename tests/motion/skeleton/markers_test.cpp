#include "motion/skeleton/markers.h"

#include <gtest/gtest.h>

namespace mien::motion {
namespace {

using Indices = std::vector<int>;

TEST(Markers, HaveTheirOppositeByTheSideInTheirName) {
  EXPECT_EQ(opposite_points({"LASI", "RASI", "C7"}), (Indices{1, 0, 2}));
  EXPECT_EQ(opposite_points({"L.Heel", "R.Heel", "L_IAS", "R_IAS"}), (Indices{1, 0, 3, 2}));
  EXPECT_EQ(opposite_points({"knee_l", "knee_r"}), (Indices{1, 0}));
  EXPECT_EQ(opposite_points({"RightWrist", "LeftWrist"}), (Indices{1, 0}));
}

TEST(Markers, WithoutAnOppositeAreTheirOwn) {
  EXPECT_EQ(opposite_points({"LOFF", "CLAV", "STRN"}), (Indices{0, 1, 2}));
  EXPECT_EQ(opposite_points({}), Indices{});
  // "LR" is the opposite of "RR" and of "LL" by its two ends: it cannot be exchanged with both.
  const Indices odd = opposite_points({"LL", "LR", "RR", "RL"});
  for (std::size_t p = 0; p < odd.size(); ++p) {
    EXPECT_EQ(odd[static_cast<std::size_t>(odd[p])], static_cast<int>(p));
  }
}

TEST(Markers, ExchangeSidesWithWhatIsKnownOfThem) {
  Markers markers;
  markers.points = {"L", "R"};
  markers.positions = {Vec3(1, 0, 0), Vec3::Zero(), Vec3(2, 0, 0), Vec3(3, 0, 0)};
  markers.seen = {true, false, true, false};
  markers.filled = {false, false, false, true};
  const Markers exchanged = with_sides_exchanged(markers);
  EXPECT_EQ(exchanged.points, markers.points);
  EXPECT_EQ(exchanged.seen, (std::vector<bool>{false, true, false, true}));
  EXPECT_EQ(exchanged.filled, (std::vector<bool>{false, false, true, false}));
  EXPECT_EQ(exchanged.positions[2], Vec3(3, 0, 0));
  EXPECT_EQ(exchanged.positions[3], Vec3(2, 0, 0));
}

TEST(Bridged, PathsAreStraightBetweenKnownPositionsAndStayAtTheEnds) {
  const std::vector<Vec3> path = {Vec3(9, 9, 9), Vec3(1, 0, 0), Vec3(9, 9, 9), Vec3(9, 9, 9),
                                  Vec3(4, 3, 0), Vec3(5, 0, 0), Vec3(9, 9, 9)};
  const std::vector<Vec3> whole = bridged(path, {false, true, false, false, true, true, false});
  const std::vector<Vec3> expected = {Vec3(1, 0, 0), Vec3(1, 0, 0), Vec3(2, 1, 0), Vec3(3, 2, 0),
                                      Vec3(4, 3, 0), Vec3(5, 0, 0), Vec3(5, 0, 0)};
  for (std::size_t f = 0; f < path.size(); ++f) {
    EXPECT_LT((whole[f] - expected[f]).norm(), 1e-12) << f;
  }
  EXPECT_EQ(bridged(path, std::vector<bool>(7, true)), path);
}

}  // namespace
}  // namespace mien::motion

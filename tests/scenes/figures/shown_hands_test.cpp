#include "scenes/figures/shown_hands.h"

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "motion/error.h"
#include "motion/refusal.h"
#include "motion/skeleton/recorded_hands.h"
#include "scenes/bent_fingers.h"
#include "scenes/figures/stick_figure.h"
#include "scenes/stage/shot.h"
#include "scenes/walking_clip.h"

namespace mien::scenes {
namespace {

using motion::Finger;
using motion::Vec3;

motion::Clip walk() { return test::walking_clip(5, Vec3::UnitZ(), 0.04); }

motion::Clip gesture() {
  motion::Clip clip = walk();
  for (std::size_t f = 0; f < clip.poses.size(); ++f)
    clip.poses[f].fingers = mien::test::random_fingers(static_cast<std::uint32_t>(f));
  return clip;
}

Look look_of(const Figure& figure, Hands hands) {
  Look look;
  look.set.lights = {KeyLight{}};
  look.figure = figure;
  look.hands = hands;
  look.detail = MeshDetail::draft;
  return look;
}

/// Positions and sizes of all solids that show the body, as one list.
std::vector<float> shape_of(const Shot& shot, int frame) {
  const render::Scene scene = scene_at(shot, frame);
  std::vector<float> shape;
  const auto add = [&](const render::Vec3& v) { shape.insert(shape.end(), v.begin(), v.end()); };
  for (const render::Sphere& sphere : scene.solids.spheres) add(sphere.centre);
  for (const render::RoundCone& cone : scene.solids.round_cones) {
    add(cone.start);
    add(cone.end);
    shape.push_back(cone.start_radius);
  }
  for (const render::Mesh& mesh : scene.solids.meshes)
    for (const render::Vec3& position : mesh.positions) add(position);
  return shape;
}

TEST(ShownHands, AreThoseOfTheMotionUnlessTheyAreHidden) {
  const motion::Clip clip = gesture();
  for (const Hands hands : {Hands::automatic, Hands::drawn}) {
    const motion::Clip shown = with_shown_hands(clip, hands);
    EXPECT_TRUE(motion::has_fingers(shown));
    EXPECT_FALSE(gets_relaxed_hands(clip, hands));
    for (std::size_t f = 0; f < clip.poses.size(); ++f)
      for (std::size_t j = 0; j < clip.poses[f].fingers.size(); ++j)
        EXPECT_TRUE(shown.poses[f].fingers[j].isApprox(clip.poses[f].fingers[j]));
  }
  EXPECT_FALSE(motion::has_fingers(with_shown_hands(clip, Hands::hidden)));
}

TEST(ShownHands, AreRelaxedOnRequestOnly) {
  EXPECT_FALSE(motion::has_fingers(with_shown_hands(walk(), Hands::automatic)));
  EXPECT_FALSE(motion::has_fingers(with_shown_hands(walk(), Hands::hidden)));
  const motion::Clip drawn = with_shown_hands(walk(), Hands::drawn);
  EXPECT_TRUE(gets_relaxed_hands(walk(), Hands::drawn));
  for (const motion::Pose& pose : drawn.poses)
    EXPECT_EQ(pose.fingers.size(), static_cast<std::size_t>(motion::finger_joint_count));
  motion::Clip lamp;
  lamp.body.joints = {{.name = "base"}, {.name = "shade", .parent = 0, .offset = Vec3(0, 1, 0)}};
  lamp.poses.resize(2);
  EXPECT_FALSE(motion::has_fingers(with_shown_hands(lamp, Hands::drawn)));
}

TEST(ShownHands, ThatAreHiddenLeaveTheFigureOfAMotionWithoutFingers) {
  for (const Figure& figure : {Figure(StickOptions{}), Figure(MannequinOptions{})}) {
    const Shot plain = stage(walk(), look_of(figure, Hands::automatic));
    EXPECT_EQ(shape_of(stage(gesture(), look_of(figure, Hands::hidden)), 3), shape_of(plain, 3));
    EXPECT_NE(shape_of(stage(gesture(), look_of(figure, Hands::automatic)), 3), shape_of(plain, 3));
    EXPECT_NE(shape_of(stage(walk(), look_of(figure, Hands::drawn)), 3), shape_of(plain, 3));
  }
}

TEST(ShownHands, ThatNobodyMadeAreStated) {
  const auto warnings = [](const motion::Clip& clip, const Figure& figure, Hands hands) {
    return stage(clip, look_of(figure, hands)).actors.front().warnings.size();
  };
  EXPECT_EQ(warnings(walk(), StickOptions{}, Hands::drawn), 1u);
  EXPECT_EQ(warnings(walk(), StickOptions{}, Hands::automatic), 0u);
  EXPECT_EQ(warnings(gesture(), StickOptions{}, Hands::drawn), 0u);
  PointLightOptions dots;
  EXPECT_EQ(warnings(walk(), dots, Hands::drawn), 0u);
  dots.joint_set = "hands";
  EXPECT_EQ(warnings(walk(), dots, Hands::drawn), 1u);
}

TEST(ShownHands, AreToldOfEachOfSeveralPeople) {
  const std::vector<Performance> pair = {{.name = "Ann", .clip = walk()},
                                         {.name = "Bo", .clip = gesture()}};
  const Shot shot = stage(pair, look_of(StickOptions{}, Hands::drawn));
  ASSERT_EQ(shot.actors[0].warnings.size(), 1u);
  EXPECT_EQ(shot.actors[0].warnings.front(),
            "\"Ann\": The motion has no fingers; relaxed hands are drawn.");
  EXPECT_TRUE(shot.actors[1].warnings.empty());
}

TEST(ShownHands, NameTheOptionForFingertipsWithoutFingers) {
  PointLightOptions dots;
  dots.joint_set = "hands";
  EXPECT_EQ(mien::test::refusal_of([&] { stage(walk(), look_of(dots, Hands::automatic)); }),
            "the motion has no fingers for the fingertips of joints: hands; add hands: drawn to "
            "the look (--hands drawn) for relaxed hands, or use joints: standard");
  dots = {.joint_set = "", .joints = {"Head", "LeftThumbTip"}};
  EXPECT_EQ(mien::test::refusal_of([&] { stage(walk(), look_of(dots, Hands::automatic)); }),
            "the motion has no fingers for a dot on \"LeftThumbTip\"; add hands: drawn to the look "
            "(--hands drawn) for relaxed hands, or omit the fingers from joints");
}

TEST(AStickFigure, HasFingersThatEndAtTheirTips) {
  const motion::Skeleton body = motion::standard_body(1.6);
  motion::Pose pose = gesture().poses[2];
  const motion::Skeleton handed = motion::with_fingers(body);
  const motion::JointTransforms world =
      motion::world_transforms(handed, motion::with_fingers(pose));
  render::Scene scene;
  add_stick_figure(scene, body, pose, colours_of(Role::neutral), 1.6);
  for (int joint = 0; joint < motion::finger_joint_count; ++joint) {
    if (motion::segment_of(joint) != 2) continue;
    const auto j = static_cast<std::size_t>(motion::body_joint_count + joint);
    const Vec3 tip = world.positions[j] + world.rotations[j] * *handed.joints[j].tip;
    double nearest = 1.0;
    for (const render::RoundCone& cone : scene.solids.round_cones) {
      const double from_end = (cone.end.cast<double>() - tip).norm();
      nearest = std::min(nearest, std::abs(from_end - static_cast<double>(cone.end_radius)));
      if (from_end > 0.02) continue;
      const std::string part = scene.parts[static_cast<std::size_t>(cone.part)].name;
      EXPECT_EQ(part, motion::is_left_finger(joint) ? "LeftWrist" : "RightWrist");
    }
    EXPECT_LT(nearest, 1e-6) << motion::finger_joint_name(joint);
  }
}

TEST(AStickFigure, HasTheOldHandOnlyWithoutFingers) {
  const motion::Skeleton body = motion::standard_body();
  motion::Pose pose = walk().poses.front();
  const auto hand_tips = [&] {
    const motion::JointTransforms world = motion::world_transforms(body, pose);
    render::Scene scene;
    add_stick_figure(scene, body, pose, colours_of(Role::neutral), 1.75);
    const Vec3 tip = world.positions[motion::LeftWrist] +
                     world.rotations[motion::LeftWrist] * *body.joints[motion::LeftWrist].tip;
    return std::ranges::count_if(scene.solids.round_cones, [&](const render::RoundCone& cone) {
      return (cone.end.cast<double>() - tip).norm() < 1e-6;
    });
  };
  EXPECT_EQ(hand_tips(), 1);
  pose.fingers = motion::relaxed_fingers();
  EXPECT_EQ(hand_tips(), 0);
}

TEST(FingerDots, AreWhereTheFingersAre) {
  const motion::Clip clip = gesture();
  PointLightOptions options;
  options.joint_set = "hands";
  const std::vector<Dot> dots = point_light(clip, options, {});
  ASSERT_EQ(dots.size(), 23u);
  const motion::Skeleton handed = motion::with_fingers(clip.body);
  int compared = 0;
  for (int joint = 0; joint < motion::finger_joint_count; ++joint) {
    if (motion::segment_of(joint) != 2) continue;
    std::string name = motion::finger_joint_name(joint);
    name.replace(name.size() - 1, 1, "Tip");
    const auto dot = std::ranges::find(dots, name, &Dot::kind);
    ASSERT_NE(dot, dots.end()) << name;
    for (std::size_t f = 0; f < clip.poses.size(); ++f) {
      const motion::JointTransforms world =
          motion::world_transforms(handed, motion::with_fingers(clip.poses[f]));
      const auto j = static_cast<std::size_t>(motion::body_joint_count + joint);
      const Vec3 tip = world.positions[j] + world.rotations[j] * *handed.joints[j].tip;
      EXPECT_LT((dot->path[f] - tip).norm(), 1e-12);
      ++compared;
    }
  }
  EXPECT_EQ(compared, 50);
  options.joint_set.clear();
  options.joints = {"RightThumb2"};
  const motion::JointTransforms world =
      motion::world_transforms(handed, motion::with_fingers(clip.poses[1]));
  const auto thumb = static_cast<std::size_t>(motion::body_joint_count +
                                              motion::finger_joint(false, Finger::thumb, 1));
  EXPECT_LT((point_light(clip, options, {})[0].path[1] - world.positions[thumb]).norm(), 1e-12);
}

TEST(FingerDots, LeaveTheOthersWhereTheyAre) {
  PointLightOptions all;
  all.joint_set = "all";
  for (const PointLightOptions& options : {PointLightOptions{}, all}) {
    const std::vector<Dot> plain = point_light(walk(), options, {});
    const std::vector<Dot> handed = point_light(gesture(), options, {});
    ASSERT_EQ(handed.size(), plain.size());
    for (std::size_t d = 0; d < plain.size(); ++d) {
      EXPECT_EQ(handed[d].kind, plain[d].kind);
      EXPECT_EQ(handed[d].path, plain[d].path);
    }
  }
}

TEST(FingerDots, OfAMotionWithoutFingersAreRefused) {
  PointLightOptions options;
  options.joint_set.clear();
  options.joints = {"Head", "LeftIndexTip"};
  try {
    point_light(walk(), options, {});
    FAIL() << "drew a finger that is not there";
  } catch (const Error& wrong) {
    EXPECT_NE(std::string(wrong.what()).find("LeftIndexTip"), std::string::npos) << wrong.what();
    EXPECT_NE(std::string(wrong.what()).find("hands: drawn"), std::string::npos) << wrong.what();
  }
  EXPECT_EQ(point_light(with_shown_hands(walk(), Hands::drawn), options, {}).size(), 2u);
}

TEST(FingerDots, WithLimitedLifetimesAreOnTheirFinger) {
  PointLightOptions options;
  options.joint_set.clear();
  options.joints = {"LeftIndex1", "LeftIndexTip"};
  options.lifetime = 2;
  const motion::Clip clip = gesture();
  const motion::Skeleton handed = motion::with_fingers(clip.body);
  for (const Dot& dot : point_light(clip, options, {})) {
    for (std::size_t f = 0; f < clip.poses.size(); ++f) {
      const auto world = motion::world_positions(handed, motion::with_fingers(clip.poses[f]));
      const auto knuckle = static_cast<std::size_t>(motion::body_joint_count +
                                                    motion::finger_joint(true, Finger::index, 0));
      EXPECT_LT((dot.path[f] - world[knuckle]).norm(), 0.1);
    }
  }
}

}  // namespace
}  // namespace mien::scenes

#include "scenes/sets/set_plan.h"

#include <cmath>

#include <gtest/gtest.h>

#include "motion/error.h"
#include "motion/math/rotation.h"
#include "render/geometry/shapes.h"
#include "render/light/unshadowed_background.h"
#include "render/scene/camera.h"
#include "scenes/stage/shot.h"
#include "scenes/walking_clip.h"

namespace mien::scenes {
namespace {

using motion::Vec3;

TEST(SetPlan, AWhiteFloorUnderTheKeyLightGivesBackItsStrength) {
  SetPlan plan;
  plan.ground = render::Ground{.albedo = render::Color::Ones(), .line_spacing = 0.0f};
  plan.sky.zenith = plan.sky.horizon = plan.sky.below = render::Color::Zero();
  plan.lights.push_back({.azimuth_degrees = 50.0, .elevation_degrees = 40.0, .strength = 0.7});
  const Place place{Vec3(3.0, 0.0, -2.0), Vec3(0.6, 0.0, 0.8)};
  const render::Scene scene = static_scene(plan, place);
  // Seen straight from above.
  render::LaneRays down;
  for (int i = 0; i < 8; ++i) {
    down.origin.set(i, place.centre.cast<float>() + render::Vec3::UnitY());
    down.direction.set(i, -render::Vec3::UnitY());
  }
  const render::UnshadowedBackground background(scene, render::frame_of({}));
  EXPECT_NEAR(background.along(down).radiance.green[0], 0.7f, 0.02f);
}

TEST(SetPlan, BoxesStandInTheFiguresAxes) {
  const Place place{Vec3(1.0, 0.0, 2.0), Vec3::UnitX()};
  // The figure faces +X: its left is −Z.
  EXPECT_LT((place.at({1.0, 0.5, 3.0}) - Vec3(4.0, 0.5, 1.0)).norm(), 1e-12);
  const render::Mesh box = box_mesh({.centre = {0, 1, 0}, .size = {0.2, 2.0, 0.6}}, place, 0);
  ASSERT_EQ(box.triangles.size(), 12u);
  for (const auto& triangle : box.triangles) {
    const auto corner = [&](int i) { return box.positions[static_cast<size_t>(triangle[i])]; };
    const render::Vec3 normal = (corner(1) - corner(0)).cross(corner(2) - corner(0)).normalized();
    EXPECT_LT((normal - box.normals[static_cast<size_t>(triangle[0])]).norm(), 1e-5f);
    const render::Vec3 out = corner(0) - render::Vec3(1.0f, 1.0f, 2.0f);
    EXPECT_GT(out.dot(normal), 0.0f);
  }
}

/// Sits with level thighs, a little lower at first, its hips moving to the sides.
motion::Clip sitting_clip() {
  motion::Clip clip;
  clip.body = motion::standard_body();
  for (int f = 0; f < 5; ++f) {
    motion::Pose pose;
    pose.rotations.assign(motion::body_joint_count, motion::Quat::Identity());
    for (const int hip : {motion::LeftHip, motion::RightHip})
      pose.rotations[static_cast<size_t>(hip)] =
          motion::Quat(Eigen::AngleAxisd(-0.5 * motion::pi, Vec3::UnitX()));
    pose.root_position = Vec3(1.0 + 0.02 * (f - 2), 0.55 + 0.01 * f, 3.0);
    clip.poses.push_back(pose);
  }
  return clip;
}

TEST(Stools, AreUnderTheHipsOfWhoSits) {
  const motion::Clip clip = sitting_clip();
  const std::vector<Vec3> at = motion::world_positions(clip.body, clip.poses[0]);
  const double hips = 0.5 * (at[motion::LeftHip] + at[motion::RightHip]).y();
  const Place place{Vec3(0.5, 0.0, 1.0), Vec3::UnitX()};
  const Box box = stool_under({.width_m = 0.5, .depth_m = 0.3}, clip, place);
  EXPECT_NEAR(box.size.y(), hips - 0.085, 1e-9);
  EXPECT_NEAR(box.centre.y(), 0.5 * box.size.y(), 1e-12);
  EXPECT_EQ(box.size.x(), 0.5);
  EXPECT_EQ(box.size.z(), 0.3);
  // The place faces +X, with −Z on its left.
  const Vec3 world = place.at(box.centre);
  EXPECT_NEAR(world.x(), 1.0, 1e-9);
  EXPECT_NEAR(world.z(), 0.5 * (at[motion::LeftHip] + at[motion::RightHip]).z(), 1e-9);
  // A body 10 % larger has thicker thighs.
  motion::Clip large = clip;
  large.body = motion::standard_body(1.925);
  for (motion::Pose& pose : large.poses) pose.root_position *= 1.1;
  EXPECT_NEAR(stool_under({}, large, place).size.y(), 1.1 * box.size.y(), 1e-9);
}

TEST(Stools, AreRefusedForWhoStandsOrLies) {
  motion::Clip standing = sitting_clip();
  for (motion::Pose& pose : standing.poses) pose.root_position.y() = 0.95;
  EXPECT_THROW(stool_under({}, standing, {}), Error);
  motion::Clip lying = sitting_clip();
  for (motion::Pose& pose : lying.poses) pose.root_position.y() = 0.15;
  EXPECT_THROW(stool_under({}, lying, {}), Error);
  motion::Clip other = sitting_clip();
  other.body.joints.resize(4);
  EXPECT_THROW(stool_under({}, other, {}), Error);
}

TEST(SetPlan, AWallThatHidesTheFigureIsLeftOut) {
  SetPlan plan;
  plan.walls = {{.side = Side::left, .distance_m = 1.5}, {.side = Side::right, .distance_m = 1.5}};
  const auto walls_seen_from = [&](const Vec3& eye) {
    render::Scene scene;
    add_walls(scene, plan, {}, eye);
    return scene.static_solids.meshes.size();
  };
  EXPECT_EQ(walls_seen_from({0.0, 1.5, 8.0}), 2u);
  EXPECT_EQ(walls_seen_from({4.0, 1.5, 2.0}), 1u);
}

TEST(SetPlan, OnATreadmillTheFigureStaysAndTheGroundGoesAsFastAsItWould) {
  Look look;
  look.set.in_place = true;
  look.set.ground = render::Ground{};
  look.set.belt = Belt{};
  const motion::Clip clip = test::walking_clip(61, Vec3(0.6, 0.0, 0.8), 0.04);
  const Shot shot = stage(clip, look);
  const auto& poses = shot.actors[0].clip.poses;
  const Vec3 drift = poses.back().root_position - poses.front().root_position;
  EXPECT_LT(drift.norm(), 1e-9);
  const render::Scene first = scene_at(shot, 0);
  const render::Scene later = scene_at(shot, 25);
  EXPECT_NEAR(later.ground.offset_x - first.ground.offset_x, -0.6f, 1e-5f);
  EXPECT_NEAR(later.ground.offset_z - first.ground.offset_z, -0.8f, 1e-5f);
  EXPECT_FALSE(later.static_solids.meshes.empty());
  EXPECT_NO_THROW(render::validate(later));

  // The stripes go as fast as the ground, are on the belt, and are the same ones from a frame to
  // the next.
  const auto middle_of = [&](const render::Mesh& stripe) {
    render::Vec3 sum = render::Vec3::Zero();
    for (const render::Vec3& p : stripe.positions) sum += p;
    const render::Vec3 mean = sum / static_cast<float>(stripe.positions.size());
    return (mean.cast<double>() - shot.place.centre).dot(shot.place.forward);
  };
  const double end = 0.5 * look.set.belt->length_m;
  for (int frame = 0; frame < 60; ++frame) {
    const render::Scene now = scene_at(shot, frame);
    const render::Scene next = scene_at(shot, frame + 1, frame);
    EXPECT_NO_THROW(render::shapes_between(now, next)) << frame;
    int whole = 0;
    for (std::size_t i = 0; i < now.solids.meshes.size(); ++i) {
      const double here = middle_of(now.solids.meshes[i]);
      const double there = middle_of(next.solids.meshes[i]);
      EXPECT_LE(std::abs(here), end + 1e-5);
      if (std::abs(here) > end - 0.1 || std::abs(there) > end - 0.1) continue;
      EXPECT_NEAR(there - here, -0.04, 1e-4);
      ++whole;
    }
    EXPECT_GE(whole, 1) << frame;
  }
}

TEST(Travel, OfASlowDriftIsNone) {
  EXPECT_EQ(mean_step(test::walking_clip(60, Vec3::UnitZ(), 0.001)), Vec3::Zero());
  EXPECT_LT((mean_step(test::walking_clip(60, Vec3::UnitX(), 0.03)) - Vec3(0.03, 0, 0)).norm(),
            1e-12);
}

}  // namespace
}  // namespace mien::scenes

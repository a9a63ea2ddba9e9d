#include "scenes/stage/actor.h"

#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

#include "motion/error.h"
#include "scenes/skinned_gltf.h"
#include "scenes/stage/shot.h"

namespace mien::scenes {
namespace {

motion::Clip standing(const motion::Skeleton& skeleton) {
  motion::Clip clip;
  clip.body = skeleton;
  motion::Pose pose;
  pose.root_position.y() = 0.96;
  pose.rotations.assign(skeleton.joints.size(), motion::Quat::Identity());
  clip.poses.assign(3, pose);
  return clip;
}

render::Scene drawn(const Actor& actor) {
  render::Scene scene;
  actor.draw(scene, actor, 1, {});
  return scene;
}

/// A file that is there as long as this lives.
struct CharacterFileOnDisk {
  std::filesystem::path path = std::filesystem::path(testing::TempDir()) /
                               (std::to_string(::getpid()) + "-" + "actor_test.gltf");

  CharacterFileOnDisk() {
    const auto file = test::skinned_gltf(motion::standard_body(1.3), {{}, test::mixamo_names()});
    std::ofstream(path) << file.text();
  }
  ~CharacterFileOnDisk() { std::filesystem::remove(path); }
};

TEST(AnActor, ThatIsAMannequinOrACharacterMakesASoundScene) {
  const CharacterFileOnDisk file;
  for (const Figure& figure : {Figure(MannequinOptions{}), Figure(CharacterOptions{file.path})}) {
    const Actor actor = make_actor(standing(motion::standard_body()), figure, Role::target);
    const render::Scene scene = drawn(actor);
    EXPECT_NO_THROW(render::validate(scene));
    ASSERT_EQ(scene.solids.meshes.size(), 1u);
    const render::Mesh& mesh = scene.solids.meshes.front();
    EXPECT_EQ(scene.textures.size(), 1u);
    for (const int part : {mesh.triangle_parts.front(), mesh.triangle_parts.back()}) {
      EXPECT_GE(motion::find_joint(actor.clip.body, scene.parts[static_cast<size_t>(part)].name),
                0);
    }
    // A copy draws the same after the first is gone.
    const Actor copy = Actor(actor);
    EXPECT_EQ(drawn(copy).solids.meshes.front().positions, mesh.positions);
  }
}

TEST(AnActor, ThatIsAStickFigureHasAPartForEachJoint) {
  const motion::Skeleton body = motion::standard_body();
  const Actor actor = make_actor(standing(body), StickOptions{}, Role::target);
  render::Scene scene;
  add_actor(scene, actor, 0, 0, {});
  EXPECT_NO_THROW(render::validate(scene));
  const auto part = [&](int index) { return scene.parts[static_cast<size_t>(index)].name; };
  // The ball at a joint, and the bone below it, bear its name.
  const motion::JointTransforms world =
      motion::world_transforms(actor.clip.body, actor.clip.poses[0]);
  const render::Vec3 knee = world.positions[motion::LeftKnee].cast<float>();
  const render::Vec3 ankle = world.positions[motion::LeftAnkle].cast<float>();
  int found = 0;
  for (const render::Sphere& sphere : scene.solids.spheres) {
    if ((sphere.centre - knee).norm() > 1e-5f) continue;
    EXPECT_EQ(part(sphere.part), "LeftKnee");
    ++found;
  }
  for (const render::RoundCone& round_cone : scene.solids.round_cones) {
    if ((round_cone.start - knee).norm() > 1e-5f || (round_cone.end - ankle).norm() > 1e-5f)
      continue;
    EXPECT_EQ(part(round_cone.part), "LeftKnee");
    ++found;
  }
  EXPECT_EQ(found, 2);
}

TEST(AnActor, ThatIsACharacterHasItsOwnStature) {
  const CharacterFileOnDisk file;
  const motion::Skeleton body = motion::standard_body();
  const Actor actor = make_actor(standing(body), CharacterOptions{file.path}, Role::target);
  EXPECT_NEAR(motion::leg_length(actor.clip.body), motion::leg_length(body), 1e-6);
  EXPECT_NEAR(actor.height_m, motion::standing_height(actor.clip.body), 1e-9);
}

TEST(AShot, FarFromTheOriginIsDrawnAsOneNearby) {
  const motion::Clip here = standing(motion::standard_body());
  motion::Clip far = here;
  for (motion::Pose& pose : far.poses) pose.root_position += motion::Vec3(1000.0, 0.0, -700.0);
  const Look look{.size = {64, 36}};
  const Shot near_shot = stage(here, look);
  const Shot far_shot = stage(far, look);
  const render::Scene expected = scene_at(near_shot, 1);
  const render::Scene drawn = scene_at(far_shot, 1);
  ASSERT_EQ(drawn.solids.spheres.size(), expected.solids.spheres.size());
  for (size_t i = 0; i < drawn.solids.spheres.size(); ++i) {
    EXPECT_EQ(drawn.solids.spheres[i].centre, expected.solids.spheres[i].centre);
  }
  EXPECT_EQ(camera_at(far_shot, 1).position, camera_at(near_shot, 1).position);
  // What begins nearby stays where it is, though the origin be out of the picture.
  motion::Clip aside = here;
  for (motion::Pose& pose : aside.poses) pose.root_position.x() += 60.0;
  EXPECT_EQ(stage(aside, look).actors[0].clip.poses[0].root_position.x(), 60.0);
}

TEST(AnActor, ThatIsATallCharacterIsInThePictureAsAWhole) {
  // A child's legs under an adult's trunk: with the motion's legs it is far taller than its body.
  motion::Skeleton stumpy = motion::standard_body();
  for (const motion::BodyJoint joint :
       {motion::LeftKnee, motion::RightKnee, motion::LeftAnkle, motion::RightAnkle}) {
    stumpy.joints[joint].offset *= 0.5;
  }
  const std::filesystem::path path = std::filesystem::path(testing::TempDir()) /
                                     (std::to_string(::getpid()) + "-" + "stumpy.gltf");
  std::ofstream(path) << test::skinned_gltf(stumpy, {{}, test::mixamo_names()}).text();
  const Shot shot = stage(standing(motion::standard_body()),
                          {.figure = CharacterOptions{path}, .size = {90, 160}});
  std::filesystem::remove(path);
  EXPECT_GT(shot.actors[0].height_m, 2.2);
  const render::Camera camera = camera_at(shot, 0);
  const render::Scene scene = scene_at(shot, 0);
  for (const render::Vec3& position : scene.solids.meshes.front().positions) {
    const auto pixel = render::project(camera, position);
    ASSERT_TRUE(pixel);
    EXPECT_GT(pixel->y(), 0.0f);
    EXPECT_LT(pixel->y(), 160.0f);
  }
}

TEST(AnActor, WithoutAHumanBodyIsRefusedAsAMannequin) {
  motion::Skeleton lamp;
  lamp.joints = {{"foot", -1, {}, {}}, {"arm", 0, {0, 1, 0}, {}}};
  EXPECT_NO_THROW(make_actor(standing(lamp), StickOptions{}, Role::target));
  EXPECT_THROW(make_actor(standing(lamp), MannequinOptions{}, Role::target), Error);
  EXPECT_THROW(make_actor(standing(lamp), CharacterOptions{"no.glb"}, Role::target), Error);
}

}  // namespace
}  // namespace mien::scenes

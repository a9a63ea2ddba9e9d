#include "scenes/actor.h"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "motion/error.h"

#include "skinned_gltf.h"

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
  std::filesystem::path path = std::filesystem::path(testing::TempDir()) / "actor_test.gltf";

  CharacterFileOnDisk() {
    const auto file = test::skinned_gltf(motion::standard_body(1.3), {{}, test::mixamo_names()});
    std::ofstream(path) << file.text();
  }
  ~CharacterFileOnDisk() { std::filesystem::remove(path); }
};

TEST(AnActor, ThatIsAMannequinOrACharacterMakesASoundScene) {
  const CharacterFileOnDisk file;
  for (const Figure& figure : {Figure(MannequinOptions{}), Figure(CharacterOptions{file.path})}) {
    const Actor actor = cast(standing(motion::standard_body()), figure, Role::target, {});
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

TEST(AnActor, ThatIsACharacterHasItsOwnStature) {
  const CharacterFileOnDisk file;
  const motion::Skeleton body = motion::standard_body();
  const Actor actor = cast(standing(body), CharacterOptions{file.path}, Role::target, {});
  EXPECT_NEAR(motion::leg_length(actor.clip.body), motion::leg_length(body), 1e-6);
  EXPECT_NEAR(actor.height_m, motion::standing_height(actor.clip.body), 1e-9);
}

TEST(AnActor, WithoutAHumanBodyIsRefusedAsAMannequin) {
  motion::Skeleton lamp;
  lamp.joints = {{"foot", -1, {}, {}}, {"arm", 0, {0, 1, 0}, {}}};
  EXPECT_NO_THROW(cast(standing(lamp), StickOptions{}, Role::target, {}));
  EXPECT_THROW(cast(standing(lamp), MannequinOptions{}, Role::target, {}), Error);
  EXPECT_THROW(cast(standing(lamp), CharacterOptions{"no.glb"}, Role::target, {}), Error);
}

}  // namespace
}  // namespace mien::scenes

#include "pipeline/study/figures/page_figures.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "motion/skeleton/body.h"
#include "motion/skeleton/hand.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/temporary_folder.h"
#include "scenes/face/character_face.h"
#include "scenes/face_figure.h"
#include "scenes/skinned_gltf.h"

// What a page gets is compared with what the renderer uses.

namespace mien::pipeline {
namespace {

namespace fs = std::filesystem;

const scenes::FigureColours grey = scenes::colours_of(scenes::Role::neutral);

motion::Clip standing(int frames, bool has_fingers) {
  motion::Clip clip;
  clip.body = motion::standard_body();
  clip.frames_per_second = 10.0;
  motion::Pose pose;
  pose.root_position = {0.0, 1.0, 0.0};
  pose.rotations.assign(motion::body_joint_count, motion::Quat::Identity());
  if (has_fingers) pose.fingers = motion::relaxed_fingers();
  clip.poses.assign(static_cast<std::size_t>(frames), pose);
  return clip;
}

std::vector<float> floats_in(const std::string& bytes) {
  std::vector<float> numbers(bytes.size() / sizeof(float));
  std::memcpy(numbers.data(), bytes.data(), bytes.size());
  return numbers;
}

/// A character with the targets "one" and "other" in a file, and its face.
class PageFaces : public testing::Test {
 protected:
  PageFaces() {
    auto robot = test::skinned_gltf(motion::standard_body(1.3), {{}, test::mixamo_names()});
    test::add_face(robot);
    write_file(folder_.path() / "robot.gltf", robot.text());
    write_file(folder_.path() / "talk.csv", "time,one,other\n0,0,1\n1,1,0.5\n");
  }

  PageFigure fitted(const scenes::Face& face, const motion::Clip& clip, int film_frames) {
    const scenes::Figure figure = shown(face);
    return figures_.fitted_figure(
        {.figure = figure, .colours = grey, .clip = clip, .film_frames = film_frames});
  }
  scenes::Figure shown(const scenes::Face& face) const {
    return scenes::CharacterOptions{.file = folder_.path() / "robot.gltf", .face = face};
  }

  const test::TemporaryFolder folder_;
  PageFigures figures_;
};

TEST_F(PageFaces, MoveAsInFilmsWhichOutlastALoop) {
  scenes::Face talk;
  talk.file = folder_.path() / "talk.csv";
  const motion::Clip clip = standing(4, false);
  const PageFigure figure = fitted(talk, clip, 12);
  ASSERT_EQ(figure.morphs, 2);
  const std::vector<float> weights = floats_in(figure.face);
  ASSERT_EQ(weights.size(), 24u);
  const scenes::Character character =
      scenes::scaled_to_body(scenes::read_character(folder_.path() / "robot.gltf"), clip.body);
  const scenes::FaceMotion film(character, talk, 12, clip.frames_per_second);
  for (int frame = 0; frame < 12; ++frame)
    for (std::size_t m = 0; m < 2; ++m)
      EXPECT_NEAR(weights[2 * static_cast<std::size_t>(frame) + m], film.at(frame)[m], 1e-6);
  EXPECT_NEAR(weights[6], 0.3, 1e-6);
  EXPECT_NEAR(weights[23], 0.5, 1e-6);
}

TEST_F(PageFaces, ShareOneFileUnlessTheyAreHidden) {
  const motion::Clip clip = standing(2, false);
  scenes::Face smile, hidden;
  smile.weights = {{"one", 0.25}};
  hidden.is_hidden = true;
  const PageFigure plain = fitted({}, clip, 2), smiling = fitted(smile, clip, 2),
                   covered = fitted(hidden, clip, 2);
  EXPECT_EQ(plain.key, smiling.key);
  EXPECT_NE(plain.key, covered.key);
  EXPECT_EQ(plain.morphs, 0);
  EXPECT_EQ(covered.morphs, 0);
  EXPECT_EQ(floats_in(smiling.face), (std::vector<float>{0.25f, 0.0f}));
  const scenes::Figure figure = shown({}), other = shown(hidden);
  const std::string open =
      figures_.file(plain.key, {.figure = figure, .colours = grey, .clip = clip});
  const std::string closed =
      figures_.file(covered.key, {.figure = other, .colours = grey, .clip = clip});
  EXPECT_NE(open.find("\"targetNames\":[\"one\",\"other\"]"), std::string::npos);
  EXPECT_EQ(closed.find("targetNames"), std::string::npos);
  EXPECT_NE(closed.find("glTF"), std::string::npos);
}

TEST_F(PageFaces, TurnJawsAndEyesThatAreJointsInEachFrame) {
  write_file(folder_.path() / "jointed.glb", test::face_figure_glb(test::FaceFormat::joints));
  write_file(folder_.path() / "open.csv", "time,jawOpen,lookLeft\n0,0,0\n0.3,1,0.5\n");
  scenes::Face moving;
  moving.file = folder_.path() / "open.csv";
  const scenes::Figure figure =
      scenes::CharacterOptions{.file = folder_.path() / "jointed.glb", .face = moving};
  const motion::Clip clip = standing(4, false);
  const PageFigure fitted =
      figures_.fitted_figure({.figure = figure, .colours = grey, .clip = clip, .film_frames = 4});
  const scenes::Character character =
      scenes::scaled_to_body(scenes::read_character(folder_.path() / "jointed.glb"), clip.body);
  const scenes::FaceMotion film(character, moving, 4, clip.frames_per_second);
  const motion::Clip own = scenes::retargeted_to(character, clip);
  const std::vector<float> numbers = floats_in(fitted.poses);
  const std::size_t joints = character.rig.joints.size();
  ASSERT_EQ(numbers.size(), 4 * 7 * joints);
  float turned = 0.0f;
  for (std::size_t f = 0; f < 4; ++f) {
    const motion::JointTransforms world =
        scenes::rig_pose(character, own.poses[f], film.turns_at(static_cast<int>(f)));
    for (std::size_t j = 0; j < joints; ++j) {
      for (std::size_t axis = 0; axis < 4; ++axis) {
        const auto of = [&](std::size_t frame) {
          return numbers[4 * 3 * joints + 4 * (frame * joints + j) + axis];
        };
        EXPECT_NEAR(of(f), world.rotations[j].coeffs()[static_cast<Eigen::Index>(axis)], 1e-6);
        turned = std::max(turned, std::abs(of(f) - of(0)));
      }
    }
  }
  EXPECT_GT(turned, 0.1f);
}

TEST(APageFigure, OfAStickFigureHasTheHandsThatAreShown) {
  PageFigures figures;
  const scenes::Figure stick = scenes::StickOptions();
  const motion::Clip handed = standing(3, true), plain = standing(3, false);
  const PageFigure with =
      figures.fitted_figure({.figure = stick, .colours = grey, .clip = handed, .film_frames = 3});
  constexpr int joints = motion::body_joint_count + motion::finger_joint_count;
  EXPECT_EQ(with.key, "");
  EXPECT_EQ(with.joints, joints);
  EXPECT_TRUE(with.has_hands);
  const std::vector<float> numbers = floats_in(with.poses);
  ASSERT_EQ(numbers.size(), static_cast<std::size_t>(3 * 7 * joints));
  const motion::JointTransforms world = motion::world_transforms(
      motion::with_fingers(handed.body), motion::with_fingers(handed.poses.back()));
  for (std::size_t j = 0; j < static_cast<std::size_t>(joints); ++j)
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_NEAR(numbers[static_cast<std::size_t>(2 * 3 * joints) + 3 * j +
                          static_cast<std::size_t>(axis)],
                  world.positions[j][axis], 1e-6);
  const PageFigure without =
      figures.fitted_figure({.figure = stick, .colours = grey, .clip = plain, .film_frames = 3});
  EXPECT_EQ(without.joints, 0);
  EXPECT_FALSE(without.has_hands);
}

TEST(APageFigure, HasAFileForEachColourOfAMannequin) {
  PageFigures figures;
  const scenes::Figure mannequin = scenes::MannequinOptions();
  const motion::Clip clip = standing(1, false);
  const auto key = [&](const scenes::FigureColours& colours) {
    return figures.fitted_figure({.figure = mannequin, .colours = colours, .clip = clip}).key;
  };
  EXPECT_NE(key(grey), key(scenes::colours_of_hex("#0072b2")));
  EXPECT_EQ(key(grey), key(scenes::colours_of(scenes::Role::neutral)));
}

}  // namespace
}  // namespace mien::pipeline

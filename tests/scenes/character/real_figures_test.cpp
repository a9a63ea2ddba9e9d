#include <algorithm>
#include <cmath>
#include <filesystem>
#include <vector>

#include <gtest/gtest.h>

#include "motion/formats/motion_file.h"
#include "motion/rig/body_mapping.h"
#include "motion/sole_heights.h"
#include "scenes/character/character.h"
#include "scenes/mannequin/mannequin.h"

#include "real_data.h"

// Figures that wear thirty real walks: nothing tears, limbs point where the motion's do, feet stand
// on the floor.

namespace mien::scenes {
namespace {

using motion::Vec3;
namespace fs = std::filesystem;

constexpr int frames_a_clip = 10;

class RealFigures : public testing::Test {
 protected:
  void SetUp() override {
    const auto folder = test::real_data();
    if (!folder) GTEST_SKIP() << "no motion capture here: set MIEN_DATA to the folder that has it";
    data = *folder;
    for (const auto& entry : fs::directory_iterator(data / "mocap" / "bandai-namco-1")) {
      if (entry.path().filename().string().find("_walk_") == std::string::npos) continue;
      files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    ASSERT_EQ(files.size(), 30u);
  }

  fs::path data;
  std::vector<fs::path> files;
};

std::vector<int> some_frames(const motion::Clip& clip) {
  std::vector<int> frames;
  for (int k = 0; k < frames_a_clip; ++k) {
    frames.push_back(k * (clip.frame_count() - 1) / (frames_a_clip - 1));
  }
  return frames;
}

/// How much longer skinned edges are than they were when modelled; edges shorter than `least` count
/// as that long.
struct Stretch {
  double greatest = 0.0;
  double of_one_in_thousand = 0.0;  ///< one edge in a thousand is stretched more
};

Stretch stretch_of(const SkinnedMesh& mesh, const render::Mesh& posed, double least) {
  std::vector<double> ratios;
  for (const auto& t : mesh.triangles) {
    for (size_t i = 0; i < 3; ++i) {
      const auto a = static_cast<size_t>(t[i]);
      const auto b = static_cast<size_t>(t[(i + 1) % 3]);
      const double before = (mesh.positions[a] - mesh.positions[b]).norm();
      const double now = (posed.positions[a] - posed.positions[b]).norm();
      if (!std::isfinite(now)) return {std::nan(""), std::nan("")};
      ratios.push_back(now / std::max(before, least));
    }
  }
  std::sort(ratios.begin(), ratios.end());
  return {ratios.back(), ratios[ratios.size() - 1 - ratios.size() / 1000]};
}

double lowest_of(const render::Mesh& mesh) {
  float lowest = mesh.positions.front().y();
  for (const render::Vec3& p : mesh.positions) lowest = std::min(lowest, p.y());
  return lowest;
}

/// Frames in which a foot is planted: the lowest sole point is as near to the floor as this.
constexpr double planted_m = 0.01;

TEST_F(RealFigures, OfThirtyWalksAreWholeMannequins) {
  for (const fs::path& file : files) {
    const motion::Clip clip = motion::to_body(motion::read_motion(file));
    const Mannequin mannequin = make_mannequin(clip.body, {}, colours_of(Role::created));
    const std::vector<double> soles = mien::test::lowest_sole_heights(clip);
    for (const int f : some_frames(clip)) {
      const render::Mesh mesh = posed(mannequin, clip.body, clip.poses[static_cast<size_t>(f)]);
      const Stretch stretch = stretch_of(mannequin.mesh, mesh, 0.008);
      EXPECT_LT(stretch.greatest, 5.5) << file << " " << f;
      EXPECT_LT(stretch.of_one_in_thousand, 4.0) << file << " " << f;
      if (std::abs(soles[static_cast<size_t>(f)]) > planted_m) continue;
      EXPECT_NEAR(lowest_of(mesh), 0.0, 0.025) << file << " " << f;
    }
  }
}

/// Largest angle between the rig's limbs and the motion's, radians.
double largest_turn_of_limbs(const Character& character, const motion::JointTransforms& rig,
                             const motion::JointTransforms& of_body) {
  double largest = 0.0;
  for (const motion::BodyJoint joint :
       {motion::LeftElbow, motion::LeftWrist, motion::RightElbow, motion::RightWrist,
        motion::LeftKnee, motion::LeftAnkle, motion::RightKnee, motion::RightAnkle}) {
    const auto parent = static_cast<size_t>(motion::body_parents[joint]);
    const auto at = [&](size_t b) {
      return rig.positions[static_cast<size_t>(character.joints[b].position)];
    };
    const Vec3 limb = at(joint) - at(parent);
    const Vec3 wanted = of_body.positions[joint] - of_body.positions[parent];
    largest = std::max(largest, std::atan2(limb.cross(wanted).norm(), limb.dot(wanted)));
  }
  return largest;
}

TEST_F(RealFigures, OfThirtyWalksAreWholeCharacters) {
  const Character read = read_character(data / "characters" / "cesium_man.gltf");
  for (const fs::path& file : files) {
    const motion::Clip clip = motion::to_body(motion::read_motion(file));
    const Character character = scaled_to_body(read, clip.body);
    const motion::Clip worn = retargeted_to(character, clip);
    const std::vector<double> soles = mien::test::lowest_sole_heights(clip);
    std::vector<double> lowest;
    for (const int f : some_frames(clip)) {
      const auto at = static_cast<size_t>(f);
      const std::vector<render::Mesh> meshes = posed(character, worn.poses[at]);
      ASSERT_EQ(meshes.size(), character.meshes.size());
      // Three edges at its waist have weights of their own, as its author left them.
      const Stretch stretch = stretch_of(character.meshes[0], meshes[0], 0.01);
      EXPECT_LT(stretch.greatest, 8.0) << file << " " << f;
      EXPECT_LT(stretch.of_one_in_thousand, 3.0) << file << " " << f;
      EXPECT_LT(largest_turn_of_limbs(character, rig_pose(character, worn.poses[at]),
                                      motion::world_transforms(clip.body, clip.poses[at])),
                3.0 * motion::radians_per_degree)
          << file << " " << f;
      if (std::abs(soles[at]) > planted_m) continue;
      lowest.push_back(lowest_of(meshes[0]));
      EXPECT_NEAR(lowest.back(), 0.0, 0.08) << file << " " << f;
    }
    // Its heels are long: where one strikes, it reaches into the floor.
    std::sort(lowest.begin(), lowest.end());
    EXPECT_NEAR(lowest[lowest.size() / 2], 0.0, 0.015) << file;
  }
}

}  // namespace
}  // namespace mien::scenes

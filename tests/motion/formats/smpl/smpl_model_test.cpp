#include "motion/formats/smpl/smpl_model.h"

#include <fstream>
#include <random>

#include <gtest/gtest.h>

#include "motion/formats/smpl/smpl.h"
#include "motion/formats/smpl/smpl_files.h"
#include "motion/refusal.h"

namespace mien::motion {
namespace {

using namespace mien::test;

bool has(const std::string& text, std::string_view words) {
  return text.find(words) != std::string::npos;
}

/// A made-up model: each joint is the midpoint of two vertices of its own, at a tenth of its number
/// along X; the first coefficient moves all along Z, the second each along Y by a hundredth of its
/// number.
struct MadeModel {
  std::size_t joints = 52;
  std::vector<double> vertices, shapes, regressor, tree;

  explicit MadeModel(std::size_t count = 52) : joints(count) {
    const std::size_t vertex_count = 2 * joints;
    regressor.assign(joints * vertex_count, 0.0);
    const Skeleton known = smpl_skeleton(joints);
    for (std::size_t j = 0; j < joints; ++j) {
      const auto n = static_cast<double>(j);
      vertices.insert(vertices.end(), {0.1 * n - 0.01, 0.2, 0.3, 0.1 * n + 0.01, 0.2, 0.3});
      for (int v = 0; v < 2; ++v)
        shapes.insert(shapes.end(), {0, 0, 0, 0, 0.01 * n, 0, 1, 0, 0});  // x, y, z by 3 betas
      regressor[j * vertex_count + 2 * j] = 0.5;
      regressor[j * vertex_count + 2 * j + 1] = 0.5;
      tree.push_back(j == 0 ? 4294967295.0 : known.joints[j].parent);
    }
    for (std::size_t j = 0; j < joints; ++j) tree.push_back(static_cast<double>(j));
  }

  std::vector<ZipMember> members() const {
    const std::string count = std::to_string(2 * joints);
    return {{"v_template", npy_f8("(" + count + ", 3)", vertices)},
            {"shapedirs", npy_f8("(" + count + ", 3, 3)", shapes)},
            {"J_regressor", npy_f8(shape_of(joints, 2 * joints), regressor)},
            {"kintree_table", npy_f8(shape_of(2, joints), tree)},
            {"posedirs", npy_file("'|O'", "()", "x")}};
  }
};

Vec3 made_place(std::size_t joint, double first, double second) {
  const auto n = static_cast<double>(joint);
  return {0.1 * n, 0.2 + 0.01 * n * second, 0.3 + first};
}

TEST(SmplModel, JointsFollowTheShapeCoefficients) {
  Skeleton skeleton = smpl_skeleton(52);
  const std::vector<double> betas = {0.5, 2.0};
  set_smpl_proportions(skeleton, npz_file(MadeModel().members()), "model.npz", betas);
  std::vector<Vec3> places;
  for (const Joint& joint : skeleton.joints) {
    places.push_back(joint.parent < 0
                         ? joint.offset
                         : Vec3(places[static_cast<std::size_t>(joint.parent)] + joint.offset));
    EXPECT_FALSE(joint.tip);
  }
  for (std::size_t j = 0; j < places.size(); ++j)
    EXPECT_LT((places[j] - made_place(j, 0.5, 2.0)).norm(), 1e-12) << j;
}

TEST(SmplModel, TheBodyAloneTakesItsJointsFromAnyModel) {
  Skeleton skeleton = smpl_skeleton(22);
  set_smpl_proportions(skeleton, npz_file(MadeModel(55).members()), "model.npz", {});
  EXPECT_LT((skeleton.joints[21].offset - Vec3(0.2, 0, 0)).norm(), 1e-12);
  Skeleton fingers = smpl_skeleton(52);
  set_smpl_proportions(fingers, npz_file(MadeModel(55).members()), "model.npz", {});
  // left_index1 is joint 25 of SMPL-X, left_wrist 20.
  EXPECT_LT((fingers.joints[22].offset - Vec3(0.5, 0, 0)).norm(), 1e-12);
}

TEST(SmplModel, ThePelvisIsAtItsRestPlaceFromTrans) {
  const std::filesystem::path file =
      std::filesystem::path(testing::TempDir()) / "mien_smpl_model.npz";
  std::ofstream(file, std::ios::binary) << npz_file(MadeModel().members());
  const SmplMotion motion{52, std::vector<double>(156, 0.1), {1, 2, 3}, 1};
  ReadOptions options;
  options.body_model = file;
  const Recording recording = parse_smpl(npz_file(amass_members(motion, 30.0)), "a.npz", options);
  // Each of 16 betas is 0.3: the first moves z by 0.3.
  EXPECT_LT((recording.poses[0].root_position - Vec3(1, 2.2, 3.6)).norm(), 1e-12);
  EXPECT_TRUE(has(recording.notes[0], "proportions of the model \"mien_smpl_model.npz\" for 16"));
  std::filesystem::remove(file);
}

TEST(SmplModel, OtherFilesAreRefused) {
  const auto refused = [](const std::vector<ZipMember>& members, std::size_t joints = 52) {
    Skeleton skeleton = smpl_skeleton(joints);
    return refusal_of([&] { set_smpl_proportions(skeleton, npz_file(members), "m.npz", {}); });
  };
  const std::vector<ZipMember> whole = MadeModel().members();
  for (const std::string_view name : {"v_template", "shapedirs", "J_regressor", "kintree_table"}) {
    std::vector<ZipMember> some = whole;
    std::erase_if(some, [&](const ZipMember& member) { return member.name == name; });
    EXPECT_TRUE(has(refused(some), "is no SMPL model: it has no array \"" + std::string(name)));
    for (ZipMember& member : some = whole)
      if (member.name == name) member.bytes = npy_file("'|O'", "()", "x");
    EXPECT_TRUE(has(refused(some), "holds Python objects"));
    for (ZipMember& member : some = whole)
      if (member.name == name) member.bytes = npy_f8("(2, 2)", {1, 2, 3, 4});
    EXPECT_TRUE(has(refused(some), " has the shape (2, 2), not ")) << refused(some);
  }
  MadeModel other;
  other.tree[5] = 4;
  EXPECT_TRUE(has(refused(other.members()), "gives joint 5 another parent"));
  EXPECT_TRUE(has(refused(MadeModel(24).members()),
                  "is a model of SMPL, which has no joint left_index1; name a model of SMPL-H"));
  Skeleton skeleton = smpl_skeleton(52);
  EXPECT_TRUE(has(refusal_of([&] {
                    set_smpl_proportions(skeleton, std::filesystem::path("SMPL_MALE.pkl"), {});
                  }),
                  "never unpickled"));
}

}  // namespace
}  // namespace mien::motion

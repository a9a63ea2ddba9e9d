#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "motion/formats/motion_file.h"
#include "motion/rig/body_mapping.h"
#include "motion/skeleton/body.h"
#include "scenes/closed_surface.h"
#include "scenes/mannequin/mannequin.h"
#include "scenes/mannequin/mannequin_landmarks.h"
#include "scenes/walking_clip.h"

#include "real_data.h"

namespace mien::scenes {
namespace {

using motion::BodyJoint;
using motion::Skeleton;
using motion::Vec3;

struct NamedBody {
  std::string name;
  Skeleton body;
};

/// The standard body walking on a rig whose spine has joints at these heights above the pelvis, the
/// last of which carries neck and collar bones.
Skeleton body_of_rig_with_spine(const std::vector<double>& heights) {
  const motion::Clip clip = test::walking_clip(30, Vec3::UnitZ(), 0.03);
  const Skeleton& body = clip.body;
  motion::Recording recording;
  recording.name = "made";
  recording.format = "bvh";
  std::vector<int> source;  // joint of the body, −1 for a joint of the spine, which never turns
  std::vector<int> place(motion::body_joint_count, 0);
  const auto add = [&](const std::string& name, int parent, const Vec3& offset, int from) {
    recording.skeleton.joints.push_back({name, parent, offset, std::nullopt});
    source.push_back(from);
    return recording.skeleton.size() - 1;
  };
  add("Hips", -1, Vec3::Zero(), motion::Pelvis);
  int top = 0;
  double height = 0.0;
  for (size_t k = 0; k < heights.size(); ++k) {
    const std::string name = k == 0 ? "Spine" : "Spine" + std::to_string(k);
    top = add(name, top, Vec3(0, heights[k] - height, 0), -1);
    height = heights[k];
  }
  const double chest =
      body.joints[motion::Spine].offset.y() + body.joints[motion::Chest].offset.y();
  const char* const names[] = {"Hips",
                               "",
                               "",
                               "Neck",
                               "Head",
                               "LeftShoulder",
                               "LeftArm",
                               "LeftForeArm",
                               "LeftHand",
                               "RightShoulder",
                               "RightArm",
                               "RightForeArm",
                               "RightHand",
                               "LeftUpLeg",
                               "LeftLeg",
                               "LeftFoot",
                               "LeftToeBase",
                               "RightUpLeg",
                               "RightLeg",
                               "RightFoot",
                               "RightToeBase"};
  for (int j = motion::Neck; j < motion::body_joint_count; ++j) {
    const int parent = motion::body_parents[static_cast<size_t>(j)];
    const motion::Joint& joint = body.joints[static_cast<size_t>(j)];
    const bool on_spine = parent == motion::Chest;
    const Vec3 offset = joint.offset + (on_spine ? Vec3(0, chest - height, 0) : Vec3(0, 0, 0));
    const int above = on_spine ? top : place[static_cast<size_t>(parent)];
    place[static_cast<size_t>(j)] = add(names[j], above, offset, j);
    recording.skeleton.joints.back().tip = joint.tip;
  }
  for (const motion::Pose& pose : clip.poses) {
    motion::Pose made;
    made.root_position = pose.root_position;
    for (const int from : source) {
      made.rotations.push_back(from < 0 ? motion::Quat::Identity()
                                        : pose.rotations[static_cast<size_t>(from)]);
    }
    recording.poses.push_back(made);
  }
  return motion::to_body(recording).body;
}

Skeleton with_head(const Vec3& neck_to_head, double tip) {
  Skeleton body = motion::standard_body();
  body.joints[motion::Head].offset = neck_to_head;
  body.joints[motion::Head].tip = Vec3(0, tip, 0);
  return body;
}

/// As the rigs of optical studios have it: collar bones, neck and shoulders at one height.
Skeleton with_everything_at_the_throat() {
  Skeleton body = motion::standard_body();
  body.joints[motion::Spine].offset = Vec3(0, 0.08, 0);
  body.joints[motion::Chest].offset = Vec3(0, 0.25, 0);
  body.joints[motion::Neck].offset = Vec3(0, 0.25, 0);
  for (const double side : {1.0, -1.0}) {
    const BodyJoint clavicle = side > 0 ? motion::LeftClavicle : motion::RightClavicle;
    body.joints[static_cast<size_t>(clavicle)].offset = Vec3(0, 0.25, 0);
    body.joints[static_cast<size_t>(clavicle + 1)].offset = Vec3(side * 0.195, 0, 0);
    const BodyJoint hip = side > 0 ? motion::LeftHip : motion::RightHip;
    body.joints[static_cast<size_t>(hip)].offset = Vec3(side * 0.117, 0, 0);
  }
  return body;
}

/// The root behind and above the hips, as in the Acclaim files of Carnegie Mellon.
Skeleton with_hips_before_the_root() {
  Skeleton body = motion::standard_body();
  body.joints[motion::Spine].offset.setZero();
  body.joints[motion::LeftHip].offset = Vec3(0.09, -0.12, 0.055);
  body.joints[motion::RightHip].offset = Vec3(-0.09, -0.12, 0.055);
  return body;
}

std::vector<NamedBody> made_bodies() {
  return {{"standard", motion::standard_body()},
          {"female", motion::standard_female_body()},
          {"no spine", body_of_rig_with_spine({0.28})},
          {"one spine joint, on the pelvis", body_of_rig_with_spine({0.0})},
          {"two spine joints, one on the pelvis", body_of_rig_with_spine({0.0, 0.28})},
          {"five spine joints", body_of_rig_with_spine({0.06, 0.12, 0.19, 0.26, 0.33})},
          {"throat", with_everything_at_the_throat()},
          {"hips before the root", with_hips_before_the_root()},
          {"long neck", with_head(Vec3(0, 0.20, 0), 0.17)},
          {"head's joint at the nape", with_head(Vec3(0, 0.03, 0), 0.24)},
          {"head's end at the eyes", with_head(Vec3(0, 0.12, 0), 0.09)},
          {"head far before the neck", with_head(Vec3(0, 0.06, 0.14), 0.12)}};
}

std::vector<NamedBody> real_bodies(const std::filesystem::path& folder) {
  std::vector<NamedBody> bodies;
  for (const char* file :
       {"mocap/aalto-two-actors/k_walk_fast_k_walk_angry_k_walk_regular_100_000_000.bvh",
        "mocap/aalto-two-actors/t_walk_fast_t_walk_angry_t_walk_regular_100_000_000.bvh",
        "mocap/bandai-namco-1/dataset-1_walk_normal_001.bvh", "mocap/cmu/01_01.bvh",
        "mocap/cmu/02_01.amc", "mocap/bandai-namco-1/dataset-1_walk_old_001.bvh",
        "recordings/opensim/subject01_walk1.trc", "recordings/opensim/walk_free_01.trc",
        "characters/cesium_man.gltf"}) {
    bodies.push_back({file, motion::to_body(motion::read_motion(folder / file)).body});
  }
  return bodies;
}

struct Heights {
  double lowest = 1e3;
  double highest = -1e3;

  void add(double height) {
    lowest = std::min(lowest, height);
    highest = std::max(highest, height);
  }

  double length() const { return highest - lowest; }
};

/// From the chin, where the painted face ends, to the crown, by the figure's own stature.
double head_by_stature(const Mannequin& mannequin) {
  Heights figure;
  Heights face;
  for (size_t v = 0; v < mannequin.mesh.positions.size(); ++v) {
    figure.add(mannequin.mesh.positions[v].y());
    if (mannequin.mesh.uv[v][1] > 0.5f) face.add(mannequin.mesh.positions[v].y());
  }
  return (figure.highest - face.lowest) / figure.length();
}

/// Half the trunk's breadth at a share of the way from the hips up to the shoulders.
double half_breadth(const Mannequin& mannequin, const Flesh& flesh, double share) {
  const auto middle = [&](BodyJoint left, BodyJoint right) {
    return Vec3(0.5 * (mannequin.bind.positions[left] + mannequin.bind.positions[right]));
  };
  const Vec3 hips = middle(motion::LeftHip, motion::RightHip);
  const Vec3 shoulders = middle(motion::LeftShoulder, motion::RightShoulder);
  const Vec3 centre = hips + share * (shoulders - hips);
  double widest = 0.0;
  for (double z = -0.15; z <= 0.15; z += 0.01) {
    for (double x = 0.0; x <= 0.3; x += 0.002) {
      if (signed_distance(flesh.trunk, centre + Vec3(x, 0, z)) < 0.0) widest = std::max(widest, x);
    }
  }
  return widest;
}

void expect_a_human_shape(const NamedBody& named) {
  SCOPED_TRACE(named.name);
  for (const double sex : {0.0, 1.0}) {
    const MannequinOptions options{0.5, sex};
    const Mannequin mannequin = make_mannequin(named.body, options, colours_of(Role::created));
    const Flesh flesh = flesh_of(named.body, mannequin.bind, options);
    double waist = 1.0;
    double chest = 0.0;
    for (int k = 4; k <= 12; ++k) {
      waist = std::min(waist, half_breadth(mannequin, flesh, 0.05 * k));
      chest = std::max(chest, half_breadth(mannequin, flesh, 0.05 * k + 0.25));
    }
    EXPECT_GE(waist, 0.6 * chest) << sex;
    EXPECT_LE(waist, 1.1 * chest) << sex;
    EXPECT_GE(head_by_stature(mannequin), 0.12) << sex;
    EXPECT_LE(head_by_stature(mannequin), 0.15) << sex;
    const mien::test::Topology topology = mien::test::topology_of(mannequin.mesh.triangles);
    EXPECT_EQ(topology.euler, 2) << sex;
    EXPECT_EQ(topology.bad_edges, 0) << sex;
  }
}

/// How deep the middle between the hips lies in the flesh, at 1.75 m.
double depth_of_groin(const Skeleton& body) {
  const Mannequin mannequin = make_mannequin(body, {}, colours_of(Role::created));
  const Flesh flesh = flesh_of(body, mannequin.bind, {});
  const Vec3 groin = 0.5 * (mannequin.bind.positions[motion::LeftHip] +
                            mannequin.bind.positions[motion::RightHip]);
  return -signed_distance(flesh.trunk, groin) / motion::relative_stature(body);
}

TEST(AMannequinOnAnyRig, HasAWaistAndAHeadOfAHuman) {
  for (const NamedBody& named : made_bodies()) expect_a_human_shape(named);
}

/// Or else a neck that bends forward leaves a hole in the back of the head.
TEST(AMannequinOnAnyRig, HasASkullThatMovesAsAWhole) {
  for (const NamedBody& named : made_bodies()) {
    const Mannequin mannequin = make_mannequin(named.body, {}, colours_of(Role::created));
    const double scale = motion::relative_stature(named.body);
    const double joint = mannequin.bind.positions[motion::Head].y() +
                         std::max(head_shape(named.body).raise.y(), 0.0);
    int counted = 0;
    for (size_t v = 0; v < mannequin.mesh.positions.size(); ++v) {
      if (mannequin.mesh.positions[v].y() < joint + 0.045 * scale) continue;
      ++counted;
      for (const Influence& influence : mannequin.mesh.influences[v]) {
        if (influence.joint == motion::Head) continue;
        EXPECT_LT(influence.weight, 0.02f) << named.name << " " << mannequin.mesh.positions[v];
      }
    }
    EXPECT_GT(counted, 100) << named.name;
  }
}

TEST(AMannequinOnAnyRig, HasFleshBetweenItsHips) {
  for (const NamedBody& named : made_bodies()) {
    EXPECT_GT(depth_of_groin(named.body), 0.06) << named.name;
  }
}

TEST(AMannequinOnAnyRig, IsShapedAlikeWhereverTheSpineHasItsJoints) {
  const auto shape = [](const Skeleton& body) {
    const Mannequin mannequin = make_mannequin(body, {}, colours_of(Role::created));
    const Flesh flesh = flesh_of(body, mannequin.bind, {});
    std::vector<double> breadths;
    for (int k = 1; k <= 16; ++k) breadths.push_back(half_breadth(mannequin, flesh, 0.05 * k));
    return breadths;
  };
  const std::vector<double> expected = shape(motion::standard_body());
  for (const std::vector<double>& spine :
       {std::vector<double>{0.28}, {0.0}, {0.0, 0.28}, {0.06, 0.12, 0.19, 0.26, 0.33}}) {
    const std::vector<double> found = shape(body_of_rig_with_spine(spine));
    for (size_t k = 0; k < found.size(); ++k) {
      EXPECT_NEAR(found[k], expected[k], 0.008) << spine.size() << " joints, level " << k;
    }
  }
}

TEST(AMannequinOnAnyRig, BendsAtTheWaistThoughTheSpineLiesOnThePelvis) {
  const Mannequin mannequin =
      make_mannequin(body_of_rig_with_spine({0.0, 0.28}), {}, colours_of(Role::created));
  const double hips = mannequin.bind.positions[motion::LeftHip].y();
  for (size_t v = 0; v < mannequin.mesh.positions.size(); ++v) {
    if (mannequin.mesh.positions[v].y() > hips) continue;
    for (const Influence& influence : mannequin.mesh.influences[v]) {
      if (influence.joint == motion::Spine) {
        EXPECT_LT(influence.weight, 0.1f);
      }
    }
  }
}

TEST(AMannequinOnRealRigs, HasAWaistAndAHeadOfAHuman) {
  const auto folder = mien::test::real_data();
  if (!folder) GTEST_SKIP() << "no motion capture here: set MIEN_DATA to the folder that has it";
  for (const NamedBody& named : real_bodies(*folder)) {
    expect_a_human_shape(named);
    EXPECT_GT(depth_of_groin(named.body), 0.06) << named.name;
  }
}

}  // namespace
}  // namespace mien::scenes

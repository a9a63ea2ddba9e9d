#include "scenes/mannequin/mannequin.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "motion/math/rotation.h"
#include "motion/skeleton/sole.h"
#include "scenes/closed_surface.h"

namespace mien::scenes {
namespace {

using motion::Quat;
using motion::Vec3;

const FigureColours colours = colours_of(Role::created);

motion::Pose standing(const motion::Skeleton& body) {
  motion::Pose pose = modelling_pose(body);
  std::fill(pose.rotations.begin(), pose.rotations.end(), Quat::Identity());
  return pose;
}

/// Longest skinned edge by its length as modelled.
double greatest_stretch(const Mannequin& mannequin, const render::Mesh& posed) {
  double greatest = 0.0;
  for (const auto& t : mannequin.mesh.triangles) {
    for (size_t i = 0; i < 3; ++i) {
      const auto a = static_cast<size_t>(t[i]);
      const auto b = static_cast<size_t>(t[(i + 1) % 3]);
      const double before = (mannequin.mesh.positions[a] - mannequin.mesh.positions[b]).norm();
      const double now = (posed.positions[a] - posed.positions[b]).norm();
      // Edges far shorter than a cell stretch by much for nothing.
      greatest = std::max(greatest, now / std::max(before, 0.008));
    }
  }
  return greatest;
}

double width_at(const Mannequin& mannequin, double low, double high) {
  double widest = 0.0;
  for (size_t v = 0; v < mannequin.mesh.positions.size(); ++v) {
    const Vec3& p = mannequin.mesh.positions[v];
    const int joint = mannequin.mesh.influences[v].front().joint;
    if (joint <= motion::Chest && p.y() > low && p.y() < high) {
      widest = std::max(widest, std::abs(p.x()));
    }
  }
  return widest;
}

TEST(AMannequin, IsOneClosedSurfaceWhateverItsBuild) {
  for (const double build : {0.0, 0.5, 1.0}) {
    for (const double sex : {0.0, 1.0}) {
      const motion::Skeleton body =
          sex < 0.5 ? motion::standard_female_body() : motion::standard_body(1.9);
      for (const MeshDetail detail : {MeshDetail::full, MeshDetail::draft}) {
        const Mannequin mannequin = make_mannequin(body, {build, sex}, colours, detail);
        const mien::test::Topology topology = mien::test::topology_of(mannequin.mesh.triangles);
        EXPECT_EQ(topology.bad_edges, 0) << build << " " << sex;
        EXPECT_EQ(topology.euler, 2) << build << " " << sex;
        EXPECT_NO_THROW(validate(mannequin.mesh, motion::body_joint_count));
        EXPECT_LT(mannequin.mesh.triangles.size(), detail == MeshDetail::full ? 26000u : 14000u);
      }
    }
  }
}

TEST(AMannequin, OfADraftHasTheSameShapeToAFewMillimetres) {
  const motion::Skeleton body = motion::standard_body();
  const Mannequin mannequin = make_mannequin(body, {}, colours, MeshDetail::draft);
  const Flesh flesh = flesh_of(body, mannequin.bind, {});
  double farthest = 0.0, sum = 0.0;
  for (const auto& triangle : mannequin.mesh.triangles) {
    Vec3 middle = Vec3::Zero();
    for (const int corner : triangle)
      middle += mannequin.mesh.positions[static_cast<std::size_t>(corner)] / 3.0;
    const double distance = std::abs(signed_distance(flesh, middle));
    farthest = std::max(farthest, distance);
    sum += distance;
  }
  EXPECT_LT(farthest, 0.012);
  EXPECT_LT(sum / static_cast<double>(mannequin.mesh.triangles.size()), 0.001);
}

TEST(AMannequin, IsAsTallAsItsBodyAndStandsOnItsSoles) {
  for (const double stature : {1.2, 1.75, 2.0}) {
    const motion::Skeleton body = motion::standard_body(stature);
    const Mannequin mannequin = make_mannequin(body, {}, colours);
    const motion::Pose pose = standing(body);
    const auto soles = motion::sole_points(body, motion::world_transforms(body, pose), true);
    double lowest = 10.0;
    double highest = 0.0;
    for (const render::Vec3& p : posed(mannequin, body, pose).positions) {
      lowest = std::min(lowest, static_cast<double>(p.y()));
      highest = std::max(highest, static_cast<double>(p.y()));
    }
    EXPECT_NEAR(lowest, soles.ball.y(), 0.006 * stature);
    EXPECT_NEAR(highest - lowest, stature, 0.015 * stature);
  }
}

TEST(AMannequin, IsWiderWhenHeavierAndNarrowerHippedWhenMale) {
  const motion::Skeleton body = motion::standard_body();
  const auto waist = [&](double build, double sex) {
    return width_at(make_mannequin(body, {build, sex}, colours), 1.06, 1.12);
  };
  const auto hips = [&](double sex) {
    return width_at(make_mannequin(body, {0.5, sex}, colours), 0.86, 0.94);
  };
  EXPECT_GT(waist(1.0, 0.5), waist(0.5, 0.5) + 0.01);
  EXPECT_GT(waist(0.5, 0.5), waist(0.0, 0.5) + 0.01);
  EXPECT_GT(waist(0.5, 1.0), waist(0.5, 0.0) + 0.005);
  EXPECT_GT(hips(0.0), hips(1.0));
}

TEST(AMannequin, IsTheSameOnBothSides) {
  const Mannequin mannequin = make_mannequin(motion::standard_body(), {}, colours);
  const Flesh flesh = flesh_of(motion::standard_body(), mannequin.bind, {});
  for (const Vec3& p : mannequin.mesh.positions) {
    EXPECT_NEAR(signed_distance(flesh, Vec3(-p.x(), p.y(), p.z())), 0.0, 2e-3);
  }
}

TEST(AMannequin, HasNoLegThatMovesTheOther) {
  const Mannequin mannequin = make_mannequin(motion::standard_body(), {0.8, 0.2}, colours);
  for (const auto& influences : mannequin.mesh.influences) {
    double left = 0.0;
    double right = 0.0;
    for (const Influence& influence : influences) {
      if (motion::is_left(motion::BodyJoint(influence.joint))) left += influence.weight;
      if (motion::is_right(motion::BodyJoint(influence.joint))) right += influence.weight;
    }
    // Collar bones meet softly over the breastbone.
    EXPECT_LT(std::min(left, right), 0.1);
  }
}

TEST(AMannequin, BendsWithoutTearing) {
  const motion::Skeleton body = motion::standard_body();
  const Mannequin mannequin = make_mannequin(body, {}, colours);
  const auto turn = [](double x, double y, double z) {
    return motion::exp(Vec3(x, y, z) * motion::radians_per_degree);
  };
  motion::Pose bent = standing(body);
  bent.rotations[motion::LeftElbow] = turn(0, -120, 0);
  bent.rotations[motion::LeftShoulder] = turn(0, 0, -70);
  bent.rotations[motion::RightShoulder] = turn(0, 0, -60);
  bent.rotations[motion::LeftHip] = turn(-80, 0, 0);
  bent.rotations[motion::LeftKnee] = turn(120, 0, 0);
  bent.rotations[motion::Head] = turn(0, 60, 0);
  EXPECT_LT(greatest_stretch(mannequin, posed(mannequin, body, bent)), 4.5);
  motion::Pose crossed = standing(body);
  crossed.rotations[motion::LeftHip] = turn(-10, 0, -14);
  crossed.rotations[motion::RightHip] = turn(8, 0, 14);
  EXPECT_LT(greatest_stretch(mannequin, posed(mannequin, body, crossed)), 2.5);
}

TEST(AMannequin, KeepsItsForearmThickWhenTheHandTurns) {
  const motion::Skeleton body = motion::standard_body();
  const Mannequin mannequin = make_mannequin(body, {}, colours);
  const auto thinnest_wrist = [&](double degrees) {
    motion::Pose pose = standing(body);
    pose.rotations[motion::LeftWrist] =
        motion::exp(Vec3(degrees, 0, 0) * motion::radians_per_degree);
    const Vec3 wrist = motion::world_positions(body, pose)[motion::LeftWrist];
    double thinnest = 1.0;
    const render::Mesh mesh = posed(mannequin, body, pose);
    for (const render::Vec3& p : mesh.positions) {
      const Vec3 from = p.cast<double>() - wrist;
      if (std::abs(from.x()) < 0.03) thinnest = std::min(thinnest, std::hypot(from.y(), from.z()));
    }
    return thinnest;
  };
  EXPECT_GT(thinnest_wrist(150.0), 0.8 * thinnest_wrist(0.0));
}

TEST(AMannequinsFace, LooksForward) {
  const motion::Skeleton body = motion::standard_body();
  const Mannequin mannequin = make_mannequin(body, {}, colours);
  const Vec3 head = mannequin.bind.positions[motion::Head];
  int face = 0;
  for (size_t v = 0; v < mannequin.mesh.positions.size(); ++v) {
    if (mannequin.mesh.uv[v][1] < 0.5f) continue;
    ++face;
    EXPECT_GT(mannequin.mesh.positions[v].z(), head.z() + 0.02);
    EXPECT_EQ(mannequin.mesh.influences[v].front().joint, motion::Head);
  }
  EXPECT_GT(face, 100);
}

TEST(AMannequinsPaint, IsLighterOnTheLeft) {
  const render::Texture paint = mannequin_paint(colours);
  const auto texel = [&](int column, int row) {
    return paint.texels[static_cast<size_t>(row * paint.width + column)].sum();
  };
  EXPECT_GT(texel(250, 20), texel(128, 20));
  EXPECT_GT(texel(128, 20), texel(5, 20));
}

}  // namespace
}  // namespace mien::scenes

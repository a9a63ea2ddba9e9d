#include "pipeline/regression/comparison/body_shares.h"

#include <algorithm>
#include <array>
#include <limits>

#include "motion/measures/differences/joint_difference.h"
#include "motion/measures/distance/body_part.h"
#include "motion/skeleton/body.h"

namespace mien::pipeline {

namespace {

using motion::Vec3;
using Point = Eigen::Vector2f;

constexpr double reach_m = 0.15;
constexpr double least_move_px = 0.05;

/// A bone as the camera sees it.
struct ProjectedBone {
  int part = 0;  ///< BodyJoint that carries it
  Point from;
  Point to;
};

/// A body joint with what hangs on it, in the picture; joints behind the camera are left out.
struct ProjectedParts {
  std::vector<ProjectedBone> bones;
  std::vector<std::vector<Point>> points;  ///< by joint: those whose movement counts
  float reach_px = 0.0f;
};

Point seen(const render::Camera& camera, const Vec3& point) {
  const auto pixel = render::project(camera, point.cast<float>());
  return pixel ? *pixel : Point::Constant(std::numeric_limits<float>::quiet_NaN());
}

/// How many pixels a length across the line of sight takes at a point.
float pixels_of(const render::Camera& camera, const Vec3& at, double metres) {
  const Point middle = seen(camera, at);
  float most = 0.0f;
  for (int axis = 0; axis < 3; ++axis) {
    const Point aside = seen(camera, at + metres * Vec3::Unit(axis));
    if (const float pixels = (aside - middle).norm(); pixels > most) most = pixels;
  }
  return most;
}

ProjectedParts parts_of(const ProjectedBody& body) {
  const motion::Skeleton& skeleton = body.clip.body;
  const motion::Pose& pose =
      body.clip.poses[static_cast<std::size_t>(std::min(body.frame, body.clip.frame_count() - 1))];
  const motion::JointTransforms world = motion::world_transforms(skeleton, pose);
  const std::vector<motion::BoneAxes> axes = motion::bone_axes(skeleton);
  ProjectedParts parts;
  parts.points.resize(skeleton.joints.size());
  for (std::size_t j = 0; j < skeleton.joints.size(); ++j) {
    const int joint = static_cast<int>(j);
    const motion::JointPoints own = motion::points_at(world, joint, axes[j]);
    for (const Vec3& point : {own.joint, own.side, own.up})
      parts.points[j].push_back(seen(body.camera, point));
    const Point from = seen(body.camera, own.joint);
    if (const auto& tip = skeleton.joints[j].tip) {
      const Vec3 end = world.positions[j] + world.rotations[j] * *tip;
      parts.bones.push_back({joint, from, seen(body.camera, end)});
      parts.points[j].push_back(parts.bones.back().to);
    }
    if (const int parent = skeleton.joints[j].parent; parent >= 0) {
      const Point above = seen(body.camera, world.positions[static_cast<std::size_t>(parent)]);
      parts.bones.push_back({parent, above, from});
      parts.points[static_cast<std::size_t>(parent)].push_back(from);
    }
  }
  parts.reach_px = pixels_of(body.camera, world.positions.front(), reach_m);
  return parts;
}

float distance_to(const ProjectedBone& bone, const Point& pixel) {
  const Point along = bone.to - bone.from;
  const float length = along.squaredNorm();
  const float share =
      length > 0.0f ? std::clamp((pixel - bone.from).dot(along) / length, 0.0f, 1.0f) : 0.0f;
  return (pixel - bone.from - share * along).norm();  // NaN when an end is not seen
}

std::vector<double> moves(const ProjectedParts& before, const ProjectedParts& now) {
  std::vector<double> moved(before.points.size());
  for (std::size_t j = 0; j < moved.size(); ++j) {
    for (std::size_t k = 0; k < std::min(before.points[j].size(), now.points[j].size()); ++k) {
      const double pixels = (now.points[j][k] - before.points[j][k]).norm();
      if (pixels > moved[j]) moved[j] = pixels;
    }
  }
  return moved;
}

double squared_error(const std::uint8_t* a, const std::uint8_t* b) {
  double sum = 0.0;
  for (int c = 0; c < 3; ++c) sum += (a[c] - b[c]) * (a[c] - b[c]);
  return sum;
}

/// The part that explains a change at a pixel, or −1.
int part_at(const Point& pixel, const std::array<const ProjectedParts*, 2>& bodies,
            const std::vector<double>& moved) {
  int nearest = -1;
  float least = std::numeric_limits<float>::infinity();
  for (const ProjectedParts* body : bodies) {
    for (const ProjectedBone& bone : body->bones) {
      if (moved[static_cast<std::size_t>(bone.part)] < least_move_px) continue;
      const float distance = distance_to(bone, pixel);
      if (distance < least && distance <= body->reach_px) {
        least = distance;
        nearest = bone.part;
      }
    }
  }
  return nearest;
}

}  // namespace

std::vector<BodyShare> body_shares(const render::Image8& picture_before,
                                   const render::Image8& picture_now, const ProjectedBody& before,
                                   const ProjectedBody& now) {
  const ProjectedParts then = parts_of(before);
  const ProjectedParts today = parts_of(now);
  // Seen by one camera, which may have been moved by what the body does now.
  const std::vector<double> moved = moves(parts_of({before.clip, before.frame, now.camera}), today);
  std::vector<double> by_part(moved.size() + 1);  // the last: of no part
  double all = 0.0;
  const int width = std::min(picture_before.width, picture_now.width);
  for (int y = 0; y < std::min(picture_before.height, picture_now.height); ++y) {
    for (int x = 0; x < width; ++x) {
      const double error = squared_error(picture_before.at(x, y), picture_now.at(x, y));
      if (error == 0.0) continue;
      const Point pixel(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
      const int part = part_at(pixel, {&then, &today}, moved);
      by_part[part < 0 ? moved.size() : static_cast<std::size_t>(part)] += error;
      all += error;
    }
  }
  std::vector<BodyShare> shares;
  for (std::size_t j = 0; j < moved.size(); ++j)
    if (by_part[j] > 0.0)
      shares.push_back(
          {motion::part_name(static_cast<motion::BodyJoint>(j)), by_part[j] / all, moved[j]});
  std::ranges::stable_sort(shares, std::greater{}, &BodyShare::share);
  if (by_part.back() > 0.0) shares.push_back({"", by_part.back() / all, 0.0});
  return shares;
}

}  // namespace mien::pipeline

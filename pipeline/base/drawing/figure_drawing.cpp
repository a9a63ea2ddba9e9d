#include "pipeline/base/drawing/figure_drawing.h"

#include <cmath>
#include <functional>

#include "motion/skeleton/body.h"
#include "motion/skeleton/hand.h"

namespace mien::pipeline {

namespace {

using motion::Vec3;

ViewPosition seen(const Vec3& p) {
  const double turn = 25.0 * motion::radians_per_degree;
  return {p.x() * std::sin(turn) + p.z() * std::cos(turn), p.y(),
          p.x() * std::cos(turn) - p.z() * std::sin(turn)};
}

/// The joints that a limb runs through; its first bone joins it to the trunk.
struct LimbJoints {
  std::vector<motion::BodyJoint> joints;
  double width;
};

std::vector<LimbJoints> limbs_of_the_body() {
  using namespace motion;
  return {{{Pelvis, Spine, Chest, Neck, Head}, 0.065},
          {{Chest, LeftClavicle, LeftShoulder, LeftElbow, LeftWrist}, 0.045},
          {{Chest, RightClavicle, RightShoulder, RightElbow, RightWrist}, 0.045},
          {{Pelvis, LeftHip, LeftKnee, LeftAnkle, LeftToe}, 0.055},
          {{Pelvis, RightHip, RightKnee, RightAnkle, RightToe}, 0.055}};
}

/// A limb from the wrist to the tip of each finger.
void add_fingers(const motion::Skeleton& body, const motion::Pose& pose, Figure& figure) {
  constexpr double finger_width = 0.016;
  const motion::Skeleton handed = motion::with_fingers(body);
  const motion::JointTransforms world =
      motion::world_transforms(handed, motion::with_fingers(pose));
  for (int joint = 0; joint < motion::finger_joint_count; ++joint) {
    const bool left = motion::is_left_finger(joint);
    const auto j = static_cast<std::size_t>(motion::body_joint_count + joint);
    if (motion::segment_of(joint) == 0) {
      const Vec3& wrist = world.positions[left ? motion::LeftWrist : motion::RightWrist];
      figure.push_back({{seen(wrist)}, finger_width, left});
    }
    figure.back().joints.push_back(seen(world.positions[j]));
    if (const auto& tip = handed.joints[j].tip)
      figure.back().joints.push_back(seen(world.positions[j] + world.rotations[j] * *tip));
  }
}

void draw_head(Canvas& canvas, const Limb& limb, const FigureStyle& style,
               const FigureScale& scale) {
  const Point neck = scale.at(limb.joints.front());
  const Point crown = scale.at(limb.joints.back());
  canvas.disc({0.5 * (neck.x + crown.x), 0.5 * (neck.y + crown.y)},
              (0.07 + 0.025 * style.thickness) * scale.points_per_metre, style.colours.line);
}

void draw_limb(Canvas& canvas, const Limb& limb, const FigureStyle& style,
               const FigureScale& scale) {
  std::vector<Point> points;
  for (const ViewPosition& p : limb.joints) points.push_back(scale.at(p));
  const double width = std::max(0.9, limb.width * scale.points_per_metre) * style.thickness;
  if (style.halo) {
    // Not round the first bone, where the limb grows out of the trunk.
    canvas.polyline(std::span(points).subspan(1), {.width = width + 1.1, .colour = paper});
  }
  canvas.polyline(points,
                  {.width = width, .colour = limb.left ? style.colours.light : style.colours.line});
}

}  // namespace

Figure figure_of(const motion::Skeleton& body, const motion::Pose& pose) {
  const motion::JointTransforms world = motion::world_transforms(body, pose);
  const auto tip_of = [&](std::size_t j) {
    const Vec3 tip = body.joints[j].tip.value_or(Vec3::Zero());
    return seen(world.positions[j] + world.rotations[j] * tip);
  };
  Figure figure;
  for (const auto& [joints, width] : limbs_of_the_body()) {
    Limb limb{{}, width, motion::is_left(joints.back())};
    for (const motion::BodyJoint j : joints) limb.joints.push_back(seen(world.positions[j]));
    const bool is_arm = joints.back() == motion::LeftWrist || joints.back() == motion::RightWrist;
    const bool has_end = joints.back() != motion::Head && !(is_arm && !pose.fingers.empty());
    if (has_end) limb.joints.push_back(tip_of(joints.back()));
    figure.push_back(std::move(limb));
  }
  if (!pose.fingers.empty()) add_fingers(body, pose, figure);
  figure.push_back({{seen(world.positions[motion::Head]), tip_of(motion::Head)}, 0.2, false, true});
  std::ranges::stable_sort(figure, std::greater{}, &Limb::depth);  // painter's order
  return figure;
}

void FigureExtent::include(const Figure& figure) {
  for (const Limb& limb : figure) {
    for (const ViewPosition& p : limb.joints) {
      left = std::min(left, p.right);
      right = std::max(right, p.right);
      bottom = std::min(bottom, p.up);
      top = std::max(top, p.up);
    }
  }
}

void draw_figure(Canvas& canvas, const Figure& figure, const FigureStyle& style,
                 const FigureScale& scale) {
  for (const Limb& limb : figure) {
    if (limb.head) {
      draw_head(canvas, limb, style, scale);
    } else {
      draw_limb(canvas, limb, style, scale);
    }
  }
}

}  // namespace mien::pipeline

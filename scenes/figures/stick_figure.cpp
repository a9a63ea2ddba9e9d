#include "scenes/figures/stick_figure.h"

#include <algorithm>
#include <array>
#include <utility>

#include "motion/skeleton/hand.h"

namespace mien::scenes {

namespace {

using motion::BodyJoint;

/// Radii at a stature of 1.75 m: of the joint's sphere, and of its bone at the far end.
struct Thickness {
  double joint;
  double far;
};

constexpr double drawn_stature = 1.75;
constexpr double plain_radius = 0.022;
constexpr double head_radius = 0.092;

const Thickness& thickness_of(BodyJoint joint) {
  static constexpr std::pair<BodyJoint, Thickness> thicknesses[] = {
      {motion::Pelvis, {0.062, 0.058}},       {motion::Spine, {0.058, 0.062}},
      {motion::Chest, {0.064, 0.036}},        {motion::Neck, {0.034, 0.034}},
      {motion::Head, {0.036, 0.036}},         {motion::LeftClavicle, {0.036, 0.042}},
      {motion::LeftShoulder, {0.044, 0.033}}, {motion::LeftElbow, {0.035, 0.025}},
      {motion::LeftWrist, {0.027, 0.024}},    {motion::LeftHip, {0.060, 0.043}},
      {motion::LeftKnee, {0.046, 0.031}},     {motion::LeftAnkle, {0.034, 0.026}},
      {motion::LeftToe, {0.027, 0.020}},
  };
  const BodyJoint one = motion::is_right(joint) ? motion::mirrored(joint) : joint;
  return std::ranges::find(thicknesses, one, &std::pair<BodyJoint, Thickness>::first)->second;
}

/// Material indices of the shades, appended to the scene.
struct Shades {
  int middle;
  int left;
  int right;
  int visor;

  int of(BodyJoint joint) const {
    if (motion::is_left(joint)) return left;
    return motion::is_right(joint) ? right : middle;
  }
};

Shades add_materials(render::Scene& scene, const FigureColours& colours) {
  const auto add = [&](const render::Color& albedo) {
    scene.materials.push_back({albedo, 0.03f, 0.55f});
    return static_cast<int>(scene.materials.size()) - 1;
  };
  const int middle = add(colours.middle);
  const int left = add(colours.left);
  const int right = add(colours.right);
  const int visor = add(0.2f * colours.middle);
  return {middle, left, right, visor};
}

render::Vec3 to_render(const motion::Vec3& point) { return point.cast<float>(); }

void add_capsule(render::Scene& scene, const motion::Vec3& start, const motion::Vec3& end,
                 double start_radius, double end_radius, int material, int part) {
  scene.solids.round_cones.push_back({to_render(start), to_render(end),
                                      static_cast<float>(start_radius),
                                      static_cast<float>(end_radius), material, part});
}

void add_sphere(render::Scene& scene, const motion::Vec3& centre, double radius, int material,
                int part) {
  scene.solids.spheres.push_back({to_render(centre), static_cast<float>(radius), material, part});
}

/// A part of the scene's last figure for each joint, with the bones that it turns. Returns the
/// first's index.
int add_parts(render::Scene& scene, const motion::Skeleton& skeleton) {
  const auto first = static_cast<int>(scene.parts.size());
  const auto figure = static_cast<int>(scene.figures.size()) - 1;
  for (const motion::Joint& joint : skeleton.joints) scene.parts.push_back({joint.name, figure});
  return first;
}

/// A dark band before the eyes, which says where the head looks.
void add_visor(render::Scene& scene, const motion::Vec3& eyes, const motion::Quat& head,
               double head_radius_m, int shade, int part) {
  const motion::Vec3 front = eyes + head * motion::Vec3(0.0, 0.0, 0.84 * head_radius_m);
  const motion::Vec3 aside = head * motion::Vec3(0.44 * head_radius_m, 0.0, 0.0);
  add_capsule(scene, front + aside, front - aside, 0.24 * head_radius_m, 0.24 * head_radius_m,
              shade, part);
}

/// Radii at a stature of 1.75 m, from the knuckle to the tip: of each joint, and of the tip.
using FingerThickness = std::array<double, motion::joints_per_finger + 1>;

constexpr FingerThickness thickness_of_thumb = {0.0125, 0.0110, 0.0098, 0.0080};
constexpr FingerThickness thickness_of_finger = {0.0108, 0.0093, 0.0084, 0.0072};
constexpr double palm_bone_radius = 0.0140;

/// The bones of the palm and of five fingers, from the wrist.
void add_hand(render::Scene& scene, const motion::Skeleton& handed,
              const motion::JointTransforms& world, bool left, int shade, double scale, int part) {
  const motion::Vec3& wrist = world.positions[left ? motion::LeftWrist : motion::RightWrist];
  for (int f = 0; f < motion::fingers_per_hand; ++f) {
    const auto finger = motion::Finger(f);
    const bool is_thumb = finger == motion::Finger::thumb;
    const FingerThickness& radii = is_thumb ? thickness_of_thumb : thickness_of_finger;
    motion::Vec3 from = wrist;
    double radius = palm_bone_radius;
    const auto add_bone_to = [&](const motion::Vec3& to, double thickness) {
      add_capsule(scene, from, to, radius * scale, thickness * scale, shade, part);
      from = to;
      radius = thickness;
    };
    for (int segment = 0; segment < motion::joints_per_finger; ++segment) {
      const auto joint = static_cast<std::size_t>(motion::body_joint_count +
                                                  motion::finger_joint(left, finger, segment));
      add_bone_to(world.positions[joint], radii[static_cast<std::size_t>(segment)]);
      if (segment + 1 < motion::joints_per_finger) continue;
      // The bone ends where its surface does.
      const motion::Vec3 tip = world.rotations[joint] * handed.joints[joint].tip.value();
      add_bone_to(from + tip - radii.back() * scale * tip.normalized(), radii.back());
    }
  }
}

void add_hands(render::Scene& scene, const motion::Skeleton& body, const motion::Pose& pose,
               const Shades& shades, double scale, int first_part) {
  const motion::Skeleton handed = motion::with_fingers(body);
  const motion::JointTransforms world =
      motion::world_transforms(handed, motion::with_fingers(pose));
  for (const BodyJoint wrist : {motion::LeftWrist, motion::RightWrist}) {
    add_hand(scene, handed, world, motion::is_left(wrist), shades.of(wrist), scale,
             first_part + wrist);
  }
}

void add_body(render::Scene& scene, const motion::Skeleton& body,
              const motion::JointTransforms& world, const Shades& shades, double scale,
              int first_part, bool has_fingers) {
  for (size_t j = 0; j < motion::body_joint_count; ++j) {
    const auto joint = BodyJoint(j);
    const Thickness own = thickness_of(joint);
    const int shade = shades.of(joint);
    const int part = first_part + static_cast<int>(j);
    if (joint != motion::Head) {
      add_sphere(scene, world.positions[j], own.joint * scale, shade, part);
    }
    if (j > 0) {
      const auto parent = static_cast<size_t>(motion::body_parents[j]);
      const Thickness from = thickness_of(BodyJoint(parent));
      // Hips and clavicles branch off the trunk: their bone takes their own side and thickness.
      const bool branches = joint == motion::LeftHip || joint == motion::RightHip ||
                            joint == motion::LeftClavicle || joint == motion::RightClavicle;
      const double far = branches ? own.joint : from.far;
      add_capsule(scene, world.positions[parent], world.positions[j],
                  (branches ? own.joint : from.joint) * scale, far * scale,
                  branches ? shade : shades.of(BodyJoint(parent)),
                  first_part + static_cast<int>(parent));
    }
    const auto& tip = body.joints[j].tip;
    if (!tip || tip->norm() < 1e-6) continue;
    if (has_fingers && (joint == motion::LeftWrist || joint == motion::RightWrist)) continue;
    const motion::Vec3 end = world.positions[j] + world.rotations[j] * *tip;
    if (joint == motion::Head) {
      const double radius = std::min(head_radius * scale, 0.6 * tip->norm());
      const motion::Vec3 up = (end - world.positions[j]).normalized();
      add_capsule(scene, world.positions[j] + up * (0.4 * radius), end - up * radius, 0.82 * radius,
                  radius, shade, part);
      add_visor(scene, end - up * (1.05 * radius), world.rotations[j], radius, shades.visor, part);
    } else {
      add_capsule(scene, world.positions[j], end, own.joint * scale, own.far * scale, shade, part);
    }
  }
}

void add_any_skeleton(render::Scene& scene, const motion::Skeleton& skeleton,
                      const motion::JointTransforms& world, int shade, double scale,
                      int first_part) {
  const double radius = plain_radius * scale;
  for (size_t j = 0; j < skeleton.joints.size(); ++j) {
    const motion::Joint& joint = skeleton.joints[j];
    const int part = first_part + static_cast<int>(j);
    add_sphere(scene, world.positions[j], 1.3 * radius, shade, part);
    if (joint.parent >= 0) {
      add_capsule(scene, world.positions[static_cast<size_t>(joint.parent)], world.positions[j],
                  radius, radius, shade, first_part + joint.parent);
    }
    if (joint.tip && joint.tip->norm() > 1e-6) {
      add_capsule(scene, world.positions[j], world.positions[j] + world.rotations[j] * *joint.tip,
                  radius, 0.8 * radius, shade, part);
    }
  }
}

}  // namespace

void add_stick_figure(render::Scene& scene, const motion::Skeleton& skeleton,
                      const motion::Pose& pose, const FigureColours& colours, double height_m) {
  const Shades shades = add_materials(scene, colours);
  const motion::JointTransforms world = motion::world_transforms(skeleton, pose);
  const double scale = height_m / drawn_stature;
  const int first_part = add_parts(scene, skeleton);
  if (motion::is_body(skeleton)) {
    const bool has_fingers = !pose.fingers.empty();
    add_body(scene, skeleton, world, shades, scale, first_part, has_fingers);
    if (has_fingers) add_hands(scene, skeleton, pose, shades, scale, first_part);
  } else {
    add_any_skeleton(scene, skeleton, world, shades.middle, scale, first_part);
  }
}

}  // namespace mien::scenes

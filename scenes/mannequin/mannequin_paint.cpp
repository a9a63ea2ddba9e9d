#include "scenes/mannequin/mannequin_paint.h"

#include <algorithm>
#include <cmath>

#include "motion/skeleton/body.h"
#include "scenes/mannequin/mannequin_landmarks.h"

namespace mien::scenes {

namespace {

using motion::Vec3;

constexpr int texture_size = 256;
constexpr float subtlety = 0.5f;  // of the difference between left and right

/// 0 below the border, 1 above it, over a narrow ramp.
float ramp(float value, float border, float width) {
  const float t = std::clamp(0.5f + (value - border) / width, 0.0f, 1.0f);
  return t * t * (3.0f - 2.0f * t);
}

render::Color mixed(const render::Color& a, const render::Color& b, float t) {
  return a + t * (b - a);
}

/// Metres at 1.75 m inside the border of the face: an upright oval on the front of the head.
double depth_in_face(const motion::Skeleton& body, const motion::JointTransforms& pose,
                     const Vec3& point) {
  const HeadShape head = head_shape(body);
  const Vec3 from_joint =
      pose.rotations[motion::Head].conjugate() * (point - pose.positions[motion::Head]);
  const Vec3 local = (from_joint - head.raise) / (head.size * motion::relative_stature(body));
  const double across = local.x() / 0.060;
  const double upward = (local.y() - 0.030) / 0.082;
  const double oval = 0.058 * (1.0 - std::sqrt(across * across + upward * upward));
  return std::min(oval, local.z() - 0.030);
}

}  // namespace

render::Texture mannequin_paint(const FigureColours& colours) {
  const render::Color left = mixed(colours.middle, colours.left, subtlety);
  const render::Color right = mixed(colours.middle, colours.right, subtlety);
  const render::Color face = mixed(colours.middle, render::Color::Constant(0.80f), 0.5f);
  render::Texture texture;
  texture.width = texture_size;
  texture.height = texture_size;
  for (int row = 0; row < texture_size; ++row) {
    const float v = (static_cast<float>(row) + 0.5f) / texture_size;
    for (int column = 0; column < texture_size; ++column) {
      const float u = (static_cast<float>(column) + 0.5f) / texture_size;
      render::Color colour = mixed(right, colours.middle, ramp(u, 0.25f, 0.06f));
      colour = mixed(colour, left, ramp(u, 0.75f, 0.06f));
      texture.texels.push_back(mixed(colour, face, ramp(v, 0.5f, 0.03f)));
    }
  }
  return texture;
}

std::array<float, 2> paint_uv(const motion::Skeleton& body, const motion::JointTransforms& pose,
                              const Vec3& point, const std::vector<Influence>& influences) {
  float side = 0.0f;
  for (const Influence& influence : influences) {
    const auto joint = motion::BodyJoint(influence.joint);
    // Collars and their flesh are the trunk's.
    if (joint == motion::LeftClavicle || joint == motion::RightClavicle) continue;
    if (motion::is_left(joint)) side += influence.weight;
    if (motion::is_right(joint)) side -= influence.weight;
  }
  const double depth = depth_in_face(body, pose, point);
  const auto u = 0.5f + 0.47f * side;
  const auto v = static_cast<float>(std::clamp(0.5 + depth / 0.12, 0.03, 0.97));
  return {u, v};
}

}  // namespace mien::scenes

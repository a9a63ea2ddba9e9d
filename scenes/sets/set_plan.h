#pragma once

#include <optional>
#include <string>
#include <vector>

#include "motion/math/geometry.h"
#include "motion/skeleton/clip.h"
#include "render/scene/scene.h"

namespace mien::scenes {

/// A large, distant, square light: over a walk of ten metres its irradiance and the softness of its
/// shadows hardly change.
struct KeyLight {
  double azimuth_degrees = -28.0;  ///< from the figure's front, positive to its right
  double elevation_degrees = 52.0;
  double distance_m = 40.0;
  double side_m = 8.5;  ///< edge length; larger lights cast softer shadows
  /// Radiance of a white floor lit by this light alone; 1 is display white.
  double strength = 0.58;
  render::Color colour{1.0f, 1.0f, 1.0f};
};

/// A side of the figure.
enum class Side { left, right, front, back };

/// An upright wall at one side of the figure. It is omitted from pictures whose camera is behind
/// the wall.
struct Wall {
  Side side = Side::left;
  double distance_m = 1.4;  ///< from the centre of the action
  double height_m = 2.6;
  double length_m = 80.0;
  render::Color albedo{0.6f, 0.6f, 0.6f};
};

/// A box with level and upright edges. x goes to the figure's left, y up, z to its front; the
/// origin is on the floor at the centre of the action.
struct Box {
  motion::Vec3 centre = motion::Vec3::Zero();  ///< metres
  motion::Vec3 size = motion::Vec3::Ones();    ///< metres
  render::Color albedo{0.6f, 0.6f, 0.6f};
};

/// The belt of a treadmill: it lies on the floor at the centre of the action and moves backwards
/// under the figure, with stripes across it.
struct Belt {
  double width_m = 0.6;
  double length_m = 2.0;
  render::Color albedo{0.1f, 0.1f, 0.1f};
  render::Color stripe_albedo{0.3f, 0.3f, 0.3f};
  double stripe_every_m = 0.25;
  double stripe_width_m = 0.02;
};

/// A stool under a figure that sits, as high as it sits (stool_under).
struct Stool {
  double width_m = 0.42;
  double depth_m = 0.42;
  render::Color albedo{0.32f, 0.3f, 0.28f};
};

/// A set as described in its file, before it is placed around an action.
struct SetPlan {
  std::string name;
  std::optional<render::Ground> ground;  ///< if absent, there is no floor and no shadow
  render::Sky sky;
  std::vector<KeyLight> lights;
  std::vector<Wall> walls;
  std::vector<Box> boxes;
  std::optional<Belt> belt;
  std::optional<Stool> stool;  ///< one for each figure
  /// Whether the figure walks in place while the lines of the ground and the belt move under it at
  /// its walking speed.
  bool in_place = false;
};

/// Placement of a set: at the centre of the action, facing in its forward direction
/// (Action::forward).
struct Place {
  motion::Vec3 centre = motion::Vec3::Zero();    ///< on the floor, metres
  motion::Vec3 forward = motion::Vec3::UnitZ();  ///< unit, horizontal

  /// World position of a point given as x (left), y (up), z (front).
  motion::Vec3 at(const motion::Vec3& point) const;
};

/// The static part of a set: ground, sky, lights, boxes, and the belt without its stripes.
render::Scene static_scene(const SetPlan& plan, const Place& place);

/// The stool of a figure as a box, in the coordinates of the place: below the mean place of its hip
/// joints, turned as the place, its top below the lowest that they come by 0.085 m of a stature of
/// 1.75 m, which is about the thickness of a thigh that lies on it. Throws Error if the hips are
/// higher than three quarters of the length of the legs on average, as those of a figure that
/// stands, or too low for a stool, and for a skeleton other than the canonical body.
Box stool_under(const Stool& stool, const motion::Clip& clip, const Place& place);

/// Adds the walls whose front faces a camera at `eye`.
void add_walls(render::Scene& scene, const SetPlan& plan, const Place& place,
               const motion::Vec3& eye);

/// Moves the ground under the figure by `way`, metres in world space: the lines of the ground, and
/// the belt, whose stripes are added. The number and order of the stripes depend only on
/// `counted_at`, a displacement close to `way`, so that the shapes of scenes with the same
/// `counted_at` correspond.
void add_moving_ground(render::Scene& scene, const SetPlan& plan, const Place& place,
                       const motion::Vec3& way, const motion::Vec3& counted_at);

/// The six faces of a box as triangles, flat, normals outwards.
render::Mesh box_mesh(const Box& box, const Place& place, int material);

}  // namespace mien::scenes

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "motion/math/geometry.h"
#include "render/scene/scene.h"

namespace mien::scenes {

/// A far, large, square light: it lights a walk of ten metres alike, and its shadows are as soft at
/// the far end as at the near one.
struct KeyLight {
  double azimuth_degrees = -28.0;  ///< from the figure's front, positive to its right
  double elevation_degrees = 52.0;
  double distance_m = 40.0;
  double side_m = 8.5;  ///< the larger, the softer the shadows
  /// What a white floor under this light alone gives back, 1 being the white of the display.
  double strength = 0.58;
  render::Color colour{1.0f, 1.0f, 1.0f};
};

/// Where something stands, seen from the figure.
enum class Side { left, right, front, back };

/// An upright wall that the figure faces with one side. It is left out of pictures whose camera
/// stands behind it.
struct Wall {
  Side side = Side::left;
  double distance_m = 1.4;  ///< from the middle of the action
  double height_m = 2.6;
  double length_m = 80.0;
  render::Color albedo{0.6f, 0.6f, 0.6f};
};

/// A box with level and upright edges. x goes to the figure's left, y up, z to its front; the
/// origin is on the floor in the middle of the action.
struct Box {
  motion::Vec3 centre = motion::Vec3::Zero();  ///< metres
  motion::Vec3 size = motion::Vec3::Ones();    ///< metres
  render::Color albedo{0.6f, 0.6f, 0.6f};
};

/// The belt of a treadmill: it lies on the floor in the middle of the action and goes backwards
/// under the figure, stripes across it.
struct Belt {
  double width_m = 0.6;
  double length_m = 2.0;
  render::Color albedo{0.1f, 0.1f, 0.1f};
  render::Color stripe_albedo{0.3f, 0.3f, 0.3f};
  double stripe_every_m = 0.25;
  double stripe_width_m = 0.02;
};

/// A set as it is written down, before it is put round an action.
struct SetPlan {
  std::string name;
  std::optional<render::Ground> ground;  ///< nothing but the backdrop without it
  render::Sky sky;
  std::vector<KeyLight> lights;
  std::vector<Wall> walls;
  std::vector<Box> boxes;
  std::optional<Belt> belt;
  /// The figure walks on the spot, and the lines of the ground and the belt go under it as fast as
  /// it would have travelled.
  bool in_place = false;
};

/// Where a set stands: round the middle of the action, turned the way the figure goes.
struct Place {
  motion::Vec3 centre = motion::Vec3::Zero();    ///< on the floor, metres
  motion::Vec3 forward = motion::Vec3::UnitZ();  ///< unit, horizontal

  /// A point of the figure's x (left), y (up), z (front) in world space.
  motion::Vec3 at(const motion::Vec3& point) const;
};

/// What stands still: ground, sky, lights, boxes.
render::Scene static_scene(const SetPlan& plan, const Place& place);

/// Adds the walls that a camera at `eye` sees from their front.
void add_walls(render::Scene& scene, const SetPlan& plan, const Place& place,
               const motion::Vec3& eye);

/// Moves what goes under the figure by `way` metres, world space: the lines of the ground, and the
/// belt, whose stripes are added. Which stripes, and in which order, depends on `counted_at` alone,
/// a way nearby.
void add_moving_ground(render::Scene& scene, const SetPlan& plan, const Place& place,
                       const motion::Vec3& way, const motion::Vec3& counted_at);

/// The six faces of a box as triangles, flat, normals outwards.
render::Mesh box_mesh(const Box& box, const Place& place, int material);

}  // namespace mien::scenes

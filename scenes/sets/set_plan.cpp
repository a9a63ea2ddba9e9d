#include "scenes/sets/set_plan.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "motion/error.h"
#include "motion/skeleton/body.h"
#include "motion/skeleton/pose.h"

namespace mien::scenes {

namespace {

using motion::radians_per_degree;
using motion::Vec3;

constexpr double wall_thickness_m = 0.1;
constexpr double belt_height_m = 0.004;
constexpr double stripe_height_m = 0.001;  // above the belt

render::AreaLight area_light(const KeyLight& key, const Place& place) {
  const double azimuth = key.azimuth_degrees * radians_per_degree;
  const double elevation = key.elevation_degrees * radians_per_degree;
  const Vec3 right = place.forward.cross(Vec3::UnitY());
  const Vec3 level = std::cos(azimuth) * place.forward + std::sin(azimuth) * right;
  const Vec3 towards = std::cos(elevation) * level + std::sin(elevation) * Vec3::UnitY();
  const Vec3 position = place.centre + key.distance_m * towards;
  // A small source seen face on from afar: irradiance = radiance · solid angle · cosine at the
  // floor.
  const double solid_angle = key.side_m * key.side_m / (key.distance_m * key.distance_m);
  const double irradiance = key.strength * motion::pi;
  const auto radiance = static_cast<float>(irradiance / (solid_angle * std::sin(elevation)));
  const auto side = static_cast<float>(key.side_m);
  return render::softbox(position.cast<float>(), place.centre.cast<float>(), side, side,
                         radiance * key.colour);
}

int add_material(render::Scene& scene, const render::Color& albedo) {
  scene.materials.push_back({.albedo = albedo});
  return static_cast<int>(scene.materials.size()) - 1;
}

/// From the middle of the action to the wall's side, in the figure's axes.
Vec3 direction_of(Side side) {
  switch (side) {
    case Side::left:
      return Vec3::UnitX();
    case Side::right:
      return -Vec3::UnitX();
    case Side::front:
      return Vec3::UnitZ();
    default:
      return -Vec3::UnitZ();
  }
}

Box box_of(const Wall& wall) {
  const Vec3 out = direction_of(wall.side);
  const Vec3 along = Vec3::UnitY().cross(out).cwiseAbs();
  Box box;
  box.centre = (wall.distance_m + 0.5 * wall_thickness_m) * out;
  box.centre.y() = 0.5 * wall.height_m;
  box.size = wall_thickness_m * out.cwiseAbs() + wall.length_m * along;
  box.size.y() = wall.height_m;
  box.albedo = wall.albedo;
  return box;
}

bool is_before(const Wall& wall, const Place& place, const Vec3& eye) {
  const Vec3 out = place.at(direction_of(wall.side)) - place.centre;
  return (eye - place.centre).dot(out) < wall.distance_m;
}

void add_box(render::Scene& scene, render::Solids& solids, const Box& box, const Place& place) {
  solids.meshes.push_back(box_mesh(box, place, add_material(scene, box.albedo)));
}

/// Stripes across the belt, `way` metres forward of where they are at first, cut at its ends: those
/// that are on it when the way is `counted_at`, and one more at either end.
std::vector<Box> stripes_of(const Belt& belt, double way, double counted_at) {
  std::vector<Box> stripes;
  const double end = 0.5 * belt.length_m;
  const double first = std::floor((-end - counted_at) / belt.stripe_every_m);
  const int count = 3 + static_cast<int>(belt.length_m / belt.stripe_every_m);
  for (int n = 0; n < count; ++n) {
    const double middle = (first + n) * belt.stripe_every_m + way;
    const double from = std::clamp(middle - 0.5 * belt.stripe_width_m, -end, end);
    const double to = std::clamp(middle + 0.5 * belt.stripe_width_m, -end, end);
    // One beyond an end is there too, as a mere point: there are as many at all times.
    const bool is_seen = to - from > 1e-4;
    const Vec3 size(belt.width_m, 2.0 * stripe_height_m, to - from);
    stripes.push_back({Vec3(0.0, belt_height_m, 0.5 * (from + to)), is_seen ? size : Vec3::Zero(),
                       belt.stripe_albedo});
  }
  return stripes;
}

}  // namespace

render::Mesh box_mesh(const Box& box, const Place& place, int material) {
  render::Mesh mesh;
  mesh.material = material;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      const motion::Vec3 normal = side * motion::Vec3::Unit(axis);
      const motion::Vec3 u = motion::Vec3::Unit((axis + 1) % 3);
      const motion::Vec3 v = normal.cross(u);
      const auto first = static_cast<int>(mesh.positions.size());
      for (const auto& [a, b] : {std::pair{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}}) {
        const motion::Vec3 corner = normal + a * u + b * v;
        const motion::Vec3 point = box.centre + 0.5 * box.size.cwiseProduct(corner);
        mesh.positions.push_back(place.at(point).cast<float>());
        mesh.normals.push_back((place.at(normal) - place.centre).cast<float>());
      }
      mesh.triangles.push_back({first, first + 1, first + 2});
      mesh.triangles.push_back({first, first + 2, first + 3});
    }
  }
  return mesh;
}

Vec3 Place::at(const Vec3& point) const {
  const Vec3 left = Vec3::UnitY().cross(forward);
  return centre + point.x() * left + point.y() * Vec3::UnitY() + point.z() * forward;
}

render::Scene static_scene(const SetPlan& plan, const Place& place) {
  render::Scene scene;
  for (const KeyLight& light : plan.lights) scene.lights.push_back(area_light(light, place));
  scene.sky = plan.sky;
  scene.has_ground = plan.ground.has_value();
  if (plan.ground) scene.ground = *plan.ground;
  for (const Box& box : plan.boxes) add_box(scene, scene.static_solids, box, place);
  if (plan.belt) {
    const Vec3 size(plan.belt->width_m, belt_height_m, plan.belt->length_m);
    const Vec3 centre(0.0, 0.5 * belt_height_m, 0.0);
    add_box(scene, scene.static_solids, {centre, size, plan.belt->albedo}, place);
  }
  return scene;
}

Box stool_under(const Stool& stool, const motion::Clip& clip, const Place& place) {
  constexpr double thigh_m = 0.085;
  constexpr double least_m = 0.05;
  constexpr double highest_share = 0.75;
  if (!motion::is_body(clip.body))
    throw Error("a stool needs a figure of the canonical body", "use a set without a stool");
  Vec3 mean = Vec3::Zero();
  double lowest = std::numeric_limits<double>::infinity();
  for (const motion::Pose& pose : clip.poses) {
    const std::vector<Vec3> at = motion::world_positions(clip.body, pose);
    const Vec3 hips = 0.5 * (at[motion::LeftHip] + at[motion::RightHip]);
    mean += hips / static_cast<double>(clip.poses.size());
    lowest = std::min(lowest, hips.y());
  }
  const double height = lowest - thigh_m * motion::relative_stature(clip.body);
  if (mean.y() > highest_share * motion::leg_length(clip.body) || height < least_m)
    throw Error("there is a stool in the set, but the figure does not sit",
                "use a set without a stool");
  const Vec3 across = Vec3::UnitY().cross(place.forward);
  const Vec3 from_centre = mean - place.centre;
  return {{from_centre.dot(across), 0.5 * height, from_centre.dot(place.forward)},
          {stool.width_m, height, stool.depth_m},
          stool.albedo};
}

void add_walls(render::Scene& scene, const SetPlan& plan, const Place& place, const Vec3& eye) {
  for (const Wall& wall : plan.walls) {
    if (is_before(wall, place, eye)) add_box(scene, scene.static_solids, box_of(wall), place);
  }
}

void add_moving_ground(render::Scene& scene, const SetPlan& plan, const Place& place,
                       const Vec3& way, const Vec3& counted_at) {
  if (plan.ground) {
    scene.ground.offset_x = static_cast<float>(way.x());
    scene.ground.offset_z = static_cast<float>(way.z());
  }
  if (!plan.belt) return;
  for (const Box& stripe :
       stripes_of(*plan.belt, way.dot(place.forward), counted_at.dot(place.forward))) {
    add_box(scene, scene.solids, stripe, place);
  }
}

}  // namespace mien::scenes

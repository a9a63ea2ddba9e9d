#include "scenes/mannequin/mannequin.h"

#include <algorithm>
#include <vector>

#include "scenes/mannequin/largest_component.h"
#include "scenes/mannequin/mannequin_paint.h"
#include "scenes/mannequin/mannequin_weights.h"
#include "scenes/mannequin/surface_nets.h"
#include "scenes/skinning/skinned_glb.h"

namespace mien::scenes {

namespace {

using motion::Vec3;

/// Cells are small where the shape is: head, hands and feet; long along the limbs.
struct Spacing {
  double across = 0.0145;  ///< metres at 1.75 m
  double along = 0.0240;
  double hands = 0.0130;
  double fine = 0.0105;
};

/// Planes from `low` to `high`, `step(coordinate)` apart.
template <typename Step>
std::vector<double> planes(double low, double high, const Step& step) {
  std::vector<double> result = {low};
  while (result.back() < high) result.push_back(result.back() + step(result.back()));
  return result;
}

/// The same on both sides of 0, where one plane lies half a step off so that none cuts the middle.
template <typename Step>
std::vector<double> mirrored_planes(double high, const Step& step) {
  std::vector<double> result;
  for (double x = 0.5 * step(0.0); x < high; x += step(x)) {
    result.push_back(x);
    result.insert(result.begin(), -x);
  }
  return result;
}

/// The box that holds all flesh.
Eigen::AlignedBox3d box_of(const Flesh& flesh) {
  Eigen::AlignedBox3d box;
  for (const auto* part :
       {&flesh.trunk, &flesh.left_arm, &flesh.right_arm, &flesh.left_leg, &flesh.right_leg}) {
    for (const SdfPrimitive& primitive : *part) {
      const bool is_cone = primitive.shape == SdfPrimitive::Shape::round_cone;
      const double radius = is_cone ? std::max(primitive.start_radius, primitive.end_radius)
                                    : primitive.radii.maxCoeff();
      box.extend(primitive.start + Vec3::Constant(radius));
      box.extend(primitive.start - Vec3::Constant(radius));
      if (!is_cone) continue;
      box.extend(primitive.end + Vec3::Constant(radius));
      box.extend(primitive.end - Vec3::Constant(radius));
    }
  }
  return box;
}

Grid grid_for(const Flesh& flesh, const motion::JointTransforms& bind, double scale) {
  const Spacing spacing;
  Eigen::AlignedBox3d box = box_of(flesh);
  const double air = 0.04 * scale;
  const double widest = std::max(box.max().x(), -box.min().x()) + air;
  const double chin = bind.positions[motion::Head].y() - 0.08 * scale;
  const double palm = bind.positions[motion::LeftWrist].y() + 0.03 * scale;
  const double fingertips = palm - 0.20 * scale;
  const double instep = bind.positions[motion::LeftAnkle].y() + 0.03 * scale;
  Grid grid;
  grid.x = mirrored_planes(
      widest, [&](double x) { return scale * (x < 0.12 * scale ? spacing.fine : spacing.across); });
  grid.y = planes(box.min().y() - air, box.max().y() + air, [&](double y) {
    if (y > chin || y < instep) return scale * spacing.fine;
    return scale * (y > fingertips && y < palm ? spacing.hands : spacing.along);
  });
  grid.z = planes(box.min().z() - air, box.max().z() + air,
                  [&](double) { return scale * spacing.across; });
  return grid;
}

/// The joint that most moves the triangle's first vertex.
int part_of(const SkinnedMesh& mesh, const std::array<int, 3>& triangle) {
  return mesh.influences[static_cast<size_t>(triangle[0])].front().joint;
}

}  // namespace

std::string to_glb(const Mannequin& mannequin, const motion::Skeleton& body) {
  const std::vector<SkinnedMesh> meshes = {mannequin.mesh};
  const std::vector<render::Material> materials = {mannequin_skin(0)};
  SkinnedFigure figure{.bind = mannequin.bind,
                       .meshes = meshes,
                       .materials = materials,
                       .textures = {&mannequin.paint}};
  for (const motion::Joint& joint : body.joints) {
    figure.body_joints.push_back(static_cast<int>(figure.joints.size()));
    figure.joints.push_back(joint.name);
  }
  return skinned_glb(figure);
}

Mannequin make_mannequin(const motion::Skeleton& body, const MannequinOptions& options,
                         const FigureColours& colours) {
  const double scale = motion::relative_stature(body);
  Mannequin mannequin;
  mannequin.bind = motion::world_transforms(body, modelling_pose(body));
  const Flesh flesh = flesh_of(body, mannequin.bind, options);
  Surface surface = largest_component(
      surface_nets([&](const Vec3& point) { return signed_distance(flesh, point); },
                   grid_for(flesh, mannequin.bind, scale)));
  SkinnedMesh& mesh = mannequin.mesh;
  mesh.positions = std::move(surface.positions);
  mesh.normals = std::move(surface.normals);
  mesh.triangles = std::move(surface.triangles);
  mesh.influences.reserve(mesh.positions.size());
  for (const Vec3& point : mesh.positions) {
    mesh.influences.push_back(mannequin_weights(body, mannequin.bind, flesh, point));
  }
  for (const auto& triangle : mesh.triangles)
    mesh.triangle_parts.push_back(part_of(mesh, triangle));
  for (size_t v = 0; v < mesh.positions.size(); ++v) {
    mesh.uv.push_back(paint_uv(body, mannequin.bind, mesh.positions[v], mesh.influences[v]));
  }
  mannequin.paint = mannequin_paint(colours);
  return mannequin;
}

render::Material mannequin_skin(int texture) {
  render::Material skin{render::Color::Ones(), 0.03f, 0.5f};
  skin.texture = texture;
  return skin;
}

render::Mesh posed(const Mannequin& mannequin, const motion::Skeleton& body,
                   const motion::Pose& pose) {
  return dual_quaternion_skinned(
      mannequin.mesh, joint_motions(mannequin.bind, motion::world_transforms(body, pose)));
}

void add_mannequin(render::Scene& scene, const Mannequin& mannequin, const motion::Skeleton& body,
                   const motion::Pose& pose) {
  render::Mesh mesh = posed(mannequin, body, pose);
  mesh.material = static_cast<int>(scene.materials.size());
  scene.materials.push_back(mannequin_skin(static_cast<int>(scene.textures.size())));
  scene.textures.push_back(&mannequin.paint);
  const auto first_part = static_cast<int>(scene.parts.size());
  for (int& part : mesh.triangle_parts) part += first_part;
  const auto figure = static_cast<int>(scene.figures.size()) - 1;
  for (const motion::Joint& joint : body.joints) scene.parts.push_back({joint.name, figure});
  scene.solids.meshes.push_back(std::move(mesh));
}

}  // namespace mien::scenes

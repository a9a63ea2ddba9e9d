#include "scenes/mannequin/mannequin.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "motion/skeleton/hand.h"
#include "scenes/mannequin/hand_surface.h"
#include "scenes/mannequin/mannequin_hand.h"
#include "scenes/mannequin/mannequin_landmarks.h"
#include "scenes/mannequin/mannequin_weights.h"
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

constexpr Spacing draft_spacing{.across = 0.02, .along = 0.033, .hands = 0.015, .fine = 0.014};

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

Grid grid_for(const Flesh& flesh, const motion::JointTransforms& bind, double scale,
              const Spacing& spacing) {
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

/// The joint that most moves the triangle's first vertex; fingers are part of their wrist.
int part_of(const SkinnedMesh& mesh, const std::array<int, 3>& triangle) {
  return body_joint_at(mesh.influences[static_cast<size_t>(triangle[0])].front().joint);
}

void append(Surface& surface, const Surface& more) {
  const auto first = static_cast<int>(surface.positions.size());
  surface.positions.insert(surface.positions.end(), more.positions.begin(), more.positions.end());
  surface.normals.insert(surface.normals.end(), more.normals.begin(), more.normals.end());
  for (const auto& [a, b, c] : more.triangles)
    surface.triangles.push_back({a + first, b + first, c + first});
}

constexpr HandCells draft_hand_cells{.along = 0.0068, .across = 0.0036, .through = 0.0042};

/// The body, and its hands if they have fingers.
Surface surface_of(const Flesh& flesh, const motion::Skeleton& body,
                   const motion::JointTransforms& bind, MeshDetail detail) {
  const bool is_draft = detail == MeshDetail::draft;
  const Grid grid =
      grid_for(flesh, bind, motion::relative_stature(body), is_draft ? draft_spacing : Spacing());
  if (!includes_fingers(bind)) {
    return largest_component(
        surface_nets([&](const Vec3& point) { return signed_distance(flesh, point); }, grid));
  }
  const double scale = hand_scale(body);
  Surface surface = largest_component(surface_nets(without_hands(flesh, bind, scale), grid));
  for (const bool left : {true, false}) {
    append(surface, largest_component(hand_surface(flesh, bind, left, scale,
                                                   is_draft ? draft_hand_cells : HandCells())));
  }
  smooth_seams(surface, flesh, bind, scale);
  return surface;
}

/// The joints of a mannequin whose bind pose this is, in a pose of its body.
motion::JointTransforms joints_in(const motion::JointTransforms& bind, const motion::Skeleton& body,
                                  const motion::Pose& pose) {
  if (!includes_fingers(bind)) return motion::world_transforms(body, pose);
  return motion::world_transforms(motion::with_fingers(body), motion::with_fingers(pose));
}

/// The bind pose of a mannequin, joint by joint.
motion::JointTransforms bind_of(const motion::Skeleton& body, MannequinHands hands) {
  motion::Pose pose = modelling_pose(body);
  if (hands == MannequinHands::one_piece) return motion::world_transforms(body, pose);
  pose.fingers = modelling_fingers();
  return motion::world_transforms(motion::with_fingers(body), motion::with_fingers(pose));
}

/// Vertices that triangles connect.
struct Pieces {
  std::vector<int> above;

  explicit Pieces(size_t count) : above(count) { std::iota(above.begin(), above.end(), 0); }

  int of(int vertex) {
    while (up(vertex) != vertex) vertex = up(vertex) = up(up(vertex));
    return vertex;
  }

  void join(int a, int b) { up(of(a)) = of(b); }

  int& up(int vertex) { return above[static_cast<size_t>(vertex)]; }
};

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

std::string to_glb(const Mannequin& mannequin, const motion::Skeleton& body) {
  const std::vector<SkinnedMesh> meshes = {mannequin.mesh};
  const std::vector<render::Material> materials = {mannequin_skin(0)};
  SkinnedFigure figure{.bind = mannequin.bind,
                       .meshes = meshes,
                       .materials = materials,
                       .textures = {&mannequin.paint}};
  const motion::Skeleton joints =
      includes_fingers(mannequin.bind) ? motion::with_fingers(body) : body;
  for (const motion::Joint& joint : joints.joints) {
    figure.body_joints.push_back(body_joint_at(static_cast<int>(figure.joints.size())));
    figure.joints.push_back(joint.name);
  }
  return skinned_glb(figure);
}

Mannequin make_mannequin(const motion::Skeleton& body, const MannequinOptions& options,
                         const FigureColours& colours, MeshDetail detail, MannequinHands hands) {
  Mannequin mannequin;
  mannequin.bind = bind_of(body, hands);
  const Flesh flesh = flesh_of(body, mannequin.bind, options);
  Surface surface = surface_of(flesh, body, mannequin.bind, detail);
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
  cluster_triangles(mesh);
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
      mannequin.mesh, joint_motions(mannequin.bind, joints_in(mannequin.bind, body, pose)));
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

Surface largest_component(Surface surface) {
  const size_t count = surface.positions.size();
  Pieces pieces(count);
  for (const auto& [a, b, c] : surface.triangles) {
    pieces.join(a, b);
    pieces.join(b, c);
  }
  std::vector<int> sizes(count, 0);
  for (size_t v = 0; v < count; ++v) ++sizes[static_cast<size_t>(pieces.of(static_cast<int>(v)))];
  const auto largest = std::max_element(sizes.begin(), sizes.end());
  if (largest == sizes.end() || static_cast<size_t>(*largest) == count) return surface;
  const auto kept = static_cast<int>(largest - sizes.begin());
  Surface result;
  std::vector<int> place(count, -1);
  for (size_t v = 0; v < count; ++v) {
    if (pieces.of(static_cast<int>(v)) != kept) continue;
    place[v] = static_cast<int>(result.positions.size());
    result.positions.push_back(surface.positions[v]);
    result.normals.push_back(surface.normals[v]);
  }
  for (std::array<int, 3> triangle : surface.triangles) {
    for (int& vertex : triangle) vertex = place[static_cast<size_t>(vertex)];
    if (triangle[0] >= 0) result.triangles.push_back(triangle);
  }
  return result;
}

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
    const motion::BodyJoint joint = body_joint_at(influence.joint);
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

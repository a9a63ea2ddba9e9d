#include "motion/formats/fbx/fbx_mesh.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>

#include "motion/formats/fbx/fbx_layer.h"
#include "motion/formats/fbx/fbx_numbers.h"
#include "motion/formats/fbx/fbx_values.h"
#include "motion/text/excerpt.h"

namespace mien::motion {

namespace {

/// What is built, and where in the file it is.
struct MeshSource {
  const FbxScene& scene;
  std::uint32_t node = 0;  ///< that holds vertices and layers
  size_t* left = nullptr;  ///< numbers that may still be read
  std::vector<int> polygon_of_corner{};
  std::vector<int> polygon_of_triangle{};
};

constexpr size_t most_uv_sets = 8;

std::vector<std::array<float, 3>> in_threes(const std::vector<float>& numbers) {
  std::vector<std::array<float, 3>> threes(numbers.size() / 3);
  for (size_t i = 0; i < threes.size(); ++i) {
    threes[i] = {numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]};
  }
  return threes;
}

std::vector<std::array<float, 2>> in_pairs(const std::vector<float>& numbers) {
  std::vector<std::array<float, 2>> pairs(numbers.size() / 2);
  for (size_t i = 0; i < pairs.size(); ++i) pairs[i] = {numbers[2 * i], numbers[2 * i + 1]};
  return pairs;
}

std::vector<double> numbers_below(const FbxDocument& document, std::uint32_t node,
                                  std::string_view name) {
  const std::uint32_t child = find_child(document, node, name);
  return child == 0 ? std::vector<double>() : doubles_of(document, child);
}

std::vector<std::int64_t> indices_below(const FbxDocument& document, std::uint32_t node,
                                        std::string_view name) {
  const std::uint32_t child = find_child(document, node, name);
  return child == 0 ? std::vector<std::int64_t>() : integers_of(document, child);
}

/// Meshes and clusters may be used by many models, which is bounded.
void count(const FbxScene& scene, std::uint32_t node, size_t numbers, size_t& left) {
  if (numbers > left) refuse_fbx(scene.document, node, "the meshes of all models are too large");
  left -= numbers;
}

void parse_positions(const MeshSource& source, FbxMesh& mesh) {
  const FbxDocument& document = source.scene.document;
  const std::vector<double> numbers = numbers_below(document, source.node, "Vertices");
  if (numbers.size() % 3 != 0) {
    refuse_fbx(document, source.node, "the number of coordinates is not a multiple of 3");
  }
  mesh.positions.resize(numbers.size() / 3);
  for (size_t v = 0; v < mesh.positions.size(); ++v) {
    mesh.positions[v] = {numbers[3 * v], numbers[3 * v + 1], numbers[3 * v + 2]};
    if (!(mesh.positions[v].cwiseAbs().maxCoeff() < 1e12)) {
      refuse_fbx(document, source.node, "a coordinate is too large");
    }
  }
}

/// The corner of a polygon from which triangles fan out without covering what is outside of it, as
/// far as it is small; else the first one. A polygon with one dent has such a corner, as any of
/// four corners has.
size_t fan_corner(const FbxMesh& mesh, size_t first, size_t size) {
  constexpr size_t most_compared = 16;
  if (size < 4 || size > most_compared) return 0;
  const auto at = [&](size_t i) -> const Vec3& {
    return mesh.positions[static_cast<size_t>(mesh.corners[first + i % size])];
  };
  const auto area = [&](size_t a, size_t b, size_t c) -> Vec3 {
    return (at(b) - at(a)).cross(at(c) - at(a));
  };
  Vec3 whole = Vec3::Zero();
  for (size_t i = 1; i + 1 < size; ++i) whole += area(0, i, i + 1);
  for (size_t start = 0; start < size; ++start) {
    bool is_inside = true;
    for (size_t i = 1; i + 1 < size; ++i) {
      is_inside &= area(start, start + i, start + i + 1).dot(whole) >= 0.0;
    }
    if (is_inside) return start;
  }
  return 0;
}

void add_triangles(MeshSource& source, size_t first, int polygon, FbxMesh& mesh) {
  const size_t size = mesh.corners.size() - first;
  const size_t start = fan_corner(mesh, first, size);
  const auto corner = [&](size_t i) { return static_cast<int>(first + (start + i) % size); };
  for (size_t i = 1; i + 1 < size; ++i) {
    mesh.triangles.push_back({corner(0), corner(i), corner(i + 1)});
    source.polygon_of_triangle.push_back(polygon);
  }
}

/// Polygons are lists of vertices; the last one of each is stored as −index − 1.
void parse_polygons(MeshSource& source, FbxMesh& mesh) {
  const FbxDocument& document = source.scene.document;
  size_t first = 0;
  int polygon = 0;
  for (const std::int64_t stored : indices_below(document, source.node, "PolygonVertexIndex")) {
    const std::int64_t vertex = stored < 0 ? -(stored + 1) : stored;
    if (vertex >= static_cast<std::int64_t>(mesh.positions.size())) {
      refuse_fbx(document, source.node, "a polygon has a vertex that does not exist");
    }
    mesh.corners.push_back(static_cast<int>(vertex));
    source.polygon_of_corner.push_back(polygon);
    if (stored >= 0) continue;
    add_triangles(source, first, polygon, mesh);
    first = mesh.corners.size();
    ++polygon;
  }
  if (first < mesh.corners.size()) add_triangles(source, first, polygon, mesh);
}

void parse_layers(const MeshSource& source, FbxMesh& mesh) {
  const FbxDocument& document = source.scene.document;
  const FbxCorners corners{mesh.corners, source.polygon_of_corner};
  for (std::uint32_t layer = first_child(source.node); layer < document.nodes[source.node].end;
       layer = document.nodes[layer].end) {
    const std::string_view name = document.nodes[layer].name;
    mesh.has_colours |= name == "LayerElementColor";
    if (name == "LayerElementNormal" && mesh.normals.empty()) {
      mesh.normals = in_threes(layer_values(document, layer, corners, normal_layer));
    }
    if (name != "LayerElementUV" || mesh.uv_sets.size() == most_uv_sets) continue;
    count(source.scene, layer, mesh.corners.size(), *source.left);
    const std::uint32_t own_name = find_child(document, layer, "Name");
    FbxUvSet set{own_name == 0 ? "" : decoded(document, text_of(document, own_name, 0)),
                 in_pairs(layer_values(document, layer, corners, uv_layer))};
    if (!set.uv.empty()) mesh.uv_sets.push_back(std::move(set));
  }
}

void parse_materials(const MeshSource& source, FbxMesh& mesh) {
  const FbxScene& scene = source.scene;
  const int model_object = scene.models[static_cast<size_t>(mesh.model)].object;
  for (const int c : scene.objects.to[static_cast<size_t>(model_object)]) {
    const int child = scene.objects.connections[static_cast<size_t>(c)].child;
    if (scene.objects.objects[static_cast<size_t>(child)].kind == "Material") {
      mesh.materials.push_back(child);
    }
  }
  if (mesh.materials.empty()) return;
  mesh.triangle_materials.assign(mesh.triangles.size(), 0);
  const std::uint32_t layer = find_child(scene.document, source.node, "LayerElementMaterial");
  if (layer == 0) return;
  const std::vector<std::int64_t> indices = material_indices(scene.document, layer);
  for (size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto polygon = static_cast<size_t>(source.polygon_of_triangle[t]);
    const std::int64_t index = polygon < indices.size() ? indices[polygon] : 0;
    if (index > 0 && index < static_cast<std::int64_t>(mesh.materials.size())) {
      mesh.triangle_materials[t] = static_cast<int>(index);
    }
  }
}

/// A matrix of 16 numbers, column by column.
Eigen::Affine3d matrix_below(const FbxDocument& document, std::uint32_t node,
                             std::string_view name) {
  const std::vector<double> numbers = numbers_below(document, node, name);
  if (numbers.size() != 16) {
    refuse_fbx(document, node, "a bone of a skin has no matrix " + in_quotes(name));
  }
  Eigen::Affine3d matrix = Eigen::Affine3d::Identity();
  matrix.matrix().topRows<3>() = Eigen::Map<const Eigen::Matrix4d>(numbers.data()).topRows<3>();
  return matrix;
}

FbxCluster parse_cluster(const FbxScene& scene, std::uint32_t node, int bone, size_t vertices) {
  const FbxDocument& document = scene.document;
  FbxCluster cluster;
  cluster.model = bone;
  cluster.to_bone = matrix_below(document, node, "Transform");
  if (find_child(document, node, "TransformLink") != 0) {
    cluster.bind = matrix_below(document, node, "TransformLink");
  }
  const std::vector<std::int64_t> indices = indices_below(document, node, "Indexes");
  const std::vector<double> weights = numbers_below(document, node, "Weights");
  if (indices.size() != weights.size()) {
    refuse_fbx(document, node,
               "a bone of a skin has " + std::to_string(indices.size()) + " vertices, but " +
                   std::to_string(weights.size()) + " weights");
  }
  for (size_t i = 0; i < indices.size(); ++i) {
    if (indices[i] < 0 || indices[i] >= static_cast<std::int64_t>(vertices)) {
      refuse_fbx(document, node, "a bone of a skin moves a vertex that does not exist");
    }
    cluster.vertices.push_back(static_cast<int>(indices[i]));
    cluster.weights.push_back(static_cast<float>(weights[i]));
  }
  return cluster;
}

/// The clusters of the skin that deforms an object: a geometry, or in old files a model.
void parse_skin(const FbxScene& scene, const std::vector<int>& model_of, int object, FbxMesh& mesh,
                size_t& left) {
  const FbxObjects& objects = scene.objects;
  for (const int s : objects.to[static_cast<size_t>(object)]) {
    const int skin = objects.connections[static_cast<size_t>(s)].child;
    if (objects.objects[static_cast<size_t>(skin)].sub_kind != "Skin") continue;
    for (const int c : objects.to[static_cast<size_t>(skin)]) {
      const int cluster = objects.connections[static_cast<size_t>(c)].child;
      for (const int b : objects.to[static_cast<size_t>(cluster)]) {
        const int bone =
            model_of[static_cast<size_t>(objects.connections[static_cast<size_t>(b)].child)];
        if (bone < 0) continue;
        mesh.clusters.push_back(parse_cluster(scene,
                                              objects.objects[static_cast<size_t>(cluster)].node,
                                              bone, mesh.positions.size()));
        count(scene, objects.objects[static_cast<size_t>(cluster)].node,
              mesh.clusters.back().vertices.size() + 1, left);
        break;
      }
    }
    return;
  }
}

bool is_visible(const FbxScene& scene, int model_object) {
  const std::uint32_t node = scene.objects.objects[static_cast<size_t>(model_object)].node;
  for (const FbxProperty& property : properties_of(scene.document, node)) {
    const bool is_hidden =
        property.name == "Visibility" && property.count > 0 && !(property.numbers[0] > 0.0);
    if (is_hidden) return false;
  }
  return true;
}

bool has_blend_shapes(const FbxScene& scene, int object) {
  const std::vector<int>& to = scene.objects.to[static_cast<size_t>(object)];
  return std::ranges::any_of(to, [&](int c) {
    const int child = scene.objects.connections[static_cast<size_t>(c)].child;
    return scene.objects.objects[static_cast<size_t>(child)].sub_kind == "BlendShape";
  });
}

Eigen::Affine3d geometric_transform(const FbxModel& model) {
  Eigen::Affine3d transform = Eigen::Affine3d::Identity();
  transform.linear() = rotation_of_angles(model.geometric_rotation, 0).toRotationMatrix() *
                       model.geometric_scaling.asDiagonal();
  transform.translation() = model.geometric_translation;
  return transform;
}

}  // namespace

std::vector<FbxMesh> fbx_meshes(const FbxScene& scene) {
  std::vector<int> model_of(scene.objects.objects.size(), -1);
  for (size_t m = 0; m < scene.models.size(); ++m) {
    model_of[static_cast<size_t>(scene.models[m].object)] = static_cast<int>(m);
  }
  std::vector<FbxMesh> meshes;
  size_t left = size_t{1} << 26;
  const auto add = [&](int model, int object) {
    const FbxObject& holder = scene.objects.objects[static_cast<size_t>(object)];
    if (find_child(scene.document, holder.node, "Vertices") == 0) return;
    MeshSource source{scene, holder.node, &left};
    FbxMesh mesh;
    mesh.model = model;
    mesh.name = scene.models[static_cast<size_t>(model)].name;
    mesh.geometric = geometric_transform(scene.models[static_cast<size_t>(model)]);
    parse_positions(source, mesh);
    parse_polygons(source, mesh);
    count(scene, holder.node, mesh.positions.size() + mesh.corners.size() + 1, left);
    parse_layers(source, mesh);
    parse_materials(source, mesh);
    mesh.is_visible = is_visible(scene, scene.models[static_cast<size_t>(model)].object);
    mesh.has_blend_shapes = has_blend_shapes(scene, object);
    parse_skin(scene, model_of, object, mesh, left);
    meshes.push_back(std::move(mesh));
  };
  for (const int m : scene.parents_first) {
    const int object = scene.models[static_cast<size_t>(m)].object;
    add(m, object);
    for (const int c : scene.objects.to[static_cast<size_t>(object)]) {
      const int child = scene.objects.connections[static_cast<size_t>(c)].child;
      if (scene.objects.objects[static_cast<size_t>(child)].kind == "Geometry") add(m, child);
    }
  }
  return meshes;
}

std::vector<Vec3> posed_vertices(const FbxMesh& mesh, const std::vector<FbxPlace>& places) {
  std::vector<Vec3> sums(mesh.positions.size(), Vec3::Zero());
  std::vector<double> weights(mesh.positions.size(), 0.0);
  for (const FbxCluster& cluster : mesh.clusters) {
    const FbxPlace& bone = places[static_cast<size_t>(cluster.model)];
    const Eigen::Affine3d transform = cluster.to_bone * mesh.geometric;
    for (size_t i = 0; i < cluster.vertices.size(); ++i) {
      const auto v = static_cast<size_t>(cluster.vertices[i]);
      const double weight = cluster.weights[i];
      sums[v] += weight * (bone.position + bone.linear * (transform * mesh.positions[v]));
      weights[v] += weight;
    }
  }
  const FbxPlace& model = places[static_cast<size_t>(mesh.model)];
  for (size_t v = 0; v < sums.size(); ++v) {
    if (weights[v] > 0.0) {
      sums[v] /= weights[v];
    } else {
      sums[v] = model.position + model.linear * (mesh.geometric * mesh.positions[v]);
    }
  }
  return sums;
}

}  // namespace mien::motion

#include "motion/formats/fbx/fbx_mesh.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>

#include "motion/formats/fbx/fbx_values.h"
#include "motion/text/excerpt.h"

namespace mien::motion {

namespace {

/// How the values of a layer belong to the parts of a mesh.
enum class Mapping { none, by_corner, by_vertex, by_polygon, all_same };

Mapping mapping_of(const FbxDocument& document, std::uint32_t layer) {
  const std::uint32_t node = find_child(document, layer, "MappingInformationType");
  const std::string_view name = node == 0 ? std::string_view() : text_of(document, node, 0);
  if (name == "ByPolygonVertex") return Mapping::by_corner;
  if (name == "ByVertice" || name == "ByVertex" || name == "ByControlPoint") {
    return Mapping::by_vertex;
  }
  if (name == "ByPolygon") return Mapping::by_polygon;
  return name == "AllSame" ? Mapping::all_same : Mapping::none;
}

/// What is built, and where in the file it is.
struct MeshSource {
  const FbxScene& scene;
  std::uint32_t node = 0;  ///< that holds vertices and layers
  std::vector<int> polygon_of_corner{};
  std::vector<int> polygon_of_triangle{};
};

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

/// Polygons are lists of vertices; the last one of each is stored as −index − 1.
void parse_polygons(MeshSource& source, FbxMesh& mesh) {
  const FbxDocument& document = source.scene.document;
  int first = 0;
  int polygon = 0;
  for (const std::int64_t stored : indices_below(document, source.node, "PolygonVertexIndex")) {
    const std::int64_t vertex = stored < 0 ? -(stored + 1) : stored;
    if (vertex >= static_cast<std::int64_t>(mesh.positions.size())) {
      refuse_fbx(document, source.node, "a polygon has a vertex that does not exist");
    }
    const int corner = static_cast<int>(mesh.corners.size());
    mesh.corners.push_back(static_cast<int>(vertex));
    source.polygon_of_corner.push_back(polygon);
    if (corner - first >= 2) {
      mesh.triangles.push_back({first, corner - 1, corner});
      source.polygon_of_triangle.push_back(polygon);
    }
    if (stored >= 0) continue;
    first = corner + 1;
    ++polygon;
  }
}

/// The index of a layer's value at a corner; −1 if the layer does not say.
std::int64_t layer_index(Mapping mapping, const std::vector<std::int64_t>& indices, size_t corner,
                         size_t vertex, size_t polygon) {
  const size_t at = mapping == Mapping::by_corner    ? corner
                    : mapping == Mapping::by_vertex  ? vertex
                    : mapping == Mapping::by_polygon ? polygon
                                                     : 0;
  if (indices.empty()) return static_cast<std::int64_t>(at);
  return at < indices.size() ? indices[at] : -1;
}

void parse_uv(const MeshSource& source, FbxMesh& mesh) {
  const FbxDocument& document = source.scene.document;
  const std::uint32_t layer = find_child(document, source.node, "LayerElementUV");
  const Mapping mapping = layer == 0 ? Mapping::none : mapping_of(document, layer);
  if (mapping == Mapping::none) return;
  const std::vector<double> numbers = numbers_below(document, layer, "UV");
  const std::vector<std::int64_t> indices = indices_below(document, layer, "UVIndex");
  mesh.uv.assign(mesh.corners.size(), {0.0f, 0.0f});
  for (size_t c = 0; c < mesh.corners.size(); ++c) {
    const std::int64_t index =
        layer_index(mapping, indices, c, static_cast<size_t>(mesh.corners[c]),
                    static_cast<size_t>(source.polygon_of_corner[c]));
    // Corners without coordinates are stored as −1.
    if (index < 0) continue;
    if (static_cast<size_t>(index) >= numbers.size() / 2) {
      refuse_fbx(document, layer, "a texture coordinate does not exist");
    }
    const auto at = static_cast<size_t>(index);
    mesh.uv[c] = {static_cast<float>(numbers[2 * at]), static_cast<float>(numbers[2 * at + 1])};
  }
}

/// The file name and the bytes of a texture's picture.
void parse_picture(const FbxScene& scene, int texture, FbxMaterial& material) {
  const FbxObjects& objects = scene.objects;
  const auto name_of = [&](int object) {
    for (const std::string_view name : {"RelativeFilename", "FileName", "Filename"}) {
      const std::uint32_t node =
          find_child(scene.document, objects.objects[static_cast<size_t>(object)].node, name);
      if (node == 0) continue;
      std::string path = decoded(scene.document, text_of(scene.document, node, 0));
      if (!path.empty()) return path;
    }
    return std::string();
  };
  material.picture = name_of(texture);
  for (const int c : objects.to[static_cast<size_t>(texture)]) {
    const int video = objects.connections[static_cast<size_t>(c)].child;
    const FbxObject& object = objects.objects[static_cast<size_t>(video)];
    if (object.kind != "Video") continue;
    if (material.picture.empty()) material.picture = name_of(video);
    const std::uint32_t node = find_child(scene.document, object.node, "Content");
    const std::optional<FbxValue> value =
        node == 0 ? std::nullopt : value_at(scene.document, node, 0);
    if (value && value->kind == FbxValue::Kind::raw) material.contents = value->text;
  }
}

FbxMaterial parse_material(const FbxScene& scene, int object) {
  const FbxObject& given = scene.objects.objects[static_cast<size_t>(object)];
  FbxMaterial material;
  material.name = given.name;
  for (const FbxProperty& property : properties_of(scene.document, given.node)) {
    if (property.name == "DiffuseColor" && property.count == 3) {
      material.colour = {property.numbers[0], property.numbers[1], property.numbers[2]};
    }
  }
  for (const int c : scene.objects.to[static_cast<size_t>(object)]) {
    const FbxConnection& connection = scene.objects.connections[static_cast<size_t>(c)];
    const FbxObject& child = scene.objects.objects[static_cast<size_t>(connection.child)];
    if (child.kind != "Texture" || connection.property != "DiffuseColor") continue;
    parse_picture(scene, connection.child, material);
    break;
  }
  return material;
}

void parse_materials(const MeshSource& source, FbxMesh& mesh) {
  const FbxScene& scene = source.scene;
  const int model_object = scene.models[static_cast<size_t>(mesh.model)].object;
  for (const int c : scene.objects.to[static_cast<size_t>(model_object)]) {
    const int child = scene.objects.connections[static_cast<size_t>(c)].child;
    if (scene.objects.objects[static_cast<size_t>(child)].kind == "Material") {
      mesh.materials.push_back(parse_material(scene, child));
    }
  }
  if (mesh.materials.empty()) return;
  mesh.triangle_materials.assign(mesh.triangles.size(), 0);
  const std::uint32_t layer = find_child(scene.document, source.node, "LayerElementMaterial");
  if (layer == 0 || mapping_of(scene.document, layer) != Mapping::by_polygon) return;
  const std::vector<std::int64_t> indices = indices_below(scene.document, layer, "Materials");
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
    MeshSource source{scene, holder.node};
    FbxMesh mesh;
    mesh.model = model;
    mesh.name = scene.models[static_cast<size_t>(model)].name;
    mesh.geometric = geometric_transform(scene.models[static_cast<size_t>(model)]);
    parse_positions(source, mesh);
    parse_polygons(source, mesh);
    count(scene, holder.node, mesh.positions.size() + mesh.corners.size() + 1, left);
    parse_uv(source, mesh);
    parse_materials(source, mesh);
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

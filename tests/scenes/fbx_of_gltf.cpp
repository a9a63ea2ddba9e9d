#include "scenes/fbx_of_gltf.h"

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "motion/formats/gltf/gltf_accessor.h"
#include "motion/formats/gltf/gltf_library.h"
#include "motion/formats/gltf/gltf_nodes.h"
#include "motion/math/rotation.h"
#include "scenes/skinned_gltf.h"

namespace mien::test {

namespace {

using motion::Vec3;
using nlohmann::json;
using Numbers = std::vector<double>;
using Ints = std::vector<std::int32_t>;

Numbers fbx_numbers_of(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

Numbers fbx_numbers_of(const Eigen::Affine3d& transform) {
  const Eigen::Matrix4d matrix = transform.matrix();
  return {matrix.data(), matrix.data() + 16};
}

/// Angles about x, y and z, applied in that order.
Numbers degrees_of(const motion::Quat& rotation) {
  const Vec3 zyx = rotation.toRotationMatrix().eulerAngles(2, 1, 0) / motion::radians_per_degree;
  return {zyx[2], zyx[1], zyx[0]};
}

FbxTestNode layer(const std::string& kind, const std::string& values, const Numbers& numbers,
                  const std::string& name = "map1") {
  return {kind,
          {std::int32_t{0}},
          {{"Name", {name}, {}},
           {"MappingInformationType", {std::string("ByPolygonVertex")}, {}},
           {"ReferenceInformationType", {std::string("Direct")}, {}},
           {values, {numbers}, {}}}};
}

struct Writer {
  const motion::GltfFile& gltf;
  const json& document;
  const FbxOfGltf& how;
  FbxSceneBuilder fbx{};
  std::vector<std::int64_t> models{};
  std::map<int, std::int64_t> materials{};

  motion::Quat axes() const {
    return how.z_up ? motion::exp(Vec3(motion::pi / 2, 0, 0)) : motion::Quat::Identity();
  }

  /// World of the glTF file → that of the FBX file.
  Eigen::Affine3d top() const {
    Eigen::Affine3d transform = Eigen::Affine3d::Identity();
    transform.rotate(axes());
    if (how.is_mirrored) transform.scale(Vec3(-1, 1, 1));
    return transform;
  }

  Eigen::Affine3d geometric() const {
    const Vec3 angles = how.geometric_degrees * motion::radians_per_degree;
    Eigen::Affine3d transform = Eigen::Affine3d::Identity();
    transform.translate(how.geometric_translation);
    for (const int axis : {2, 1, 0}) {
      transform.rotate(Eigen::AngleAxisd(angles[axis], Vec3(Vec3::Unit(axis))));
    }
    return transform.scale(how.geometric_scale);
  }

  void add_settings() {
    const auto whole = [&](const char* name, std::int64_t value) {
      fbx.settings.children.push_back(FbxSceneBuilder::setting(name, value));
    };
    fbx.settings.children.push_back(
        FbxSceneBuilder::property("UnitScaleFactor", {100.0 / how.units_per_metre}));
    if (!how.z_up) return;
    whole("UpAxis", 2);
    whole("FrontAxis", 1);
    whole("FrontAxisSign", -1);
    whole("CoordAxis", 0);
  }

  void add_models() {
    const motion::GltfNodes nodes = motion::parse_nodes(gltf);
    const std::int64_t armature = fbx.model(
        "Armature", "Null", 0, {0, 0, 0},
        {FbxSceneBuilder::property("Lcl Rotation", degrees_of(axes())),
         FbxSceneBuilder::property("Lcl Scaling", {how.is_mirrored ? -1.0 : 1.0, 1.0, 1.0})});
    models.assign(static_cast<size_t>(nodes.size()), 0);
    for (const int node : nodes.parents_first) {
      const auto n = static_cast<size_t>(node);
      const motion::NodeTransform& at = nodes.at_rest[n];
      const int parent = nodes.parents[n];
      const bool has_mesh = document["nodes"][n].contains("mesh");
      models[n] = fbx.model(
          gltf.model.nodes[n].name, has_mesh ? "Mesh" : "LimbNode",
          parent < 0 ? armature : models[static_cast<size_t>(parent)],
          fbx_numbers_of(Vec3(how.units_per_metre * at.translation)),
          {FbxSceneBuilder::property("Lcl Rotation", degrees_of(at.rotation)),
           FbxSceneBuilder::property("Lcl Scaling", fbx_numbers_of(at.scale)),
           FbxSceneBuilder::property("GeometricTranslation",
                                     fbx_numbers_of(how.geometric_translation)),
           FbxSceneBuilder::property("GeometricRotation", fbx_numbers_of(how.geometric_degrees)),
           FbxSceneBuilder::property("GeometricScaling", Numbers(3, how.geometric_scale))});
    }
  }

  std::int64_t material_of(const json& primitive) {
    const int index = primitive.value("material", -1);
    if (index < 0) return 0;
    if (const auto known = materials.find(index); known != materials.end()) return known->second;
    const json& given = document["materials"][static_cast<size_t>(index)];
    const json& surface = given["pbrMetallicRoughness"];
    const Numbers factor = surface.value("baseColorFactor", Numbers(4, 1.0));
    const std::int64_t material =
        fbx.add("Material", "skin", "",
                {{"Properties70",
                  {},
                  {FbxSceneBuilder::property("DiffuseColor", {factor[0], factor[1], factor[2]})}}});
    materials[index] = material;
    if (!surface.contains("baseColorTexture")) return material;
    const auto texture_index = surface["baseColorTexture"]["index"].get<size_t>();
    const auto image = document["textures"][texture_index]["source"].get<size_t>();
    const std::int64_t texture =
        fbx.add("Texture", "skin", "", {{"RelativeFilename", {how.picture_name}, {}}});
    fbx.connect(texture, material, "DiffuseColor");
    if (!how.embeds_pictures) return material;
    const std::vector<unsigned char> bytes = motion::bytes_of_gltf_uri(
        document["images"][image]["uri"].get<std::string>(), "test", std::nullopt, "picture");
    const std::int64_t video = fbx.add(
        "Video", "skin", "Clip", {{"Content", {FbxTestBytes{{bytes.begin(), bytes.end()}}}, {}}});
    fbx.connect(video, texture);
    return material;
  }

  void add_skin(std::int64_t geometry, const json& primitive, const json& skin) {
    const auto attribute = [&](const char* name) {
      return primitive["attributes"][name].get<int>();
    };
    const std::vector<int> joints =
        motion::accessor_indices(gltf, attribute("JOINTS_0"), 4, "joints");
    const Numbers weights = motion::accessor_numbers(gltf, attribute("WEIGHTS_0"), 4, "weights");
    const Numbers inverses =
        motion::accessor_numbers(gltf, skin["inverseBindMatrices"].get<int>(), 16, "inverses");
    const std::int64_t deformer = fbx.add("Deformer", "", "Skin", {});
    fbx.connect(deformer, geometry);
    for (size_t j = 0; j < skin["joints"].size(); ++j) {
      Ints vertices;
      Numbers shares;
      for (size_t i = 0; i < joints.size(); ++i) {
        if (joints[i] != static_cast<int>(j) || weights[i] <= 0.0) continue;
        vertices.push_back(static_cast<std::int32_t>(i / 4));
        shares.push_back(weights[i]);
      }
      Eigen::Affine3d to_bone = Eigen::Affine3d::Identity();
      to_bone.matrix() = Eigen::Map<const Eigen::Matrix4d>(inverses.data() + 16 * j);
      to_bone.translation() *= how.units_per_metre;
      std::vector<FbxTestNode> parts = {{"Indexes", {vertices}, {}},
                                        {"Weights", {shares}, {}},
                                        {"Transform", {fbx_numbers_of(to_bone)}, {}}};
      if (how.states_bind_pose) {
        parts.push_back(
            {"TransformLink", {fbx_numbers_of(Eigen::Affine3d(top() * to_bone.inverse()))}, {}});
      }
      const std::int64_t cluster = fbx.add("Deformer", "", "Cluster", std::move(parts));
      fbx.connect(cluster, deformer);
      fbx.connect(models[skin["joints"][j].get<size_t>()], cluster);
    }
  }

  void add_mesh(std::int64_t model, const json& primitive, const json& skin) {
    const json& attributes = primitive["attributes"];
    const Numbers positions =
        motion::accessor_numbers(gltf, attributes["POSITION"].get<int>(), 3, "positions");
    const std::vector<int> corners =
        motion::accessor_indices(gltf, primitive["indices"].get<int>(), 1, "indices");
    const Eigen::Affine3d inverse = geometric().inverse();
    Numbers vertices;
    for (size_t i = 0; i + 2 < positions.size(); i += 3) {
      const Vec3 point = inverse * Vec3(how.units_per_metre * Vec3(positions.data() + i));
      vertices.insert(vertices.end(), {point.x(), point.y(), point.z()});
    }
    Ints polygons;
    for (size_t c = 0; c < corners.size(); ++c) {
      polygons.push_back(c % 3 == 2 ? -corners[c] - 1 : corners[c]);
    }
    std::vector<FbxTestNode> parts = {{"Vertices", {vertices}, {}},
                                      {"PolygonVertexIndex", {polygons}, {}}};
    if (attributes.contains("NORMAL")) {
      const Numbers normals =
          motion::accessor_numbers(gltf, attributes["NORMAL"].get<int>(), 3, "normals");
      Numbers by_corner;
      for (const int corner : corners) {
        const Vec3 normal = inverse.linear() * Vec3(normals.data() + 3 * corner);
        by_corner.insert(by_corner.end(), {normal.x(), normal.y(), normal.z()});
      }
      parts.push_back(layer("LayerElementNormal", "Normals", by_corner));
    }
    if (attributes.contains("TEXCOORD_0")) {
      const Numbers uv =
          motion::accessor_numbers(gltf, attributes["TEXCOORD_0"].get<int>(), 2, "uv");
      Numbers by_corner;
      for (const int corner : corners) {
        by_corner.push_back(uv[2 * static_cast<size_t>(corner)]);
        by_corner.push_back(1.0 - uv[2 * static_cast<size_t>(corner) + 1]);
      }
      parts.push_back(layer("LayerElementUV", "UV", by_corner));
    }
    const std::int64_t geometry = fbx.add("Geometry", "", "Mesh", std::move(parts));
    fbx.connect(geometry, model);
    if (const std::int64_t material = material_of(primitive); material != 0) {
      fbx.connect(material, model);
    }
    add_skin(geometry, primitive, skin);
  }

  void add_meshes() {
    const json& skin = document["skins"][0];
    for (size_t n = 0; n < models.size(); ++n) {
      const json& node = document["nodes"][n];
      if (!node.contains("mesh") || !node.contains("skin")) continue;
      for (const json& primitive : document["meshes"][node["mesh"].get<size_t>()]["primitives"]) {
        add_mesh(models[n], primitive, skin);
      }
    }
  }
};

}  // namespace

FbxSceneBuilder fbx_of_gltf(const std::string& text, const FbxOfGltf& how) {
  const motion::GltfFile gltf = motion::parse_gltf_file(text, "test.gltf", std::nullopt);
  const json document = json::parse(text);
  Writer writer{gltf, document, how};
  writer.add_settings();
  writer.add_models();
  writer.add_meshes();
  return writer.fbx;
}

std::string text_of_glb(const std::string& glb) {
  const std::string_view json = motion::gltf_json_text(glb, "face.glb");
  SkinnedGltf file;
  file.json = nlohmann::json::parse(json);
  const auto* const end = reinterpret_cast<const unsigned char*>(json.data() + json.size());
  const auto* const whole = reinterpret_cast<const unsigned char*>(glb.data());
  constexpr int head_of_chunk = 8;  // its length and kind
  file.buffer.assign(end + head_of_chunk, whole + glb.size());
  return file.text();
}

}  // namespace mien::test

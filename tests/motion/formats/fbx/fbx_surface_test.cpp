// What the surfaces of FBX meshes look like: polygons, normals, texture coordinates, materials and
// pictures.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "motion/formats/fbx/fbx_material.h"
#include "motion/formats/fbx/fbx_mesh.h"
#include "motion/formats/fbx/fbx_scene_builder.h"
#include "motion/refusal.h"

using namespace mien::motion;
using mien::test::FbxSceneBuilder;
using mien::test::FbxTestBytes;
using mien::test::FbxTestNode;

namespace {

using Numbers = std::vector<double>;
using Ints = std::vector<std::int32_t>;

FbxTestNode layer(const std::string& kind, const std::string& name, const std::string& mapping,
                  std::vector<FbxTestNode> values) {
  FbxTestNode node{
      kind, {std::int32_t{0}}, {{"Name", {name}, {}}, {"MappingInformationType", {mapping}, {}}}};
  for (FbxTestNode& value : values) node.children.push_back(std::move(value));
  return node;
}

/// A polygon with further nodes; returns the model.
std::int64_t add_polygon(FbxSceneBuilder& file, const Numbers& vertices, Ints corners,
                         std::vector<FbxTestNode> layers = {}) {
  corners.back() = -corners.back() - 1;
  std::vector<FbxTestNode> parts = {{"Vertices", {vertices}, {}},
                                    {"PolygonVertexIndex", {corners}, {}}};
  for (FbxTestNode& one : layers) parts.push_back(std::move(one));
  const std::int64_t model = file.model("mesh", "Mesh", 0, {0, 0, 0});
  file.connect(file.add("Geometry", "", "Mesh", std::move(parts)), model);
  return model;
}

const Numbers square = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};

FbxMesh only_mesh(const std::string& bytes) {
  const std::vector<FbxMesh> meshes = fbx_meshes(parse_fbx_scene(bytes, "mesh.fbx"));
  EXPECT_EQ(meshes.size(), 1u);
  return meshes.at(0);
}

/// Twice the areas of the triangles in the plane z = 0, which are positive where these are seen
/// from the front.
std::vector<double> areas_of(const FbxMesh& mesh) {
  std::vector<double> areas;
  for (const auto& t : mesh.triangles) {
    const auto at = [&](size_t k) {
      return mesh.positions[static_cast<size_t>(mesh.corners[static_cast<size_t>(t[k])])];
    };
    areas.push_back((at(1) - at(0)).cross(at(2) - at(0)).z());
  }
  return areas;
}

}  // namespace

TEST(FbxSurface, PolygonsWithADentAreNotCoveredOutside) {
  // An arrowhead, from each of its corners, and an L.
  const std::array<std::array<double, 2>, 4> arrow = {{{0, 0}, {2, 1}, {0, 2}, {0.5, 1}}};
  for (size_t start = 0; start < 4; ++start) {
    Numbers vertices;
    for (size_t i = 0; i < 4; ++i) {
      const auto& [x, y] = arrow[(start + i) % 4];
      vertices.insert(vertices.end(), {x, y, 0.0});
    }
    FbxSceneBuilder file;
    add_polygon(file, vertices, {0, 1, 2, 3});
    const std::vector<double> areas = areas_of(only_mesh(file.binary()));
    ASSERT_EQ(areas.size(), 2u);
    EXPECT_GT(std::min(areas[0], areas[1]), 0.0) << start;
    EXPECT_NEAR(areas[0] + areas[1], 3.0, 1e-12);
  }
  FbxSceneBuilder file;
  add_polygon(file, {0, 0, 0, 2, 0, 0, 2, 1, 0, 1, 1, 0, 1, 2, 0, 0, 2, 0}, {0, 1, 2, 3, 4, 5});
  double whole = 0.0;
  for (const double area : areas_of(only_mesh(file.binary()))) {
    EXPECT_GE(area, 0.0);
    whole += area;
  }
  EXPECT_NEAR(whole, 6.0, 1e-12);
}

TEST(FbxSurface, NormalsBelongToCornersOrVertices) {
  for (const auto& [mapping, index] :
       std::vector<std::pair<std::string, Ints>>{{"ByPolygonVertex", {1, 0, 1, 0}},
                                                 {"ByVertice", {0, 1, 0, 1}},
                                                 {"ByPolygon", {1}},
                                                 {"AllSame", {1}}}) {
    FbxSceneBuilder file;
    add_polygon(
        file, square, {1, 2, 3, 0},
        {layer("LayerElementNormal", "", mapping,
               {{"Normals", {Numbers{0, 0, 1, 0, 1, 0}}, {}}, {"NormalsIndex", {index}, {}}})});
    const FbxMesh mesh = only_mesh(file.binary());
    ASSERT_EQ(mesh.normals.size(), 4u) << mapping;
    const bool alternates = index.size() == 4;
    for (size_t c = 0; c < 4; ++c) {
      const bool is_up = !alternates || c % 2 == 0;
      EXPECT_EQ(mesh.normals[c], (std::array{0.0f, is_up ? 1.0f : 0.0f, is_up ? 0.0f : 1.0f}))
          << mapping << c;
    }
  }
  FbxSceneBuilder file;
  add_polygon(file, square, {0, 1, 2, 3},
              {layer("LayerElementNormal", "", "AllSame",
                     {{"Normals", {Numbers{0, 0, 1}}, {}}, {"NormalsIndex", {Ints{3}}, {}}})});
  EXPECT_NE(mien::test::refusal_of([&] {
              only_mesh(file.binary());
            }).find("a value of the layer Normals does not exist"),
            std::string::npos);
}

TEST(FbxSurface, SetsOfTextureCoordinatesKeepTheirNames) {
  FbxSceneBuilder file;
  add_polygon(file, square, {0, 1, 2, 3},
              {layer("LayerElementUV", "map1", "ByVertice",
                     {{"UV", {Numbers{0, 0, 1, 0, 1, 1, 0, 1}}, {}}}),
               layer("LayerElementUV", "light", "AllSame", {{"UV", {Numbers{0.25, 0.5}}, {}}}),
               layer("LayerElementUV", "unknown", "ByEdge", {{"UV", {Numbers{0, 0}}, {}}})});
  const FbxMesh mesh = only_mesh(file.binary());
  ASSERT_EQ(mesh.uv_sets.size(), 2u);
  EXPECT_EQ(mesh.uv_sets[0].name, "map1");
  EXPECT_EQ(mesh.uv_sets[0].uv[2], (std::array{1.0f, 1.0f}));
  EXPECT_EQ(mesh.uv_sets[1].name, "light");
  EXPECT_EQ(mesh.uv_sets[1].uv[3], (std::array{0.25f, 0.5f}));
}

TEST(FbxSurface, MaterialsHaveColoursAndPicturesInTheFileOrBesideIt) {
  FbxSceneBuilder file;
  const std::int64_t model = add_polygon(file, square, {0, 1, 2, 3});
  const std::int64_t material =
      file.add("Material", "skin", "",
               {{"Properties70",
                 {},
                 {FbxSceneBuilder::property("DiffuseColor", {0.25, 2.0, -1.0}),
                  FbxSceneBuilder::property("DiffuseFactor", {0.5})}}});
  file.connect(material, model);
  std::string picture;
  for (int byte = 0; byte < 200; ++byte) picture += static_cast<char>(byte);
  const std::int64_t texture =
      file.add("Texture", "t", "", {{"FileName", {std::string("C:\\a\\b.png")}, {}}});
  const std::int64_t layered = file.add("LayeredTexture", "l", "", {});
  const std::int64_t video = file.add(
      "Video", "v", "Clip",
      {{"RelativeFilename", {std::string("b.png")}, {}}, {"Content", {FbxTestBytes{picture}}, {}}});
  file.connect(video, texture);
  file.connect(texture, layered);
  file.connect(layered, material, "DiffuseColor");
  file.connect(texture, material, "NormalMap");
  for (const std::string& bytes : {file.binary(), file.binary(7500, false), file.text()}) {
    const FbxScene scene = parse_fbx_scene(bytes, "mesh.fbx");
    const FbxMesh mesh = fbx_meshes(scene).at(0);
    ASSERT_EQ(mesh.materials.size(), 1u);
    EXPECT_EQ(mesh.triangle_materials, (std::vector<int>{0, 0}));
    const FbxMaterial read = fbx_material(scene, mesh.materials[0]);
    EXPECT_EQ(read.name, "skin");
    EXPECT_EQ(read.colour, Vec3(0.25, 1.0, 0.0));
    EXPECT_EQ(read.factor, 0.5);
    ASSERT_GE(read.colour_texture, 0);
    EXPECT_EQ(read.normal_texture, read.colour_texture);
    const FbxTexture found = fbx_texture(scene, read.colour_texture);
    EXPECT_EQ(found.files, (std::vector<std::string>{"C:\\a\\b.png", "b.png"}));
    EXPECT_EQ(fbx_picture(scene, found.video), picture);
  }
}

#include "scenes/character/fbx_character.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "motion/error.h"
#include "motion/math/rotation.h"
#include "motion/refusal.h"
#include "motion/text/file_contents.h"
#include "pipeline/temporary_folder.h"
#include "render/scene/texture_io.h"
#include "scenes/character/character.h"
#include "scenes/fbx_of_gltf.h"
#include "scenes/skinned_gltf.h"

#include "real_data.h"

namespace mien::scenes {
namespace {

using motion::Vec3;
using test::FbxOfGltf;
using test::FbxSceneBuilder;
using test::FbxTestNode;
using test::SkinnedGltf;
namespace fs = std::filesystem;

const motion::Skeleton standard_rig = motion::standard_body();

/// A figure whose texture is all of its colour, as in FBX.
SkinnedGltf figure_in_colour() {
  SkinnedGltf file = test::skinned_gltf(standard_rig, {{}, test::mixamo_names()});
  file.json["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"] = {1.0, 1.0, 1.0, 1.0};
  return file;
}

motion::Pose some_pose() {
  std::mt19937_64 random(38);
  std::uniform_real_distribution<double> angle(-0.6, 0.6);
  motion::Pose pose;
  pose.root_position = Vec3(0.3, 1.0, -0.2);
  for (int j = 0; j < motion::body_joint_count; ++j) {
    pose.rotations.push_back(motion::exp(Vec3(angle(random), angle(random), angle(random))));
  }
  return pose;
}

std::string listed(const std::vector<std::string>& warnings) {
  std::string text;
  for (const std::string& warning : warnings) text += warning + "\n";
  return text;
}

bool has(const std::string& text, std::string_view words) {
  return text.find(words) != std::string::npos;
}

/// The largest distance between the corners of two triangles, in their order.
float distance_of(const render::Mesh& a, size_t s, const render::Mesh& b, size_t t) {
  float most = 0.0f;
  for (size_t k = 0; k < 3; ++k) {
    most = std::max(most, (a.positions[static_cast<size_t>(a.triangles[s][k])] -
                           b.positions[static_cast<size_t>(b.triangles[t][k])])
                              .norm());
  }
  return most;
}

size_t nearest_triangle(const render::Mesh& a, const render::Mesh& b, size_t t) {
  size_t nearest = 0;
  float least = std::numeric_limits<float>::max();
  for (size_t s = 0; s < a.triangles.size(); ++s) {
    const float distance = distance_of(a, s, b, t);
    if (distance < least) nearest = s;
    least = std::min(least, distance);
  }
  return nearest;
}

/// Each triangle of one posed character is one of the other, with the same normals, texture
/// coordinates and colours.
void expect_same_picture(const Character& one, const Character& other, float tolerance) {
  ASSERT_EQ(one.meshes.size(), other.meshes.size());
  const std::vector<render::Mesh> expected = posed(one, some_pose());
  const std::vector<render::Mesh> drawn = posed(other, some_pose());
  for (size_t m = 0; m < expected.size(); ++m) {
    const render::Mesh& a = expected[m];
    const render::Mesh& b = drawn[m];
    ASSERT_EQ(a.triangles.size(), b.triangles.size());
    ASSERT_EQ(a.uv.empty(), b.uv.empty());
    float position = 0.0f, normal = 0.0f, uv = 0.0f;
    for (size_t t = 0; t < b.triangles.size(); ++t) {
      const size_t s = nearest_triangle(a, b, t);
      position = std::max(position, distance_of(a, s, b, t));
      EXPECT_EQ(a.triangle_parts[s], b.triangle_parts[t]);
      for (size_t k = 0; k < 3; ++k) {
        const auto i = static_cast<size_t>(a.triangles[s][k]);
        const auto j = static_cast<size_t>(b.triangles[t][k]);
        normal = std::max(normal, (a.normals[i] - b.normals[j]).norm());
        for (size_t c = 0; c < 2 && !a.uv.empty(); ++c)
          uv = std::max(uv, std::abs(a.uv[i][c] - b.uv[j][c]));
      }
    }
    EXPECT_LT(position, tolerance);
    EXPECT_LT(normal, 100.0f * tolerance);
    EXPECT_LT(uv, 1e-6f);
    const render::Material& colour = one.materials[static_cast<size_t>(a.material)];
    const render::Material& other_colour = other.materials[static_cast<size_t>(b.material)];
    ASSERT_EQ(colour.texture < 0, other_colour.texture < 0);
    if (colour.texture < 0) continue;
    EXPECT_TRUE((colour.albedo == other_colour.albedo).all());
    const auto& texels = one.textures[static_cast<size_t>(colour.texture)].texels;
    const auto& others = other.textures[static_cast<size_t>(other_colour.texture)].texels;
    ASSERT_EQ(texels.size(), others.size());
    for (size_t i = 0; i < texels.size(); ++i) EXPECT_TRUE((texels[i] == others[i]).all());
  }
}

Character worn(Character character) { return scaled_to_body(std::move(character), standard_rig); }

TEST(AnFbxCharacter, IsTheSameAsItsGltf) {
  const std::string gltf = figure_in_colour().text();
  const Character expected = worn(parse_character(gltf, "figure.gltf"));
  std::vector<FbxOfGltf> ways(6);
  ways[1].units_per_metre = 1.0;
  ways[2].z_up = true;
  ways[3].states_bind_pose = false;
  ways[4].geometric_translation = {10.0, -20.0, 30.0};
  ways[4].geometric_degrees = {30.0, 40.0, -50.0};
  ways[4].geometric_scale = 0.5;
  ways[5].z_up = true;
  ways[5].states_bind_pose = false;
  for (const FbxOfGltf& how : ways) {
    const FbxSceneBuilder fbx = test::fbx_of_gltf(gltf, how);
    for (const std::string& bytes : {fbx.binary(), fbx.binary(7500, false), fbx.text()}) {
      const Character character = worn(parse_character(bytes, "figure.fbx"));
      EXPECT_EQ(listed(character.warnings), listed(expected.warnings));
      expect_same_picture(expected, character, 2e-5f);
    }
  }
}

TEST(AnFbxCharacter, IsTheSameAsItsGltfOfARealFigure) {
  const auto data = test::real_data();
  if (!data) GTEST_SKIP() << "no real figure here: set MIEN_DATA to the folder that has it";
  const std::string gltf = motion::read_contents(*data / "characters/cesium_man.gltf");
  const Character expected = worn(parse_character(gltf, "cesium.gltf"));
  FbxOfGltf how;
  for (const bool states_bind_pose : {true, false}) {
    how.states_bind_pose = states_bind_pose;
    const std::string bytes = test::fbx_of_gltf(gltf, how).binary();
    expect_same_picture(expected, worn(parse_character(bytes, "cesium.fbx")), 2e-5f);
  }
}

TEST(AnFbxCharacter, ThatIsMirroredIsTheSameAsItsGltf) {
  SkinnedGltf file = figure_in_colour();
  const std::string plain = file.text();
  file.json["nodes"].push_back({{"name", "Armature"}, {"scale", {-1, 1, 1}}, {"children", {0}}});
  const Character expected = worn(parse_character(file.text(), "mirrored.gltf"));
  FbxOfGltf how;
  how.is_mirrored = true;
  for (const bool states_bind_pose : {true, false}) {
    how.states_bind_pose = states_bind_pose;
    const std::string bytes = test::fbx_of_gltf(plain, how).binary();
    expect_same_picture(expected, worn(parse_character(bytes, "mirrored.fbx")), 2e-5f);
  }
}

/// Finds the children of an object's node by its kind.
FbxTestNode& object_of(FbxSceneBuilder& fbx, const std::string& kind) {
  const auto found = std::ranges::find(fbx.objects.children, kind, &FbxTestNode::name);
  EXPECT_NE(found, fbx.objects.children.end()) << kind;
  return *found;
}

std::int64_t number_of(const FbxTestNode& object) {
  return std::get<std::int64_t>(object.values[0]);
}

TEST(AnFbxCharacter, HasAMaterialForEachPolygon) {
  FbxSceneBuilder fbx = test::fbx_of_gltf(figure_in_colour().text());
  FbxTestNode& geometry = object_of(fbx, "Geometry");
  const std::int64_t model =
      number_of(*std::ranges::find_if(fbx.objects.children, [](const FbxTestNode& node) {
        return node.name == "Model" && std::get<std::string>(node.values[2]) == "Mesh";
      }));
  // The first ten triangles are green; the index 7 names no material and means the first.
  const size_t triangles = motion::body_joint_count * 12;
  std::vector<std::int32_t> indices(triangles, 0);
  std::fill_n(indices.begin(), 10, 1);
  indices[10] = 7;
  geometry.children.push_back(
      {"LayerElementMaterial",
       {std::int32_t{0}},
       {{"MappingInformationType", {std::string("ByPolygon")}, {}}, {"Materials", {indices}, {}}}});
  const std::int64_t green = fbx.add("Material", "green", "",
                                     {{"Properties70",
                                       {},
                                       {FbxSceneBuilder::property("DiffuseColor", {0.0, 1.0, 0.25}),
                                        FbxSceneBuilder::property("DiffuseFactor", {0.5})}}});
  fbx.connect(green, model);
  const Character character = parse_character(fbx.binary(), "figure.fbx");
  ASSERT_EQ(character.meshes.size(), 2u);
  EXPECT_EQ(character.meshes[0].triangles.size(), triangles - 10);
  EXPECT_EQ(character.meshes[1].triangles.size(), 10u);
  const auto material_of = [&](size_t mesh) {
    return character.materials[static_cast<size_t>(character.meshes[mesh].material)];
  };
  EXPECT_EQ(material_of(0).texture, 0);
  EXPECT_EQ(material_of(1).texture, -1);
  EXPECT_LT((material_of(1).albedo - render::Color(0.0f, 0.5f, 0.125f)).abs().maxCoeff(), 1e-6f);
}

TEST(AnFbxCharacter, TakesTheTextureCoordinatesThatItsTextureNames) {
  FbxSceneBuilder fbx = test::fbx_of_gltf(figure_in_colour().text());
  FbxTestNode& geometry = object_of(fbx, "Geometry");
  geometry.children.push_back({"LayerElementUV",
                               {std::int32_t{1}},
                               {{"Name", {std::string("second")}, {}},
                                {"MappingInformationType", {std::string("AllSame")}, {}},
                                {"UV", {std::vector<double>{0.125, 0.25}}, {}}}});
  const Character first = parse_character(fbx.binary(), "figure.fbx");
  EXPECT_EQ(first.meshes[0].uv[0][1], 0.5f);
  FbxTestNode& texture = object_of(fbx, "Texture");
  const FbxTestNode named{"P",
                          {std::string("UVSet"), std::string("KString"), std::string(),
                           std::string(), std::string("second")},
                          {}};
  texture.children.push_back({"Properties70", {}, {named}});
  const Character second = parse_character(fbx.binary(), "figure.fbx");
  for (const auto& uv : second.meshes[0].uv) EXPECT_EQ(uv, (std::array{0.125f, 0.75f}));
}

class FbxPictures : public testing::Test {
 protected:
  FbxPictures() { fs::create_directories(folder_ / "figure.fbm"); }

  /// The pictures of a character that names its picture so.
  Character read(const std::string& picture_name) const {
    FbxOfGltf how;
    how.embeds_pictures = false;
    how.picture_name = picture_name;
    const fs::path file = folder_ / "figure.fbx";
    std::ofstream(file, std::ios::binary)
        << test::fbx_of_gltf(figure_in_colour().text(), how).binary();
    return read_character(file);
  }

  void write_picture(const fs::path& place) const {
    const Character embedded =
        parse_character(test::fbx_of_gltf(figure_in_colour().text()).binary(), "f.fbx");
    fs::create_directories((folder_ / place).parent_path());
    std::ofstream(folder_ / place, std::ios::binary)
        << render::texture_png(embedded.textures.at(0), render::TextureUse::colour);
  }

  const mien::test::TemporaryFolder temporary_;
  const fs::path folder_ = temporary_.path() / "figures";
};

TEST_F(FbxPictures, AreFoundBesideTheFile) {
  const std::string windows = "C:\\Users\\me\\textures\\skin.png";
  for (const auto& [name, place] :
       std::vector<std::pair<std::string, std::string>>{{"textures\\skin.png", "textures/skin.png"},
                                                        {"./skin.png", "skin.png"},
                                                        {windows, "skin.png"},
                                                        {windows, "figure.fbm/skin.png"},
                                                        {"..\\..\\skin.png", "skin.png"}}) {
    write_picture(place);
    const Character character = read(name);
    EXPECT_EQ(character.textures.size(), 1u) << name;
    EXPECT_EQ(listed(character.warnings), "") << name;
    EXPECT_EQ(files_of_character(folder_ / "figure.fbx"), std::vector<fs::path>{folder_ / place})
        << name;
    fs::remove(folder_ / place);
  }
}

TEST_F(FbxPictures, ThatAreMissingOrLeadOutOfTheFolderAreSaidAndLeaveAPlainColour) {
  write_picture("skin.png");
  fs::rename(folder_ / "skin.png", folder_.parent_path() / "mien_fbx_skin.png");
  for (const std::string name : {"..\\mien_fbx_skin.png", "/etc/passwd", "skin.png", "a\nb.png"}) {
    const Character character = read(name);
    EXPECT_TRUE(character.textures.empty()) << name;
    EXPECT_TRUE(has(listed(character.warnings), "is not in the file or beside it")) << name;
    EXPECT_TRUE(files_of_character(folder_ / "figure.fbx").empty());
    EXPECT_EQ(character.materials[1].texture, -1);
  }
  fs::remove(folder_.parent_path() / "mien_fbx_skin.png");
  std::ofstream(folder_ / "skin.tga") << "no picture that is read";
  EXPECT_TRUE(has(listed(read("skin.tga").warnings), "\"skin.tga\" is not PNG, JPEG or WebP"));
}

TEST(AnFbxCharacter, SaysWhatItLeavesOut) {
  FbxSceneBuilder fbx = test::fbx_of_gltf(figure_in_colour().text());
  FbxTestNode& geometry = object_of(fbx, "Geometry");
  geometry.children.push_back({"LayerElementColor", {std::int32_t{0}}, {}});
  const std::int64_t mesh = number_of(geometry);
  const std::int64_t material = number_of(object_of(fbx, "Material"));
  fbx.connect(fbx.add("Deformer", "smile", "BlendShape", {}), mesh);
  fbx.connect(number_of(object_of(fbx, "Texture")), material, "TransparentColor");
  // A mesh that hangs on no joint, and a hidden one.
  const std::vector<FbxTestNode> triangle = {
      {"Vertices", {std::vector<double>{0, 0, 0, 1, 0, 0, 0, 1, 0}}, {}},
      {"PolygonVertexIndex", {std::vector<std::int32_t>{0, 1, -3}}, {}}};
  fbx.connect(fbx.add("Geometry", "", "Mesh", triangle), fbx.model("box", "Mesh", 0, {0, 0, 0}));
  fbx.connect(
      fbx.add("Geometry", "", "Mesh", triangle),
      fbx.model("hidden", "Mesh", 0, {0, 0, 0}, {FbxSceneBuilder::property("Visibility", {0.0})}));
  const std::string said = listed(parse_character(fbx.binary(), "figure.fbx").warnings);
  for (const std::string_view words :
       {"Blend shapes are not applied", "Vertex colours are not drawn", "drawn opaque",
        "1 mesh(es) hang on no joint", "1 mesh(es) are hidden"})
    EXPECT_TRUE(has(said, words)) << words << "\n" << said;
}

TEST(AnFbxCharacter, CarriesMeshesThatHangOnItsJoints) {
  FbxSceneBuilder fbx = test::fbx_of_gltf(figure_in_colour().text());
  const auto joint = [&](const std::string& name) {
    return number_of(*std::ranges::find_if(fbx.objects.children, [&](const FbxTestNode& node) {
      return std::get<std::string>(node.values[1]).starts_with(name + '\0');
    }));
  };
  const std::vector<FbxTestNode> triangle = {
      {"Vertices", {std::vector<double>{0, 0, 0, 1, 0, 0, 0, 1, 0}}, {}},
      {"PolygonVertexIndex", {std::vector<std::int32_t>{0, 1, -3}}, {}}};
  fbx.connect(fbx.add("Geometry", "", "Mesh", triangle),
              fbx.model("hat", "Mesh", joint("mixamorig:Head"), {0, 0, 0},
                        {FbxSceneBuilder::property("GeometricTranslation", {0, 30, 0})}));
  const Character character = worn(parse_character(fbx.binary(), "figure.fbx"));
  ASSERT_EQ(character.meshes.size(), 2u);
  const auto head = static_cast<size_t>(character.joints[motion::Head].position);
  // The hat's corner at its origin, in the frame of the head.
  const auto corner_in = [&](const motion::Pose& pose) -> Vec3 {
    const motion::JointTransforms rig = rig_pose(character, pose);
    const std::vector<render::Mesh> meshes = posed(character, pose);
    const auto hat = std::ranges::min_element(
        meshes, {}, [](const render::Mesh& mesh) { return mesh.positions.size(); });
    const Vec3 corner = hat->positions[0].cast<double>();
    return rig.rotations[head].conjugate() * (corner - rig.positions[head]);
  };
  motion::Pose at_rest = some_pose();
  for (motion::Quat& rotation : at_rest.rotations) rotation = motion::Quat::Identity();
  EXPECT_NEAR(corner_in(some_pose()).norm(), 0.3, 1e-4);
  EXPECT_LT((corner_in(some_pose()) - corner_in(at_rest)).norm(), 1e-4);
}

TEST(AnFbxCharacter, ThatIsNoneIsRefused) {
  const auto refused = [](const std::string& bytes) {
    return test::refusal_of([&] { parse_character(bytes, "figure.fbx"); });
  };
  EXPECT_TRUE(has(refused(test::fbx_arm().binary()), "no mesh follows a skin"));
  FbxSceneBuilder flat = test::fbx_of_gltf(figure_in_colour().text());
  for (FbxTestNode& object : flat.objects.children) {
    for (FbxTestNode& child : object.children) {
      if (child.name == "Transform") child.values = {std::vector<double>(16, 0.0)};
    }
  }
  EXPECT_TRUE(has(refused(flat.binary()), "flattens the mesh"));
}

/// Reads a character, which either is sound or is refused.
void try_to_read(const std::string& bytes) {
  try {
    const Character character = parse_character(bytes, "mutant.fbx");
    render::Scene scene;
    scene.materials.push_back({});
    add_character(scene, character, some_pose());
    EXPECT_NO_THROW(render::validate(scene));
  } catch (const Error& error) {
    EXPECT_LT(std::string(error.what()).size(), 500u);
  }
}

TEST(AnFbxCharacter, ThatIsDamagedIsReadOrRefused) {
  const FbxSceneBuilder fbx = test::fbx_of_gltf(figure_in_colour().text());
  std::mt19937_64 random(38);
  for (const std::string& bytes : {fbx.binary(7400, true), fbx.binary(7500, false), fbx.text()}) {
    for (int trial = 0; trial < 200; ++trial) {
      std::string mutant = bytes;
      const int changes = 1 + static_cast<int>(random() % 3);
      for (int i = 0; i < changes; ++i) {
        const size_t at = random() % mutant.size();
        if (random() % 3 == 0) {
          mutant.erase(at, 1 + random() % 8);
        } else {
          mutant[at] = static_cast<char>(random());
        }
      }
      try_to_read(mutant);
    }
  }
}

/// The vertices of an .obj file by its groups, and the size of all.
struct ObjFile {
  std::vector<Vec3> vertices;
  double size = 0.0;
};

ObjFile read_obj(const fs::path& path) {
  std::ifstream file(path);
  EXPECT_TRUE(file) << path;
  ObjFile obj;
  Eigen::AlignedBox3d box;
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word != "v") continue;
    Vec3 v;
    words >> v.x() >> v.y() >> v.z();
    obj.vertices.push_back(v);
    box.extend(v);
  }
  obj.size = box.diagonal().norm();
  return obj;
}

struct PosedFile {
  const char* fbx;
  const char* obj;
  const char* take;
  int frame;
  double tolerance = 1e-4;  ///< as a share of the size
};

// The skinned meshes, moved from their bind pose as the file's bones move, are where the program
// that wrote the file has them.
TEST(AnFbxCharacter, FollowsItsOwnTakes) {
  const auto data = test::real_data();
  if (!data || !fs::is_directory(*data / "recordings/fbx"))
    GTEST_SKIP() << "no real files here: set MIEN_DATA to the folder that has them";
  for (const PosedFile& file :
       {PosedFile{"maya_advanced_skinned_pivot_7700_binary", "maya_advanced_skinned_pivot",
                  "Take 001", 0, 1e-3},
        PosedFile{"max_transformed_skin_7500_binary", "max_transformed_skin_5", "Take 001", 5},
        PosedFile{"max_transformed_skin_7500_binary", "max_transformed_skin_15", "Take 001", 15},
        PosedFile{"maya_game_sausage_7500_binary_combined", "maya_game_sausage_wiggle_10", "wiggle",
                  10},
        PosedFile{"maya_game_sausage_7500_binary_combined", "maya_game_sausage_deform_8", "deform",
                  48},
        PosedFile{"blender_279_sausage_7400_binary", "blender_279_sausage_wiggle_20",
                  "Skeleton|Wiggle", 20},
        PosedFile{"blender_279_sausage_6100_ascii", "blender_279_sausage_wiggle_20", "Wiggle",
                  20}}) {
    const std::string bytes =
        motion::read_contents(*data / "recordings/fbx" / (std::string(file.fbx) + ".fbx"));
    std::vector<std::string> warnings;
    const FbxCharacter character = parse_fbx_character(bytes, file.fbx, warnings);
    const motion::FbxScene& scene = character.scene;
    std::vector<motion::FbxMoving> moving = motion::at_rest(scene);
    for (const motion::FbxTake& take : scene.takes) {
      if (take.name != file.take) continue;
      const double rate =
          scene.settings.frames_per_second > 0.0 ? scene.settings.frames_per_second : 24.0;
      const double ticks = static_cast<double>(motion::fbx_ticks_per_second) * file.frame / rate;
      motion::apply(motion::parse_fbx_animation(scene.document, scene.objects, scene.models, take),
                    scene.models, static_cast<std::int64_t>(ticks), moving);
    }
    const std::vector<motion::FbxPlace> places = motion::places_of(scene, moving);
    JointMotions motions;
    for (size_t j = 0; j < character.rig.nodes.size(); ++j) {
      const motion::FbxPlace& place = places[static_cast<size_t>(character.rig.nodes[j])];
      Eigen::Affine3d now = Eigen::Affine3d::Identity();
      now.linear() = place.linear;
      now.translation() = place.position;
      motions.push_back(Eigen::Affine3d(scene.settings.to_y_up * now) *
                        character.rig.bind[j].inverse());
    }
    const ObjFile expected = read_obj(*data / "recordings/fbx" / (std::string(file.obj) + ".obj"));
    const FbxPaint paint = fbx_paint(character, std::nullopt, warnings);
    double most = 0.0;
    size_t found = 0;
    for (const SkinnedMesh& mesh : fbx_skinned_meshes(character, paint, warnings)) {
      for (const render::Vec3& position : linear_blend_skinned(mesh, motions).positions) {
        const Vec3 point = scene.settings.to_y_up.transpose() * position.cast<double>();
        double nearest = std::numeric_limits<double>::max();
        for (const Vec3& vertex : expected.vertices)
          nearest = std::min(nearest, (point - vertex).norm());
        most = std::max(most, nearest);
        ++found;
      }
    }
    EXPECT_GE(found, expected.vertices.size()) << file.obj;
    EXPECT_LT(most, file.tolerance * expected.size) << file.obj;
  }
}

}  // namespace
}  // namespace mien::scenes

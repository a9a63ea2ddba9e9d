#include "scenes/character/character.h"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <unistd.h>

#include "motion/error.h"
#include "motion/math/rotation.h"
#include "scenes/mannequin/mannequin_flesh.h"
#include "scenes/skinned_gltf.h"

namespace mien::scenes {
namespace {

using motion::Quat;
using motion::Vec3;
using test::SkinnedGltf;
using test::SkinnedGltfOptions;

const motion::Skeleton standard = motion::standard_body();

motion::Pose random_pose(std::mt19937_64& random) {
  std::uniform_real_distribution<double> angle(-0.7, 0.7);
  motion::Pose pose;
  pose.root_position = Vec3(angle(random), 1.0, angle(random));
  for (int j = 0; j < motion::body_joint_count; ++j) {
    pose.rotations.push_back(motion::exp(Vec3(angle(random), angle(random), angle(random))));
  }
  return pose;
}

/// An A-pose whose feet stand flat.
motion::Pose a_pose() { return modelling_pose(standard); }

/// The character follows poses exactly: its joints are where the body's are, and each box,
/// drawn round a bone, still is.
void expect_follows(const SkinnedGltf& file, double bend_tolerance) {
  const Character character = scaled_to_body(parse_character(file.text(), "figure.gltf"), standard);
  ASSERT_EQ(character.rig.size(), motion::body_joint_count);
  std::mt19937_64 random(17);
  for (int trial = 0; trial < 10; ++trial) {
    const motion::Pose pose = random_pose(random);
    const motion::JointTransforms expected = motion::world_transforms(standard, pose);
    const motion::JointTransforms rig = rig_pose(character, pose);
    const std::vector<render::Mesh> meshes = posed(character, pose);
    for (size_t j = 0; j < expected.positions.size(); ++j) {
      EXPECT_LT((rig.positions[j] - expected.positions[j]).norm(), bend_tolerance)
          << motion::name_of(motion::BodyJoint(j));
      // Eight corners a box; the first four are round the joint.
      render::Vec3 middle = render::Vec3::Zero();
      for (size_t c = 0; c < 4; ++c) middle += 0.25f * meshes[0].positions[8 * j + c];
      EXPECT_LT((middle.cast<double>() - rig.positions[j]).norm(), 1e-5);
    }
  }
}

TEST(ACharacter, BoundInATPoseFollowsTheBody) {
  expect_follows(test::skinned_gltf(standard, {{}, test::mixamo_names()}), 1e-5);
}

// In an A-pose the feet are taken to stand square to the shanks, which costs their toes a
// millimetre.

TEST(ACharacter, BoundInAnAPoseTakesTheSameDirections) {
  expect_follows(test::skinned_gltf(standard, {a_pose(), test::mixamo_names()}), 2e-3);
}

TEST(ACharacter, WithoutNamesIsKnownByItsTree) {
  expect_follows(test::skinned_gltf(standard, {a_pose(), {}}), 2e-3);
}

TEST(ACharacter, MayBeInOtherUnitsAndAxesWithItsNodesPosedAnyhow) {
  SkinnedGltfOptions options{a_pose(), test::mixamo_names()};
  options.unit = 100.0;
  options.z_up = true;
  expect_follows(test::skinned_gltf(standard, options), 2e-3);
  options.posed_nodes = false;
  expect_follows(test::skinned_gltf(standard, options), 2e-3);
}

/// The joints of the skin but for some, whose weights go to the joint above.
void leave_out_of_skin(SkinnedGltf& file, const std::vector<int>& joints) {
  nlohmann::json& skin = file.json["skins"][0];
  const auto& accessor = file.json["accessors"][skin["inverseBindMatrices"].get<size_t>()];
  const auto& view = file.json["bufferViews"][accessor["bufferView"].get<size_t>()];
  const auto at = view.value("byteOffset", size_t{0});
  // The joint's place in the list is taken by the next one that stays, and so are its weights.
  nlohmann::json kept = nlohmann::json::array();
  for (size_t j = 0; j < motion::body_joint_count; ++j) {
    const bool is_out = std::ranges::count(joints, static_cast<int>(j)) > 0;
    const size_t from = is_out ? (j == 0 ? 1 : j - 1) : j;
    if (is_out) {
      std::memcpy(file.buffer.data() + at + 64 * j, file.buffer.data() + at + 64 * from, 64);
    }
    kept.push_back(from);
  }
  skin["joints"] = kept;
}

TEST(ACharacter, IsDrawnAlikeHoweverItsNodesArePosed) {
  // Pelvis and neck are in no skin, and the first joint of the skin is turned.
  for (const std::vector<int>& unskinned :
       {std::vector<int>{}, {motion::Neck}, {motion::Pelvis, motion::Neck}}) {
    SkinnedGltf bound = test::skinned_gltf(standard, {{}, test::mixamo_names()});
    leave_out_of_skin(bound, unskinned);
    SkinnedGltf nodding = bound;
    for (const int joint : {static_cast<int>(motion::Spine), static_cast<int>(motion::Neck),
                            static_cast<int>(motion::Head), static_cast<int>(motion::LeftHip)}) {
      const Quat turn = motion::exp(Vec3(10.0 * motion::radians_per_degree, 0.1, 0.0));
      nodding.json["nodes"][static_cast<size_t>(joint)]["rotation"] = {turn.x(), turn.y(), turn.z(),
                                                                       turn.w()};
    }
    if (!unskinned.empty() && unskinned.front() == motion::Pelvis) {
      nodding.json["nodes"][0]["translation"] = {0.2, 1.3, -0.5};
    }
    const Character one = scaled_to_body(parse_character(bound.text(), "one.gltf"), standard);
    const Character other = scaled_to_body(parse_character(nodding.text(), "one.gltf"), standard);
    std::mt19937_64 random(3);
    for (int trial = 0; trial < 5; ++trial) {
      const motion::Pose pose = random_pose(random);
      const auto expected = posed(one, pose);
      const auto drawn = posed(other, pose);
      EXPECT_EQ(drawn[0].positions, expected[0].positions) << unskinned.size();
      EXPECT_EQ(drawn[0].normals, expected[0].normals) << unskinned.size();
    }
  }
}

/// Mean direction from the ankles to the toes in a pose.
Vec3 toes_of(const Character& character, const motion::Pose& pose) {
  const motion::JointTransforms rig = rig_pose(character, pose);
  const auto at = [&](motion::BodyJoint joint) {
    return rig.positions[static_cast<size_t>(character.joints[joint].position)];
  };
  return (at(motion::LeftToe) - at(motion::LeftAnkle) + at(motion::RightToe) -
          at(motion::RightAnkle))
      .normalized();
}

TEST(ACharacter, ThatIsMirroredFacesForward) {
  // A node of negative scale above the skeleton shows the mirror image of what was modelled.
  SkinnedGltf file = test::skinned_gltf(standard, {{}, test::mixamo_names()});
  nlohmann::json& nodes = file.json["nodes"];
  nodes.push_back({{"name", "Armature"}, {"scale", {-1.0, 1.0, 1.0}}, {"children", {0}}});
  const Character character =
      scaled_to_body(parse_character(file.text(), "mirrored.gltf"), standard);
  motion::Pose pose;
  pose.root_position = Vec3(0.0, 1.0, 0.0);
  pose.rotations.assign(motion::body_joint_count, Quat::Identity());
  EXPECT_GT(toes_of(character, pose).z(), 0.7);
  // Its left side is the one that goes with the body's left.
  const motion::JointTransforms rig = rig_pose(character, pose);
  const auto left = static_cast<size_t>(character.joints[motion::LeftWrist].position);
  EXPECT_GT(rig.positions[left].x(), 0.3);
  // Triangles are seen from outside: the volume that they enclose is positive.
  const render::Mesh mesh = posed(character, pose)[0];
  double volume = 0.0;
  for (const auto& triangle : mesh.triangles) {
    const auto corner = [&](size_t k) {
      return Vec3(mesh.positions[static_cast<size_t>(triangle[k])].cast<double>());
    };
    volume += corner(0).dot(corner(1).cross(corner(2)));
  }
  const Character plain = scaled_to_body(
      parse_character(test::skinned_gltf(standard, {{}, test::mixamo_names()}).text(), "p.gltf"),
      standard);
  double expected = 0.0;
  const render::Mesh plain_mesh = posed(plain, pose)[0];
  for (const auto& triangle : plain_mesh.triangles) {
    const auto corner = [&](size_t k) {
      return Vec3(plain_mesh.positions[static_cast<size_t>(triangle[k])].cast<double>());
    };
    expected += corner(0).dot(corner(1).cross(corner(2)));
  }
  EXPECT_NEAR(volume, expected, 1e-6);
}

TEST(ACharacter, OfVrmIsKnownByItsHumanoidBones) {
  // The nodes' own names say the opposite.
  SkinnedGltf file = test::skinned_gltf(standard, {{}, test::mixamo_names()});
  for (auto& node : file.json["nodes"]) {
    if (node.contains("name")) node["name"] = "LeftArm";
  }
  SkinnedGltf older = file;
  const std::vector<std::string> names = test::vrm_names();
  for (size_t j = 0; j < names.size(); ++j) {
    file.json["extensions"]["VRMC_vrm"]["humanoid"]["humanBones"][names[j]]["node"] = j;
    older.json["extensions"]["VRM"]["humanoid"]["humanBones"].push_back(
        {{"bone", names[j]}, {"node", j}});
  }
  expect_follows(file, 1e-5);
  expect_follows(older, 1e-5);
  for (const SkinnedGltf* vrm : {&file, &older}) {
    const Character character = parse_character(vrm->text(), "figure.vrm");
    for (const motion::MappedJoint& joint : character.joints) EXPECT_EQ(joint.found_by, "name");
  }
}

/// How the rig's joint is turned against its parent when the body's joint is twisted about its bone
/// and bent a little, radians about the bone.
double twist_drawn(motion::BodyJoint joint, double twist) {
  const Character character =
      parse_character(test::skinned_gltf(standard, {{}, test::mixamo_names()}).text(), "f.gltf");
  const Vec3 bone = motion::rest_direction(joint);
  motion::Pose pose;
  pose.rotations.assign(motion::body_joint_count, Quat::Identity());
  pose.rotations[motion::Pelvis] = motion::exp(Vec3(0.1, 2.0, 0.2));
  const Quat bend = motion::exp(0.3 * bone.unitOrthogonal());
  pose.rotations[joint] = bend * motion::exp(twist * bone);
  const motion::JointTransforms rig = rig_pose(character, pose);
  const auto parent = static_cast<size_t>(motion::body_parents[joint]);
  const Quat drawn = rig.rotations[parent].conjugate() * rig.rotations[joint];
  EXPECT_LT((drawn * bone - bend * bone).norm(), 1e-6) << "the bone points elsewhere";
  return motion::log(motion::twist_about(drawn, bone)).dot(bone);
}

TEST(ACharacter, DoesNotTwistItsEndsFurtherThanTheyGo) {
  const double degree = motion::radians_per_degree;
  for (const motion::BodyJoint toe : {motion::LeftToe, motion::RightToe}) {
    EXPECT_NEAR(std::abs(twist_drawn(toe, 180.0 * degree)), 30.0 * degree, 1e-6);
    EXPECT_NEAR(twist_drawn(toe, -70.0 * degree), -30.0 * degree, 1e-6);
    EXPECT_NEAR(twist_drawn(toe, 20.0 * degree), 20.0 * degree, 1e-6);
  }
  for (const motion::BodyJoint end : {motion::Head, motion::LeftWrist, motion::RightWrist}) {
    EXPECT_NEAR(twist_drawn(end, 170.0 * degree), 110.0 * degree, 1e-6);
    EXPECT_NEAR(twist_drawn(end, -90.0 * degree), -90.0 * degree, 1e-6);
  }
  EXPECT_NEAR(twist_drawn(motion::LeftElbow, 170.0 * degree), 170.0 * degree, 1e-6);
}

TEST(ACharacter, HasLegsAsLongAsTheBodysAndStandsOnTheFloor) {
  const SkinnedGltf file =
      test::skinned_gltf(motion::standard_body(1.2), {{}, test::mixamo_names()});
  const Character character = scaled_to_body(parse_character(file.text(), "figure.gltf"), standard);
  EXPECT_NEAR(motion::leg_length(character.body), motion::leg_length(standard), 1e-6);
  motion::Clip clip;
  clip.body = standard;
  motion::Pose stand;
  stand.rotations.assign(motion::body_joint_count, Quat::Identity());
  stand.root_position.y() = 0.96;  // the soles at 0
  clip.poses.assign(5, stand);
  float lowest = 1.0f;
  for (const render::Mesh& mesh : posed(character, retargeted_to(character, clip).poses.front())) {
    for (const render::Vec3& p : mesh.positions) lowest = std::min(lowest, p.y());
  }
  EXPECT_NEAR(lowest, 0.0f, 0.01f);
}

TEST(ACharacter, BringsItsColoursAlong) {
  const Character character =
      parse_character(test::skinned_gltf(standard, {{}, test::mixamo_names()}).text(), "f.gltf");
  ASSERT_EQ(character.textures.size(), 1u);
  EXPECT_EQ(character.textures[0].width, 2);
  EXPECT_LT((character.textures[0].texels[0] - render::Color(1, 0, 0)).matrix().norm(), 1e-6f);
  EXPECT_LT((character.textures[0].texels[1] - render::Color(0, 1, 0)).matrix().norm(), 1e-6f);
  const render::Material& material =
      character.materials[static_cast<size_t>(character.meshes[0].material)];
  EXPECT_FLOAT_EQ(material.albedo[0], 0.5f);
  EXPECT_EQ(material.texture, 0);
  render::Scene scene;
  scene.materials.push_back({});
  add_character(scene, character, a_pose());
  EXPECT_NO_THROW(render::validate(scene));
  const render::Mesh& mesh = scene.solids.meshes[0];
  EXPECT_EQ(scene.materials[static_cast<size_t>(mesh.material)].texture, 0);
  for (const std::string name : {"RightToe", "LeftWrist"})
    EXPECT_TRUE(std::ranges::any_of(mesh.triangle_parts, [&](int part) {
      return scene.parts[static_cast<size_t>(part)].name == name;
    })) << name;
}

TEST(ACharacter, ReadsTexturesThatAreWebPAlone) {
  SkinnedGltf file = test::skinned_gltf(standard, {{}, test::mixamo_names()});
  file.json["images"][0] = {{"uri", test::webp_halves()}, {"mimeType", "image/webp"}};
  file.json["textures"][0].erase("source");
  file.json["textures"][0]["extensions"] = {{"EXT_texture_webp", {{"source", 0}}}};
  const Character character = parse_character(file.text(), "f.gltf");
  EXPECT_TRUE(character.warnings.empty());
  ASSERT_EQ(character.textures.size(), 1u);
  const render::Texture& texture = character.textures[0];
  ASSERT_EQ(texture.width, 16);
  EXPECT_GT(texture.texels[0][0], 0.9f);
  EXPECT_LT(texture.texels[0][1], 0.01f);
  EXPECT_GT(texture.texels[15][1], 0.8f);
  EXPECT_LT(texture.texels[15][0], 0.01f);
  file.json["textures"][0]["extensions"]["EXT_texture_webp"]["source"] = 3;
  EXPECT_THROW(parse_character(file.text(), "f.gltf"), Error);
}

TEST(ACharacter, ReadsNormalMapsAsNumbersNotColours) {
  SkinnedGltf file = test::skinned_gltf(standard, {{}, test::mixamo_names()});
  file.json["materials"][0]["normalTexture"] = {{"index", 0}, {"scale", 0.5}};
  const Character character = parse_character(file.text(), "f.gltf");
  EXPECT_TRUE(character.warnings.empty());
  ASSERT_EQ(character.textures.size(), 2u);
  render::Scene scene;
  scene.textures.push_back(&character.textures[0]);
  add_character(scene, character, a_pose());
  EXPECT_NO_THROW(render::validate(scene));
  const render::Material& material =
      scene.materials[static_cast<size_t>(scene.solids.meshes[0].material)];
  EXPECT_EQ(material.texture, 1);
  EXPECT_EQ(material.normal_map, 2);
  EXPECT_EQ(material.normal_scale, 0.5f);
  file.json["materials"][0]["normalTexture"]["scale"] = "much";
  EXPECT_THROW(parse_character(file.text(), "f.gltf"), Error);
}

TEST(ACharacter, SaysWhatItLeavesOut) {
  SkinnedGltf file = test::skinned_gltf(standard, {{}, test::mixamo_names()});
  file.json["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", 0}}};
  file.json["materials"][0]["normalTexture"] = {{"index", 0}, {"texCoord", 1}};
  file.json["materials"][0]["alphaMode"] = "BLEND";
  const Character character = parse_character(file.text(), "f.gltf");
  std::string all;
  for (const std::string& warning : character.warnings) all += warning + "\n";
  EXPECT_EQ(all.find("target"), std::string::npos) << all;
  EXPECT_NE(all.find("opaque"), std::string::npos) << all;
  EXPECT_NE(all.find("second texture coordinates"), std::string::npos) << all;
}

struct Fault {
  const char* name;
  std::function<void(SkinnedGltf&)> make;
  const char* words;
};

void PrintTo(const Fault& fault, std::ostream* out) { *out << fault.name; }

class AFaultyCharacter : public testing::TestWithParam<Fault> {};

TEST_P(AFaultyCharacter, IsRefusedInPlainWords) {
  SkinnedGltf file = test::skinned_gltf(standard, {{}, test::mixamo_names()});
  GetParam().make(file);
  try {
    parse_character(file.text(), "broken.gltf");
    FAIL() << "taken";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("broken.gltf"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find(GetParam().words), std::string::npos) << error.what();
  }
}

nlohmann::json& primitive_of(SkinnedGltf& file) { return file.json["meshes"][0]["primitives"][0]; }

/// Overwrites a number in the buffer where an accessor begins.
template <typename Number>
void put_first(SkinnedGltf& file, const nlohmann::json& accessor, Number number) {
  const auto view = file.json["accessors"][accessor.get<size_t>()]["bufferView"].get<size_t>();
  const auto offset = file.json["bufferViews"][view]["byteOffset"].get<size_t>();
  std::memcpy(file.buffer.data() + offset, &number, sizeof number);
}

INSTANTIATE_TEST_SUITE_P(
    Ways, AFaultyCharacter,
    testing::Values(
        Fault{"NoSkin",
              [](SkinnedGltf& f) {
                f.json.erase("skins");
                f.json["nodes"][21].erase("skin");
              },
              "holds no skin"},
        Fault{"NoJoints",
              [](SkinnedGltf& f) { f.json["skins"][0]["joints"] = nlohmann::json::array(); },
              "no joints"},
        Fault{"UnknownJoint", [](SkinnedGltf& f) { f.json["skins"][0]["joints"][3] = 99; },
              "joint that does not exist"},
        Fault{"UnknownSkin", [](SkinnedGltf& f) { f.json["nodes"][21]["skin"] = 4; },
              "there is no skin 4"},
        Fault{"UnknownMesh", [](SkinnedGltf& f) { f.json["nodes"][21]["mesh"] = 7; },
              "there is no mesh 7"},
        Fault{"UnknownMaterial", [](SkinnedGltf& f) { primitive_of(f)["material"] = 5; },
              "there is no material 5"},
        Fault{"UnknownAccessor",
              [](SkinnedGltf& f) { primitive_of(f)["attributes"]["POSITION"] = 77; },
              "there is no POSITION 77"},
        Fault{"NotANumber",
              [](SkinnedGltf& f) {
                put_first(f, primitive_of(f)["attributes"]["POSITION"],
                          std::numeric_limits<float>::quiet_NaN());
              },
              "not finite"},
        Fault{
            "VertexOutOfRange",
            [](SkinnedGltf& f) { put_first(f, primitive_of(f)["indices"], std::uint16_t{60000}); },
            "there is no vertex 60000"},
        Fault{"JointOutOfRange",
              [](SkinnedGltf& f) {
                put_first(f, primitive_of(f)["attributes"]["JOINTS_0"], std::uint8_t{200});
              },
              "no joint 200"},
        Fault{"NoWeights", [](SkinnedGltf& f) { primitive_of(f)["attributes"].erase("WEIGHTS_0"); },
              "no joints or weights"},
        Fault{"FewInverses",
              [](SkinnedGltf& f) {
                f.json["accessors"][f.json["skins"][0]["inverseBindMatrices"].get<size_t>()]
                      ["count"] = 3;
              },
              "fewer than joints"},
        Fault{"Circle", [](SkinnedGltf& f) { f.json["nodes"][8]["children"] = {6}; },
              "two parents"},
        Fault{"MissingPicture", [](SkinnedGltf& f) { f.json["images"][0]["uri"] = "skin.png"; },
              "pictures are not in the file"},
        Fault{"BrokenPicture",
              [](SkinnedGltf& f) { f.json["images"][0]["uri"] = "data:image/png;base64,AAAA"; },
              "cannot be decoded"},
        Fault{"OnlyPoints", [](SkinnedGltf& f) { primitive_of(f)["mode"] = 0; }, "no triangles"},
        Fault{"Compressed",
              [](SkinnedGltf& f) { f.json["extensionsRequired"] = {"KHR_draco_mesh_compression"}; },
              "Draco"},
        Fault{"NotHuman",
              [](SkinnedGltf& f) {
                f.json["skins"][0]["joints"] = {0, 1, 2, 3, 4};
                f.json["skins"][0].erase("inverseBindMatrices");
                auto& attributes = primitive_of(f)["attributes"];
                attributes.erase("JOINTS_0");
                f.json["nodes"][21].erase("skin");
                f.json["nodes"][4]["mesh"] = 0;
                f.json["nodes"][4]["skin"] = 0;
              },
              "no joints or weights"}),
    [](const testing::TestParamInfo<Fault>& fault) { return std::string(fault.param.name); });

TEST(AFaultyCharacter, WithAPictureFileThatIsNotThereNamesIt) {
  const SkinnedGltf file = test::skinned_gltf(standard, {{}, test::mixamo_names()});
  SkinnedGltf broken = file;
  broken.json["images"][0]["uri"] = "skin.png";
  const std::filesystem::path path =
      std::filesystem::path(testing::TempDir()) /
      (std::to_string(::getpid()) + "-" + "character_without_picture.gltf");
  std::ofstream(path) << broken.text();
  try {
    read_character(path);
    FAIL() << "taken";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("skin.png"), std::string::npos) << error.what();
  }
  const std::vector<std::filesystem::path> parts = {path.parent_path() / "skin.png"};
  EXPECT_EQ(files_of_character(path), parts);
  std::filesystem::remove(path);
}

TEST(ACharacter, CutShortAnywhereIsRefused) {
  const std::string text = test::skinned_gltf(standard, {{}, {}}).text();
  for (size_t length = 0; length < text.size(); length += text.size() / 60 + 1) {
    EXPECT_THROW(parse_character(text.substr(0, length), "cut.gltf"), Error) << length;
  }
}

TEST(ACharacter, DamagedAnyhowIsTakenOrRefused) {
  std::mt19937_64 random(29);
  const auto below = [&](size_t n) { return static_cast<size_t>(random() % n); };
  int refused = 0;
  for (int trial = 0; trial < 400; ++trial) {
    SkinnedGltf file = test::skinned_gltf(standard, {{}, test::mixamo_names()});
    for (size_t k = below(4); k > 0; --k) {
      file.buffer[below(file.buffer.size())] = static_cast<unsigned char>(random());
    }
    std::string text = file.text();
    const size_t payload = text.find("base64");  // of the buffer, which comes first
    const size_t rest = text.find('"', payload);
    for (size_t k = below(3) + 1; k > 0; --k) {
      const size_t at = rest + below(text.size() - rest);
      constexpr std::string_view likely = "0123456789[]{},:\"-en.";
      text[at] = likely[below(likely.size())];
    }
    try {
      const Character character = parse_character(text, "damaged.gltf");
      EXPECT_FALSE(character.meshes.empty());
    } catch (const Error&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 100);
}

}  // namespace
}  // namespace mien::scenes

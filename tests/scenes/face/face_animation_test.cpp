// Weights of faces that glTF files animate.

#include "scenes/face/face_animation.h"

#include <cstring>
#include <functional>

#include <gtest/gtest.h>

#include "motion/refusal.h"
#include "scenes/skinned_gltf.h"

namespace mien::scenes {
namespace {

using nlohmann::json;

mien::test::SkinnedGltf animated_boxes() {
  mien::test::SkinnedGltf file =
      mien::test::skinned_gltf(motion::standard_body(), {{}, mien::test::vrm_names()});
  mien::test::add_face(file);
  return file;
}

TEST(AFaceAnimation, IsThatOfTheFile) {
  mien::test::SkinnedGltf file = animated_boxes();
  const motion::FaceTrack rise = parse_face_animation(file.text(), "face.gltf", "");
  ASSERT_EQ(rise.size(), 2u);
  EXPECT_EQ(rise[0].name, "one");
  EXPECT_NEAR(weight_at(rise[0], 0.25), 0.25, 1e-6);
  EXPECT_NEAR(weight_at(rise[0], 9.0), 1.0, 1e-6);
  EXPECT_EQ(weight_at(rise[1], 0.5), 0.0);
  const motion::FaceTrack fall = parse_face_animation(file.text(), "face.gltf", "Fall");
  EXPECT_NEAR(weight_at(fall[0], 0.25), 0.75, 1e-6);
  file.json["animations"][0]["samplers"][0]["interpolation"] = "STEP";
  const motion::FaceTrack step = parse_face_animation(file.text(), "face.gltf", "Rise");
  EXPECT_EQ(weight_at(step[0], 0.99), 0.0);
}

/// In VRM animations the x of a node's translation is the weight of an expression.
TEST(AFaceAnimation, IsThatOfAVrmAnimation) {
  mien::test::SkinnedGltf file = animated_boxes();
  const std::size_t times = file.json["animations"][0]["samplers"][0]["input"];
  const std::size_t values = file.json["meshes"][0]["primitives"][0]["attributes"]["POSITION"];
  json two = file.json["accessors"][values];
  two["count"] = 2;
  file.json["accessors"].push_back(two);
  file.json["nodes"].push_back({{"name", "happy"}});
  const std::size_t node = file.json["nodes"].size() - 1;
  file.json["animations"] = {
      {{"samplers", {{{"input", times}, {"output", file.json["accessors"].size() - 1}}}},
       {"channels", {{{"sampler", 0}, {"target", {{"node", node}, {"path", "translation"}}}}}}}};
  json& expressions = file.json["extensions"]["VRMC_vrm_animation"]["expressions"];
  expressions["preset"]["happy"]["node"] = node;
  const motion::FaceTrack track = parse_face_animation(file.text(), "smile.vrma", "");
  ASSERT_EQ(track.size(), 1u);
  EXPECT_EQ(track[0].name, "happy");
  EXPECT_EQ(track[0].values.size(), 2u);
  float x = 0.0f;  // of the second position
  std::memcpy(&x, file.buffer.data() + 12, sizeof x);
  EXPECT_NEAR(weight_at(track[0], 1.0), static_cast<double>(x), 1e-6);
  expressions["preset"]["happy"]["node"] = 999;
  const std::string said =
      mien::test::refusal_of([&] { parse_face_animation(file.text(), "smile.vrma", ""); });
  EXPECT_NE(said.find("expression \"happy\": there is no node 999"), std::string::npos) << said;
}

TEST(AFaceAnimation, IsRefusedWhenItIsFaulty) {
  const auto refused = [](const std::function<void(json&)>& change, const std::string& take,
                          const std::string& wrong) {
    mien::test::SkinnedGltf file = animated_boxes();
    change(file.json);
    const std::string said =
        mien::test::refusal_of([&] { parse_face_animation(file.text(), "face.gltf", take); });
    EXPECT_NE(said.find(wrong), std::string::npos) << said;
  };
  const auto sampler = [](json& file) -> json& { return file["animations"][0]["samplers"][0]; };
  refused([](json&) {}, "Rize",
          "no animation of a face is called \"Rize\"; did you mean \"Rise\"?");
  refused([](json& file) { file.erase("animations"); }, "", "it has no animation of a face");
  refused([&](json& file) { sampler(file)["interpolation"] = "CUBICSPLINE"; }, "",
          "more or fewer weights than keys");
  refused([&](json& file) { sampler(file)["interpolation"] = "ROUND"; }, "",
          "an interpolation that glTF does not know");
  refused([&](json& file) { sampler(file)["input"] = sampler(file)["output"]; }, "",
          "the key times of weights do not increase");
  refused([&](json& file) { file["animations"][0]["channels"][0]["sampler"] = 7; }, "",
          "a track has no sampler");
  refused([&](json& file) { file["animations"][0]["channels"][0]["target"]["node"] = 0; }, "",
          "weights of a node without a mesh");
}

}  // namespace
}  // namespace mien::scenes

#include <cstring>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "motion/formats/motion_file.h"
#include "motion/procedural/builtin_sets.h"
#include "motion/skeleton/hand.h"
#include "pipeline/manifest/checks/checked_manifest.h"
#include "pipeline/production/synthesis/motions.h"
#include "pipeline/study/studio/studio_fixture.h"
#include "scenes/skinned_gltf.h"

// What a page may choose beside the manifest, asked for as pages do.

namespace mien::pipeline {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

TEST_F(Studio, TakesAFolderOfCapturesAsExamples) {
  const motion::ExampleSet walks = motion::builtin_examples("walks-10");
  fs::create_directory(folder_.path() / "captures");
  for (std::size_t i = 0; i < 4; ++i) {
    const motion::Clip walked = motion::repeated(walks.examples[i].clip, 3);
    motion::write_motion(motion::to_recording(walked),
                         folder_.path() / "captures" / (walks.examples[i].name + ".bvh"));
  }
  const ordered_json places = ordered_json::parse(post("places", ordered_json::object()).body);
  EXPECT_EQ(places["folders"][0]["folder"], "captures");
  EXPECT_EQ(places["folders"][0]["motions"].size(), 4u);

  ordered_json draft = document();
  draft["examples"] = {{"set", {{"folder", "captures"}}}, {"ratings", "simulated"}};
  const HttpResponse told = post("choices", {{"document", draft}});
  ASSERT_EQ(told.status, 200) << told.body;
  EXPECT_EQ(ordered_json::parse(told.body)["examples"].size(), 4u);
  draft["examples"]["set"]["include"] =
      "{" + walks.examples[0].name + "," + walks.examples[1].name + "}*";
  draft["stimuli"][2]["weights"] = {{walks.examples[0].name, 1.0}};
  EXPECT_EQ(post("motion", {{"document", draft}, {"show", "mix-1"}}).status, 200);
  ordered_json wrong = draft;
  wrong["stimuli"][2]["weights"] = {{walks.examples[3].name, 1.0}};  // the pattern leaves it out
  const auto save = [&](const ordered_json& changed) {
    return post("save", {{"document", changed},
                         {"text", changed.dump(2)},
                         {"version", file_.state().version}})
        .status;
  };
  EXPECT_EQ(save(wrong), 422);
  draft["stimuli"] = {draft["stimuli"][2]};
  draft.erase("sheets");
  EXPECT_EQ(save(draft), 200);
  EXPECT_NE(read_file(file_.file()).find("\"captures\""), std::string::npos);
}

TEST_F(Studio, GivesTheFigureThatIsShown) {
  ordered_json draft = document();
  const auto figure = [&] {
    return head_of(post("motion", {{"document", draft}, {"show", "mix-1"}}))["figure"];
  };
  EXPECT_EQ(figure()["key"], "");
  draft["look"]["figure"] = {{"mannequin", {{"build", 0.8}}}};
  const ordered_json heavy = figure();
  EXPECT_EQ(heavy["joints"], 0);
  ordered_json asked = {{"document", draft}, {"show", "mix-1"}, {"key", heavy["key"]}};
  const HttpResponse file = post("figure", asked);
  EXPECT_EQ(file.type, "model/gltf-binary");
  EXPECT_EQ(file.body.substr(0, 4), "glTF");
  draft["look"]["figure"] = "mannequin";
  EXPECT_NE(figure()["key"], heavy["key"]);
  asked["document"] = draft;
  EXPECT_EQ(post("figure", asked).status, 404);
}

TEST_F(Studio, GivesTheFingersOfAMannequinThatAreShown) {
  ordered_json draft = document();
  draft["look"] = {{"figure", "mannequin"}, {"hands", "drawn"}};
  const HttpResponse response = post("motion", {{"document", draft}, {"show", "guess-1"}});
  const ordered_json figure = head_of(response)["figure"];
  constexpr int joints = motion::body_joint_count + motion::finger_joint_count;
  ASSERT_EQ(figure["joints"], joints);
  const HttpResponse file =
      post("figure", {{"document", draft}, {"show", "guess-1"}, {"key", figure["key"]}});
  EXPECT_NE(file.body.find("RightIndex2"), std::string::npos);

  // The last frame's last finger joint, as the renderer has it.
  const Manifest manifest = load_manifest(file_.file(), process_environment());
  Motions motions(manifest);
  const motion::Clip clip = motions.of("guess-1").motion.clip;
  const motion::JointTransforms hands = motion::world_transforms(
      motion::with_fingers(clip.body), motion::with_fingers(clip.poses.back()));
  const std::size_t rotations = clip.poses.size() * static_cast<std::size_t>(4 * joints);
  std::vector<float> last(3);
  std::memcpy(last.data(), response.body.data() + response.body.size() - 4 * rotations - 12, 12);
  EXPECT_LT(
      (Eigen::Vector3f(last[0], last[1], last[2]).cast<double>() - hands.positions.back()).norm(),
      1e-6);
  draft["look"]["hands"] = "hidden";
  const ordered_json hidden =
      head_of(post("motion", {{"document", draft}, {"show", "guess-1"}}))["figure"];
  EXPECT_EQ(hidden["joints"], 0);
  EXPECT_NE(hidden["key"], figure["key"]);
}

TEST_F(Studio, MovesACharacterAsFilmsDo) {
  const auto robot = test::skinned_gltf(motion::standard_body(1.3), {{}, test::mixamo_names()});
  write_file(folder_.path() / "robot.gltf", robot.text());
  ordered_json draft = document();
  draft["look"]["figure"] = {{"character", "robot.gltf"}};
  const ordered_json asked = {{"document", draft}, {"show", "guess-1"}};
  const HttpResponse response = post("motion", asked);
  const ordered_json figure = head_of(response)["figure"];
  const int joints = figure["joints"];
  EXPECT_EQ(joints, motion::body_joint_count);

  // The last frame's first joint, as the renderer has it.
  const Manifest manifest = load_manifest(file_.file(), process_environment());
  Motions motions(manifest);
  const motion::Clip clip = motions.of("guess-1").motion.clip;
  const scenes::Character fitted_figure =
      scenes::scaled_to_body(scenes::read_character(folder_.path() / "robot.gltf"), clip.body);
  const motion::JointTransforms rig =
      scenes::rig_pose(fitted_figure, scenes::retargeted_to(fitted_figure, clip).poses.back());
  const std::size_t floats = clip.poses.size() * static_cast<std::size_t>(7 * joints);
  std::vector<float> poses(floats);
  std::memcpy(poses.data(), response.body.data() + response.body.size() - 4 * floats, 4 * floats);
  const float* last = poses.data() + (clip.poses.size() - 1) * static_cast<std::size_t>(3 * joints);
  EXPECT_LT((Eigen::Vector3f(last[0], last[1], last[2]).cast<double>() - rig.positions[0]).norm(),
            1e-6);
  const float* turned = poses.data() + poses.size() - 4;
  EXPECT_NEAR(turned[3], rig.rotations.back().w(), 1e-6);
  draft["look"]["figure"] = {{"character", "../robot.gltf"}};
  EXPECT_EQ(post("motion", {{"document", draft}, {"show", "guess-1"}}).status, 422);
}

TEST_F(Studio, ShowsTheFaceOfACharacter) {
  auto robot = test::skinned_gltf(motion::standard_body(1.3), {{}, test::mixamo_names()});
  test::add_face(robot);
  write_file(folder_.path() / "robot.gltf", robot.text());
  write_file(folder_.path() / "half.csv", "time,one\n0,0.5\n");
  ordered_json draft = document();
  draft["look"]["figure"] = {{"character", "robot.gltf"}};
  const auto figure = [&](const ordered_json& face) {
    draft["look"]["face"] = face;
    ordered_json asked = {{"document", draft}, {"show", "guess-1"}};
    const HttpResponse told = post("motion", asked);
    EXPECT_EQ(told.status, 200) << told.body;
    asked["key"] = head_of(told)["figure"]["key"];
    return std::pair(asked["key"].get<std::string>(), post("figure", asked).body);
  };
  const auto [key, plain] = figure("neutral");
  const auto [half_key, half] = figure({{"one", 0.5}});
  const auto [hidden_key, hidden] = figure("hidden");
  EXPECT_EQ(half_key, key);
  EXPECT_EQ(half, plain);
  EXPECT_NE(hidden_key, key);
  EXPECT_GT(hidden.size(), plain.size());
  draft["look"]["face"] = {{"one", 0.5}};
  const HttpResponse told = post("motion", {{"document", draft}, {"show", "guess-1"}});
  const ordered_json shown = head_of(told)["figure"];
  EXPECT_EQ(shown["morphs"], 2);
  EXPECT_EQ(shown["face_frames"], 1);
  std::vector<float> weights(2);
  std::memcpy(weights.data(), told.body.data() + told.body.size() - 8, 8);
  EXPECT_EQ(weights, (std::vector<float>{0.5f, 0.0f}));
  // A page chooses no files that the manifest does not name.
  draft["look"]["face"] = {{"file", "half.csv"}};
  EXPECT_EQ(post("motion", {{"document", draft}, {"show", "guess-1"}}).status, 422);
}

}  // namespace
}  // namespace mien::pipeline

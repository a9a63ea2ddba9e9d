#include <algorithm>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "motion/formats/motion_format.h"
#include "pipeline/base/reading/field_names.h"
#include "pipeline/base/reading/field_writer.h"
#include "pipeline/base/reading/schema.h"
#include "pipeline/manifest/checks/manifest_reader.h"
#include "pipeline/manifest/look/point_form.h"
#include "pipeline/manifest/look/set_fields.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/manifest/reading/recipes.h"
#include "pipeline/manifest/schema_paths.h"

namespace mien::pipeline {
namespace {

using nlohmann::json;

template <class Struct>
std::set<std::string> listed() {
  FieldNames names;
  names.of<Struct>();
  std::set<std::string> paths;
  for (const auto& [path, concerned] : names.names()) paths.insert(path);
  return paths;
}

std::set<std::string> in_schema(const json& schema) {
  std::set<std::string> paths;
  for (const auto& [path, node] : test::properties_of(schema)) paths.insert(path);
  return paths;
}

TEST(Fields, OfAManifestAreThoseOfItsSchema) {
  EXPECT_GT(in_schema(manifest_schema()).size(), 200u);
  EXPECT_EQ(listed<Manifest>(), in_schema(manifest_schema()));
}

TEST(Fields, OfASetAreThoseOfItsSchema) {
  EXPECT_EQ(listed<scenes::SetPlan>(), in_schema(set_schema()));
}

TEST(Fields, OfRecipesAreThoseOfTheirSchema) {
  EXPECT_EQ(listed<RecipeBook>(), in_schema(recipes_schema()));
}

TEST(Fields, ForMotionFilesAllowTheFormatsThatAreWritten) {
  std::vector<std::string> written;
  for (const motion::MotionFormat& format : motion::motion_formats())
    if (format.is_of_clips()) written.emplace_back(format.ending.substr(1));
  const json& clips = manifest_schema()["definitions"]["output"]["properties"]["clips"];
  EXPECT_EQ(clips["items"]["enum"], json(written));
  EXPECT_EQ(clips["maxItems"], written.size());
  for (const char* needed : {"bvh", "glb", "trc", "npz", "csv"})
    EXPECT_EQ(std::ranges::count(written, needed), 1) << needed;
}

/// Each default that the schema states under `path` beside what a struct has unless told.
template <class Struct>
void expect_defaults(const std::string& path) {
  const auto properties = test::properties_of(manifest_schema());
  int compared = 0;
  for (const FieldEntry& entry : entries_of(Struct{}, {})) {
    const auto property = properties.find(path + "." + entry.path);
    if (property == properties.end() || !property->second.contains("default")) continue;
    if (entry.path.starts_with("look.")) continue;  // what was left open is told by scene_of
    const json& stated = property->second["default"];
    EXPECT_EQ(stated.is_array() && stated.empty() ? json(nullptr) : stated, json(entry.value))
        << property->first;
    ++compared;
  }
  EXPECT_GT(compared, 0) << path;
}

TEST(Fields, HaveTheDefaultsThatTheSchemaStates) {
  expect_defaults<Output>("output");
  expect_defaults<Interpolation>("interpolation");
  expect_defaults<Examples>("examples.set");
  expect_defaults<scenes::CameraSettings>("look.camera");
  expect_defaults<scenes::DepthOfField>("look.camera.depth_of_field");
  expect_defaults<scenes::MannequinOptions>("look.figure.mannequin");
  expect_defaults<scenes::PointLightOptions>("look.figure.point-light");
  expect_defaults<scenes::TrailOptions>("look.figure.trail");
  expect_defaults<motion::Modification>("stimuli[].modify");
  expect_defaults<motion::PathGains>("stimuli[].modify.gains");
  expect_defaults<StyleStep>("stimuli[].modify");
  expect_defaults<motion::DriveEditing>("stimuli[].modify.drives[]");
  expect_defaults<motion::AnimatorKey>("stimuli[].modify.keys[]");
  expect_defaults<motion::MotionConstraint>("stimuli[].modify.constraints[]");
  expect_defaults<Stimulus>("stimuli[]");
  expect_defaults<Overlay>("overlays[]");
  expect_defaults<Sheet>("sheets[]");
  expect_defaults<Questionnaire>("questionnaire");
  expect_defaults<Demographic>("questionnaire.demographics[]");
  expect_defaults<Matching>("matching");
}

Manifest parsed(const std::string& text) {
  const ManifestReading reading =
      parse_manifest(text, "/nowhere/m.yaml", [](const std::string&) { return std::nullopt; });
  EXPECT_TRUE(reading.faults.empty()) << Faults(reading.faults).what();
  return reading.manifest;
}

TEST(Fields, OfFiguresAreOfTheKindsThatTheSchemaNames) {
  const json& definitions = manifest_schema()["definitions"];
  const auto names_of = [](const json& figure) {
    return figure["oneOf"][0]["enum"].get<std::vector<std::string>>();
  };
  EXPECT_EQ(names_of(definitions["look"]["properties"]["figure"]),
            scenes::figure_names<scenes::Figure>());
  EXPECT_EQ(names_of(definitions["figure"]["properties"]["trail"]["properties"]["figure"]),
            scenes::figure_names<scenes::BodyFigure>());
  std::vector<std::string> kinds, exclusive;
  scenes::for_each_kind<scenes::Figure>(
      [&](const auto& options) { kinds.emplace_back(options.kind.name); });
  for (const json& branch : definitions["figure"]["oneOf"])
    exclusive.push_back(branch["required"][0].get<std::string>());
  EXPECT_EQ(exclusive, kinds);
}

std::string with_figure(const std::string& figure) {
  return "mien: 1\nstudy: s\nexamples: {set: builtin:walks-10}\nlook: {figure: " + figure +
         "}\nstimuli: [{id: a, weights: {sad: 1}}]\n";
}

TEST(Fields, OfAFigureMayBeLeftOut) {
  for (const std::string& name : scenes::figure_names<scenes::Figure>()) {
    if (name == "markers") continue;  // not of a blend (look_options_test.cpp)
    const scenes::Figure named = parsed(with_figure(name)).stimuli[0].look.figure;
    EXPECT_EQ(scenes::kind_of(named).name, name);
    EXPECT_EQ(parsed(with_figure("{" + name + ": {}}")).stimuli[0].look.figure, named);
  }
  for (const std::string& name : scenes::figure_names<scenes::BodyFigure>()) {
    const scenes::Figure named =
        parsed(with_figure("{trail: {figure: " + name + "}}")).stimuli[0].look.figure;
    EXPECT_EQ(parsed(with_figure("{trail: {figure: {" + name + ": {}}}}")).stimuli[0].look.figure,
              named);
  }
}

TEST(Fields, OfATrailHaveNoPosesWhereOthersStandInTheirPlace) {
  const auto poses_of = [](const std::string& options) {
    const Manifest manifest = parsed(with_figure("{trail: {" + options + "}}"));
    return std::get<scenes::TrailOptions>(manifest.stimuli[0].look.figure).poses;
  };
  EXPECT_EQ(poses_of(""), 6);
  EXPECT_EQ(poses_of("every: 0.1"), 6);
  EXPECT_EQ(poses_of("after: 2"), 0);
  EXPECT_EQ(poses_of("poses: 2, traces: [feet]"), 2);
}

TEST(Fields, ThatAreWrittenAreReadAgain) {
  const Manifest manifest = parsed(R"(mien: 1
study: s
seed: 3
examples: {set: builtin:walks-10, ratings: simulated, raters: 5}
look: {figure: {trail: {before: 3, figure: {mannequin: {sex: 0.2}}}}, camera: {view: side, fov: 30}}
output: {size: [64, 48], presentation: {card: Look, fixation: {seconds: 0.5, size: 9}}, video: [mp4]}
interpolation: {method: knn, neighbours: 4}
recipes: fig29
equalize: [luminance]
stimuli:
  - {id: a, role: target, adjectives: {quickness: 0.8, clearness: 0.1}, look: {figure: stick}}
  - {id: b, weights: {sad: 2, normal: 1}, output: {fps: 25, crop: [0, 0, 32, 32]}, interpolation: {time_warp: linear},
     modify: [{emotion: sad, posture: {spine-flexion: 4, head-flexion: 12}}, {method: hsu, neutral: normal, styled: sad, order: 4}]}
overlays: [{target: a, created: b, opacity: 0.5, look: {figure: stick}}]
sheets: [{compare: {target: a, created: b}}, {id: both, stills: [a, b], columns: 2}]
questionnaire: {participants: 4, scales: emotions, consent: "yes: no", stimuli: [a, b], order: {blocked: emotion},
  choices: {x: 悲しい, y: y}, trials: emotion, replays: 3, attention: {every: 2}, retest: {repeat: 1}, answer: {points: 7},
  demographics: [{id: age, ask: "How old?", answer: number}, {id: sex, ask: Which, answer: [f, m]}], analysis: {correction: bh}}
)");
  const OrderedJson text = written(manifest, WritingOptions{});
  const Manifest again = parsed(text.dump());
  EXPECT_EQ(written(again, WritingOptions{}), text);
  ASSERT_EQ(again.stimuli.size(), 2u);
  EXPECT_EQ(again.stimuli[1].output, manifest.stimuli[1].output);
  EXPECT_EQ(again.stimuli[0].look.figure, manifest.stimuli[0].look.figure);
  EXPECT_EQ(again.stimuli[1].modify[0].edit.named, manifest.stimuli[1].modify[0].edit.named);
  EXPECT_EQ(again.stimuli[1].modify[1].style->order, 4);
}

TEST(Fields, OfMatchingAreReadAgain) {
  const Manifest manifest = parsed(R"(mien: 1
study: s
examples: {set: builtin:walks-10}
stimuli: [{id: a, weights: {sad: 1}}, {id: b, weights: {normal: 1}}]
matching: {participants: 4, language: ja, consent: "yes: no", targets: [a], practice: [b], interfaces: [weights],
  limit_s: 90.5, threshold_m: 0.05, show_distance: false, target_colour: "#112233", phones: served,
  demographics: [{id: age, ask: "How old?", answer: number}]}
)");
  const OrderedJson text = written(manifest, WritingOptions{});
  const Manifest again = parsed(text.dump());
  EXPECT_EQ(written(again, WritingOptions{}), text);
  ASSERT_TRUE(again.matching);
  EXPECT_EQ(again.matching->interfaces, std::vector<std::string>{"weights"});
  EXPECT_EQ(again.matching->limit_s, 90.5);
  EXPECT_EQ(again.matching->demographics.size(), 1u);
}

TEST(Fields, ThatAreLaidOverOthersLeaveTheRestAsItIs) {
  const Manifest manifest = parsed(R"(mien: 1
study: s
output: {size: [64, 48], fps: 25, presentation: {card: Look, blank_after: 0.5}}
look: {camera: {view: side, fov: 30}}
examples: {set: builtin:walks-10}
stimuli: [{id: a, weights: {sad: 1}, output: {presentation: {blank_after: 0.2}}, look: {camera: {view: front}}}]
)");
  const Stimulus& stimulus = manifest.stimuli[0];
  EXPECT_EQ(stimulus.output.fps, 25.0);
  EXPECT_EQ(stimulus.output.presentation.card, "Look");
  EXPECT_EQ(stimulus.output.presentation.blank_after, 0.2);
  EXPECT_FALSE(stimulus.look.camera.fov_degrees);  // a camera is replaced as a whole
}

}  // namespace
}  // namespace mien::pipeline

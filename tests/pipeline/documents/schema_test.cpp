#include "pipeline/documents/schema.h"

#include <fstream>
#include <iterator>
#include <string>

#include <gtest/gtest.h>

#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {
namespace {

using nlohmann::json;

std::string text_of(const std::string& name) {
  std::ifstream stream(std::string(MIEN_SOURCE_DIR) + "/manifests/" + name);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Calls `visit` for every property of every object in a schema.
template <class Visit>
void for_each_property(const json& node, const std::string& path, const Visit& visit) {
  if (!node.is_structured()) return;
  if (node.is_object() && node.contains("properties")) {
    for (const auto& [key, property] : node["properties"].items())
      visit(path + "/" + key, property);
  }
  for (const auto& [key, child] : node.items()) {
    if (key != "examples" && key != "default") for_each_property(child, path + "/" + key, visit);
  }
}

std::vector<Fault> check(const json& document, const json& schema) {
  return check_schema(document, schema, {});
}

TEST(Schema, IsTheFileOfTheSourceTree) {
  EXPECT_EQ(manifest_schema_text(), text_of("mien.schema.json"));
  EXPECT_EQ(scales_schema_text(), text_of("scales.schema.json"));
}

TEST(Schema, TellsEditorsWhatEveryPropertyMeans) {
  for (const json& schema : {manifest_schema(), scales_schema(), set_schema()}) {
    int count = 0;
    for_each_property(schema, "", [&](const std::string& path, const json& property) {
      ++count;
      const json& node = *narrowed({&schema, &property}, json()).node;
      EXPECT_TRUE(node.contains("title")) << path;
      EXPECT_TRUE(node.contains("description")) << path;
      if (!node.contains("$ref") && node.contains("type") && node["type"] != "object") {
        EXPECT_TRUE(node.contains("examples")) << path;
      }
    });
    EXPECT_GT(count, 8);
  }
}

TEST(Schema, ItsDefaultsAndExamplesAreValid) {
  const json schema = manifest_schema();
  for_each_property(schema, "", [&](const std::string& path, const json& property) {
    json alone = property;
    alone["definitions"] = schema["definitions"];
    for (const json& example : property.value("examples", json::array())) {
      EXPECT_TRUE(check(example, alone).empty()) << path << ": " << example;
    }
    if (property.contains("default")) {
      EXPECT_TRUE(check(property["default"], alone).empty()) << path;
    }
  });
}

TEST(Schema, ItsDefaultsAreThoseOfTheProgram) {
  const json definitions = manifest_schema()["definitions"];
  const auto value = [&](const char* of, const char* key) {
    return definitions[of]["properties"][key]["default"];
  };
  const Look look;
  EXPECT_EQ(value("look", "scene"), scene_of(look));
  EXPECT_EQ(value("look", "figure"), scenes::name_of(look.figure));
  EXPECT_EQ(value("look", "camera"), look.camera.view);
  const Output output;
  EXPECT_EQ(value("output", "size"), output.size);
  EXPECT_EQ(value("output", "fps"), output.fps);
  EXPECT_EQ(value("output", "cycles"), output.cycles);
  EXPECT_EQ(value("output", "in_place"), output.in_place);
  EXPECT_EQ(value("output", "quality") == "standard", output.quality == Quality::standard);
  EXPECT_EQ(value("output", "frames") == "png", output.frames == FrameFormat::png);
  EXPECT_EQ(value("output", "video") == json({"mp4"}),
            output.video == std::vector{render::VideoKind::mp4});
  const json& around = definitions["output"]["properties"]["presentation"]["properties"];
  const Presentation presentation;
  EXPECT_EQ(around["blank_before"]["default"], presentation.blank_before);
  EXPECT_EQ(around["blank_after"]["default"], presentation.blank_after);
  EXPECT_EQ(around["fade_in"]["default"], presentation.fade_in);
  EXPECT_EQ(around["fade_out"]["default"], presentation.fade_out);
  EXPECT_EQ(around["background"]["default"], presentation.background);
  EXPECT_EQ(around["card"]["oneOf"][1]["properties"]["seconds"]["default"],
            presentation.card_seconds);
  EXPECT_EQ(around["fixation"]["oneOf"][1]["properties"]["size"]["default"],
            presentation.fixation_size);
  EXPECT_EQ(value("output", "clips") == json({"bvh"}), output.bvh && !output.glb);
  const Interpolation how;
  EXPECT_EQ(value("interpolation", "foot_lock"), how.foot_lock);
  EXPECT_EQ(value("interpolation", "method"), std::string(motion::name_of(how.weights.method)));
  EXPECT_EQ(value("interpolation", "blends"), how.weights.nearest.trials);
  EXPECT_EQ(value("interpolation", "power"), how.weights.power);
  EXPECT_EQ(value("interpolation", "cells"), how.weights.grid_cells);
  EXPECT_EQ(value("interpolation", "nodes") == "cardinal",
            how.weights.grid_source == motion::GridSource::cardinal);
  EXPECT_EQ(value("interpolation", "drift") == "linear", how.weights.kriging.linear_drift);
  EXPECT_EQ(value("interpolation", "nugget"), how.weights.kriging.nugget);
  EXPECT_EQ(value("interpolation", "variance"), how.weights.pca.variance_share);
  EXPECT_EQ(value("interpolation", "step"), how.weights.click_step);
  EXPECT_EQ(value("interpolation", "rotations") == "karcher-mean",
            how.rotations == motion::RotationBlend::karcher_mean);
  EXPECT_EQ(value("interpolation", "time_warp") == "monotone",
            how.time_warp == motion::WarpShape::monotone);
  EXPECT_EQ(manifest_schema()["properties"]["examples"]["properties"]["raters"]["default"],
            Ratings{}.raters);
}

/// Whatever the validator refuses has a sentence of ours, in every kind of rule that the schema
/// has.
TEST(Schema, FindsWordsForEveryRule) {
  const json schema = json::parse(R"({
    "type": "object", "required": ["n"], "additionalProperties": false,
    "properties": {
      "n": {"type": "integer", "minimum": 1, "maximum": 5},
      "s": {"type": "string", "minLength": 1},
      "p": {"type": "string", "pattern": "^a$", "x-rule": "must be a"},
      "e": {"type": "string", "enum": ["red", "green"]},
      "a": {"type": "array", "minItems": 1, "maxItems": 2, "items": {"type": "boolean"}},
      "u": {"oneOf": [{"type": "string"}, {"type": "object", "required": ["k"]}]},
      "o": {"type": "object", "oneOf": [{"required": ["x"]}, {"required": ["y"]}]}
    }})");
  const auto told = [&](const json& document) {
    const std::vector<Fault> faults = check(document, schema);
    return faults.empty() ? "" : faults[0].path + ": " + faults[0].wrong + "; " + faults[0].remedy;
  };
  EXPECT_EQ(told({{"n", 1}}), "");
  EXPECT_EQ(told(json::object()), "n: missing; add it");
  EXPECT_EQ(told(3), ": must be a map of keys and values but is 3; ");
  EXPECT_EQ(told({{"n", 9}}), "n: 9 is out of range; use a whole number from 1 to 5");
  EXPECT_EQ(told({{"n", 1.5}}), "n: must be a whole number but is 1.5; ");
  EXPECT_EQ(told({{"n", 1}, {"s", ""}}), "s: must not be empty; ");
  EXPECT_EQ(told({{"n", 1}, {"s", 5}}), "s: must be text but is 5; put it in quotes: \"5\"");
  EXPECT_EQ(told({{"n", 1}, {"p", "b"}}), "p: \"b\" must be a; ");
  EXPECT_EQ(told({{"n", 1}, {"e", "gren"}}),
            "e: \"gren\" is not one of red, green; did you mean \"green\"?");
  EXPECT_EQ(told({{"n", 1}, {"e", "blue!"}}),
            "e: \"blue!\" is not one of the choices; use one of red, green");
  EXPECT_EQ(told({{"n", 1}, {"a", json::array()}}), "a: has 0 elements but must have at least 1; ");
  EXPECT_EQ(told({{"n", 1}, {"a", {true, 1}}}),
            "a[1]: must be true or false but is 1; write true or false");
  EXPECT_EQ(told({{"n", 1}, {"u", 1}}), "u: must be text or a map of keys and values but is 1; ");
  EXPECT_EQ(told({{"n", 1}, {"u", json::object()}}), "u.k: missing; add it");
  EXPECT_EQ(told({{"n", 1}, {"o", json::object()}}), "o: has none of x, y; give one of them");
  EXPECT_EQ(told({{"n", 1}, {"o", {{"x", 1}, {"y", 1}}}}),
            "o: x and y exclude each other; keep one of them");
  EXPECT_EQ(told({{"n", 1}, {"nn", 1}}), "nn: unknown key; did you mean \"n\"?");
}

}  // namespace
}  // namespace mien::pipeline

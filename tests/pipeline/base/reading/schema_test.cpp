#include "pipeline/base/reading/schema.h"

#include <fstream>
#include <functional>
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
      const json& node = *resolved_schema({&schema, &property}, json()).node;
      EXPECT_TRUE(node.contains("title")) << path;
      EXPECT_TRUE(node.contains("description")) << path;
      if (!node.contains("$ref") && node.contains("type") && node["type"] != "object") {
        EXPECT_TRUE(node.contains("examples")) << path;
      }
      EXPECT_EQ(node.contains("pattern"), node.contains("x-rule")) << path << " without words";
    });
    EXPECT_GT(count, 8);
  }
}

TEST(Schema, ItsFormerNamesStandBesideTheNewOnes) {
  int count = 0;
  const std::function<void(const json&)> look = [&](const json& node) {
    for (const auto& [key, child] : node.items()) {
      if (child.is_structured()) look(child);
      if (key != "properties") continue;
      for (const auto& [name, property] : child.items()) {
        if (!property.contains("x-now")) continue;
        ++count;
        EXPECT_TRUE(child.contains(property["x-now"].get<std::string>())) << name;
        EXPECT_EQ(property.value("deprecated", false), true) << name;  // as editors show it
      }
    }
  };
  look(manifest_schema());
  EXPECT_GT(count, 0);
}

TEST(Schema, ItsDefaultsAndExamplesAreValid) {
  const json& schema = manifest_schema();
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

TEST(Schema, FindsWordsForEveryRule) {
  const json schema = json::parse(R"({
    "type": "object", "required": ["n"], "additionalProperties": false,
    "properties": {
      "n": {"type": "integer", "minimum": 1, "maximum": 5},
      "s": {"type": "string", "minLength": 1},
      "p": {"type": "string", "pattern": "^a$", "x-rule": "must be a"},
      "e": {"type": "string", "enum": ["red", "green"]},
      "f": {"type": "string", "enum": ["red", "blue"], "x-otherwise": "for others write {rgb: …}"},
      "a": {"type": "array", "minItems": 1, "maxItems": 2, "items": {"type": "boolean"}},
      "r": {"oneOf": [{"type": "string", "enum": ["counted", "none"]},
                      {"type": "integer", "minimum": 0, "maximum": 9}]},
      "w": {"oneOf": [{"type": "string", "enum": ["auto"]}, {"type": "number", "minimum": 2}]},
      "m": {"oneOf": [{"type": "string", "enum": ["red"], "x-otherwise": "for others write {…}"},
                      {"type": "object", "properties": {"rgb": {"type": "string"}}}]},
      "y": {"type": "string", "enum": ["true", "other"]},
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
  EXPECT_EQ(told({{"n", 1}, {"s", ""}}), "s: must not be empty; write a text");
  EXPECT_EQ(told({{"n", 1}, {"s", 5}}), "s: must be text but is 5; put it in quotes: \"5\"");
  // 1.0 must not become "1".
  EXPECT_EQ(told({{"n", 1}, {"s", 1.0}}),
            "s: must be text but is 1; put it in quotes, exactly as it is written");
  EXPECT_EQ(told({{"n", 1}, {"p", "b"}}), "p: \"b\" must be a; ");
  EXPECT_EQ(told({{"n", 1}, {"e", "gren"}}),
            "e: \"gren\" is not one of red, green; did you mean \"green\"?");
  EXPECT_EQ(told({{"n", 1}, {"e", "blue!"}}),
            "e: \"blue!\" is not one of the choices; use one of red, green");
  EXPECT_EQ(
      told({{"n", 1}, {"f", "#00ff00"}}),
      "f: \"#00ff00\" is not one of the choices; use one of red, blue; for others write {rgb: "
      "#00ff00}");
  EXPECT_EQ(told({{"n", 1}, {"e", 2}}), "e: 2 is not one of the choices; use one of red, green");
  EXPECT_EQ(told({{"n", 1}, {"y", true}}),
            "y: must be text but is true; put it in quotes: \"true\"");
  EXPECT_EQ(told({{"n", 1}, {"m", "rgb:ff0000"}}),
            "m: \"rgb:ff0000\" is not one of the choices; use red, or a map of keys and values; "
            "write {rgb: ff0000}, with a space after the colon");
  EXPECT_EQ(told({{"n", 1}, {"m", "rgba:ff"}}),
            "m: \"rgba:ff\" is not one of the choices; use red, or a map of keys and values; for "
            "others write {rgba:ff}");
  EXPECT_EQ(told({{"n", 1}, {"a", json::array()}}),
            "a: has 0 elements but must have at least 1; add elements");
  EXPECT_EQ(told({{"n", 1}, {"a", {true, 1}}}),
            "a[1]: must be true or false but is 1; write true or false");
  // Options that take a choice or a number name both.
  EXPECT_EQ(
      told({{"n", 1}, {"r", "two"}}),
      "r: \"two\" is not one of the choices; use one of counted, none, or a whole number from "
      "0 to 9");
  EXPECT_EQ(told({{"n", 1}, {"r", 10}}),
            "r: 10 is out of range; use a whole number from 0 to 9, or counted, none");
  EXPECT_EQ(told({{"n", 1}, {"r", true}}),
            "r: must be one of counted, none or a whole number but is true; ");
  EXPECT_EQ(told({{"n", 1}, {"w", "much"}}),
            "w: \"much\" is not one of the choices; use auto, or a number of 2 or more");
  EXPECT_EQ(told({{"n", 1}, {"u", 1}}), "u: must be text or a map of keys and values but is 1; ");
  EXPECT_EQ(told({{"n", 1}, {"u", json::object()}}), "u.k: missing; add it");
  EXPECT_EQ(told({{"n", 1}, {"o", json::object()}}), "o: has none of x, y; give one of them");
  EXPECT_EQ(told({{"n", 1}, {"o", {{"x", 1}, {"y", 1}}}}),
            "o: x and y exclude each other; keep one of them");
  EXPECT_EQ(told({{"n", 1}, {"nn", 1}}), "nn: unknown key; did you mean \"n\"?");
}

}  // namespace
}  // namespace mien::pipeline

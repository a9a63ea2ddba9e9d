#include <string>

#include "pipeline/base/reading/schema.h"

#include "embedded/manifest_schema.h"
#include "embedded/recipes_schema.h"
#include "embedded/scales_schema.h"
#include "embedded/set_schema.h"

namespace mien::pipeline {

std::string_view manifest_schema_text() { return embedded_manifest_schema; }
std::string_view scales_schema_text() { return embedded_scales_schema; }
std::string_view recipes_schema_text() { return embedded_recipes_schema; }
std::string_view set_schema_text() { return embedded_set_schema; }

// Each is parsed once: a copy for each option of a command line took a fifth of its start.

const nlohmann::json& manifest_schema() {
  static const nlohmann::json schema = nlohmann::json::parse(manifest_schema_text());
  return schema;
}

const nlohmann::json& scales_schema() {
  static const nlohmann::json schema = nlohmann::json::parse(scales_schema_text());
  return schema;
}

const nlohmann::json& set_schema() {
  static const nlohmann::json schema = nlohmann::json::parse(set_schema_text());
  return schema;
}

namespace {

nlohmann::json with_definitions_of_manifest() {
  const std::string elsewhere = "mien.schema.json#";
  std::string text(recipes_schema_text());
  for (std::size_t at = text.find(elsewhere); at != std::string::npos; at = text.find(elsewhere))
    text.replace(at, elsewhere.size(), "#");
  nlohmann::json schema = nlohmann::json::parse(text);
  schema["definitions"] = manifest_schema()["definitions"];
  return schema;
}

}  // namespace

const nlohmann::json& recipes_schema() {
  static const nlohmann::json schema = with_definitions_of_manifest();
  return schema;
}

}  // namespace mien::pipeline

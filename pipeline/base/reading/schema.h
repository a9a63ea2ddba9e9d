#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "pipeline/base/documents/fault.h"
#include "pipeline/base/documents/places.h"

namespace mien::pipeline {

/// manifests/mien.schema.json, scales.schema.json and recipes.schema.json, and
/// scenes/set.schema.json, as they were when this program was built. What the schema of recipes
/// refers to in the manifest's is part of it here.
std::string_view manifest_schema_text();
std::string_view scales_schema_text();
std::string_view recipes_schema_text();
std::string_view set_schema_text();
const nlohmann::json& manifest_schema();
const nlohmann::json& scales_schema();
const nlohmann::json& recipes_schema();
const nlohmann::json& set_schema();

/// A node of a schema with the schema it belongs to, whose definitions it may refer to.
struct SchemaNode {
  const nlohmann::json* root = nullptr;
  const nlohmann::json* node = nullptr;  ///< null: nothing is known about the value

  explicit operator bool() const { return node != nullptr; }
};

SchemaNode root_of(const nlohmann::json& schema);

/// The node with its $ref followed and, of a oneOf of types, the branch that takes `value`'s type.
/// A union that has no such branch stays as it is.
SchemaNode narrowed(SchemaNode node, const nlohmann::json& value);

/// The schema of a member of an object, or of the elements of an array. `node` must be narrowed.
SchemaNode member_schema(SchemaNode node, const std::string& key);
SchemaNode element_schema(SchemaNode node);

/// What a member is called now whose schema says so of its former name:
/// "faintest": {"deprecated": true, "x-now": "min_opacity"}. `node` must be narrowed.
std::optional<std::string> name_now(SchemaNode node, const std::string& former);

/// Whether a text may stand here.
bool takes_text(SchemaNode node);

/// Validates a document (valijson) and says in plain sentences what is wrong and how to mend it.
std::vector<Fault> check_schema(const nlohmann::json& document, const nlohmann::json& schema,
                                const Places& places);

/// What is wrong with one value by itself; its members and elements are not looked into.
/// `path` is the value's.
std::vector<Fault> explain(const nlohmann::json& value, SchemaNode node, const std::string& path,
                           const Places& places);

}  // namespace mien::pipeline

#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "pipeline/base/documents/fault.h"
#include "pipeline/base/documents/places.h"

namespace mien::pipeline {

/// The text of the schemas, as the files were at build time: manifests/mien.schema.json,
/// manifests/scales.schema.json, manifests/recipes.schema.json and scenes/sets/set.schema.json.
std::string_view manifest_schema_text();
std::string_view scales_schema_text();
std::string_view recipes_schema_text();
std::string_view set_schema_text();

/// The same schemas, parsed. That of recipes includes the definitions of the manifest's schema, to
/// which its text refers.
const nlohmann::json& manifest_schema();
const nlohmann::json& scales_schema();
const nlohmann::json& recipes_schema();
const nlohmann::json& set_schema();

/// A node of a schema, together with the schema that contains the definitions it refers to.
struct SchemaNode {
  const nlohmann::json* root = nullptr;
  const nlohmann::json* node = nullptr;  ///< null: the schema does not restrict the value

  explicit operator bool() const { return node != nullptr; }
};

SchemaNode root_of(const nlohmann::json& schema);

/// The node with $ref resolved and, for a oneOf of types, the branch that accepts `value`'s type. A
/// oneOf without such a branch is returned unchanged.
SchemaNode resolved_schema(SchemaNode node, const nlohmann::json& value);

/// The schema of a member of an object, or of the elements of an array. `node` must have been
/// resolved by `resolved_schema`.
SchemaNode member_schema(SchemaNode node, const std::string& key);
SchemaNode element_schema(SchemaNode node);

/// The present name of a member, given a former name for which the schema states it: "faintest":
/// {"deprecated": true, "x-now": "min_opacity"}. `node` must have been resolved.
std::optional<std::string> name_now(SchemaNode node, const std::string& former);

/// Whether the schema, or a branch of its oneOf, has the type "string"; false if it states no type.
bool accepts_text(SchemaNode node);

/// Validates a document (valijson) and returns faults that state what is wrong and how to fix it.
std::vector<Fault> check_schema(const nlohmann::json& document, const nlohmann::json& schema,
                                const Places& places);

/// Faults of one value, without those of its members and elements. `path` is that of the value.
std::vector<Fault> explain(const nlohmann::json& value, SchemaNode node, const std::string& path,
                           const Places& places);

}  // namespace mien::pipeline

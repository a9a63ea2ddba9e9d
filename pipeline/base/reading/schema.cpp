#include "pipeline/base/reading/schema.h"

namespace mien::pipeline {

namespace {

using nlohmann::json;

SchemaNode with(SchemaNode node, const json* child) { return {node.root, child}; }

const json* find(const json& object, const std::string& key) {
  if (!object.is_object()) return nullptr;
  const auto found = object.find(key);
  return found == object.end() ? nullptr : &*found;
}

SchemaNode dereferenced(SchemaNode node) {
  while (node) {
    const json* reference = find(*node.node, "$ref");
    if (reference == nullptr) break;
    const json::json_pointer target(reference->get<std::string>().substr(1));
    node.node = &node.root->at(target);
  }
  return node;
}

bool has_type_of(const json& branch, const json& value) {
  const json* type = find(branch, "type");
  if (type == nullptr) return false;
  if (*type == "number") return value.is_number();
  if (*type == "integer") return value.is_number_integer();
  return (*type == "string" && value.is_string()) || (*type == "object" && value.is_object()) ||
         (*type == "array" && value.is_array()) || (*type == "boolean" && value.is_boolean());
}

}  // namespace

SchemaNode root_of(const json& schema) { return {&schema, &schema}; }

SchemaNode resolved_schema(SchemaNode node, const json& value) {
  node = dereferenced(node);
  const json* union_of = node ? find(*node.node, "oneOf") : nullptr;
  if (union_of == nullptr) return node;
  for (const json& alternative : *union_of) {
    const SchemaNode branch = dereferenced(with(node, &alternative));
    if (has_type_of(*branch.node, value)) return branch;
  }
  return node;
}

SchemaNode member_schema(SchemaNode node, const std::string& key) {
  if (!node) return node;
  if (const json* properties = find(*node.node, "properties"))
    if (const json* member = find(*properties, key)) return with(node, member);
  const json* others = find(*node.node, "additionalProperties");
  return with(node, others != nullptr && others->is_object() ? others : nullptr);
}

SchemaNode element_schema(SchemaNode node) {
  return node ? with(node, find(*node.node, "items")) : node;
}

std::optional<std::string> name_now(SchemaNode node, const std::string& former) {
  const SchemaNode member = member_schema(node, former);
  const json* now = member ? find(*member.node, "x-now") : nullptr;
  return now == nullptr ? std::nullopt : std::optional(now->get<std::string>());
}

bool accepts_text(SchemaNode node) {
  node = resolved_schema(node, json(""));
  return node && has_type_of(*node.node, json(""));
}

}  // namespace mien::pipeline

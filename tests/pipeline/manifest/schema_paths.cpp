#include "pipeline/manifest/schema_paths.h"

namespace mien::test {

namespace {

using nlohmann::json;

class SchemaWalk {
 public:
  explicit SchemaWalk(const json& root) : root_(root) {}

  void walk(const json& given, const std::string& path) {
    const json& node = followed(given);
    if (node.contains("oneOf")) {
      for (const json& alternative : node["oneOf"]) walk(alternative, path);
    }
    const std::string inside = path.empty() ? "" : path + ".";
    const json properties = node.value("properties", json::object());
    for (const auto& [key, property] : properties.items()) {
      if (property.contains("x-now")) continue;
      found_.emplace(inside + key, followed(property));
      walk(property, inside + key);
    }
    if (node.contains("items")) walk(node["items"], path + "[]");
    if (const auto others = node.find("additionalProperties");
        others != node.end() && others->is_object())
      walk(*others, path);
  }

  std::map<std::string, json> take() { return std::move(found_); }

 private:
  const json& followed(const json& node) const {
    if (!node.contains("$ref")) return node;
    return root_.at(json::json_pointer(node["$ref"].get<std::string>().substr(1)));
  }

  const json& root_;
  std::map<std::string, json> found_;
};

}  // namespace

std::map<std::string, json> properties_of(const json& schema) {
  SchemaWalk walk(schema);
  walk.walk(schema, "");
  std::map<std::string, json> found = walk.take();
  // One step of a row of steps is written with or without the row, and a row of steps with or
  // without a map around it.
  std::erase_if(found, [](const auto& property) {
    return property.first.find("modify[]") != std::string::npos ||
           property.first.find("stimuli[].path[]") != std::string::npos ||
           property.first.find("people[].path[]") != std::string::npos;
  });
  return found;
}

}  // namespace mien::test

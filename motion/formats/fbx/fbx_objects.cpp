#include "motion/formats/fbx/fbx_objects.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "motion/error.h"
#include "motion/formats/fbx/fbx_values.h"

namespace mien::motion {

namespace {

using namespace std::string_view_literals;

constexpr std::string_view binary_separator = "\0\1"sv;

/// The objects by their numbers and names.
struct Known {
  std::unordered_map<std::int64_t, int> by_number;
  std::unordered_map<std::string_view, int> by_name;
};

void add_object(const FbxDocument& document, std::uint32_t node, FbxObjects& objects,
                Known& known) {
  const std::optional<FbxValue> first = value_at(document, node, 0);
  if (!first) return;
  const int index = static_cast<int>(objects.objects.size());
  FbxObject object{node, document.nodes[node].name, {}, {}};
  std::string_view full_name = first->text;
  if (first->kind == FbxValue::Kind::integer) {
    full_name = text_of(document, node, 1);
    object.sub_kind = text_of(document, node, 2);
    if (!known.by_number.emplace(first->integer, index).second) {
      refuse_fbx(document, node, "two objects have the same number");
    }
  } else if (first->kind == FbxValue::Kind::text) {
    object.sub_kind = text_of(document, node, 1);
    known.by_name.emplace(full_name, index);
  } else {
    return;
  }
  object.name = name_without_class(document, full_name);
  objects.by_full_name.emplace_back(full_name, index);
  objects.objects.push_back(std::move(object));
}

/// Index of the object that a value names, −1 for the scene, −2 for an unknown one.
int object_named(const std::optional<FbxValue>& value, const Known& known) {
  constexpr int unknown = -2;
  if (!value) return unknown;
  if (value->kind == FbxValue::Kind::integer) {
    if (value->integer == 0) return -1;
    const auto found = known.by_number.find(value->integer);
    return found == known.by_number.end() ? unknown : found->second;
  }
  if (value->kind != FbxValue::Kind::text) return unknown;
  const auto found = known.by_name.find(value->text);
  if (found != known.by_name.end()) return found->second;
  return value->text == "Model::Scene" || value->text == "Scene\0\1Model"sv ? -1 : unknown;
}

void add_connection(const FbxDocument& document, std::uint32_t node, FbxObjects& objects,
                    const Known& known) {
  FbxValueCursor cursor = values_of(document, node);
  const std::optional<FbxValue> type = next_value(cursor);
  if (!type || (type->text != "OO" && type->text != "OP")) return;
  const int child = object_named(next_value(cursor), known);
  const int parent = object_named(next_value(cursor), known);
  if (child < 0 || parent < -1) return;
  FbxConnection connection{child, parent, {}};
  if (type->text == "OP") {
    const std::optional<FbxValue> property = next_value(cursor);
    if (!property || property->text.empty()) return;
    connection.property = property->text;
  }
  const int index = static_cast<int>(objects.connections.size());
  objects.connections.push_back(connection);
  objects.from[static_cast<size_t>(child)].push_back(index);
  if (parent >= 0) objects.to[static_cast<size_t>(parent)].push_back(index);
}

}  // namespace

int FbxObjects::find_by_full_name(std::string_view full_name) const {
  const auto found = std::lower_bound(
      by_full_name.begin(), by_full_name.end(), full_name,
      [](const auto& entry, std::string_view wanted) { return entry.first < wanted; });
  return found != by_full_name.end() && found->first == full_name ? found->second : -1;
}

std::string name_without_class(const FbxDocument& document, std::string_view full_name) {
  if (const size_t at = full_name.find(binary_separator); at != std::string_view::npos) {
    return decoded(document, full_name.substr(0, at));
  }
  if (document.is_text) {
    if (const size_t at = full_name.find("::"); at != std::string_view::npos) {
      full_name.remove_prefix(at + 2);
    }
  }
  return decoded(document, full_name);
}

FbxObjects parse_fbx_objects(const FbxDocument& document) {
  FbxObjects objects;
  Known known;
  const std::uint32_t section = find_child(document, 0, "Objects");
  if (section == 0) {
    throw Error({document.file}, "holds no objects", "export the figure with its motion");
  }
  for (std::uint32_t node = first_child(section); node < document.nodes[section].end;
       node = document.nodes[node].end) {
    add_object(document, node, objects, known);
  }
  objects.from.resize(objects.objects.size());
  objects.to.resize(objects.objects.size());
  std::stable_sort(objects.by_full_name.begin(), objects.by_full_name.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  const std::uint32_t connections = find_child(document, 0, "Connections");
  if (connections == 0) return objects;
  for (std::uint32_t node = first_child(connections); node < document.nodes[connections].end;
       node = document.nodes[node].end) {
    add_connection(document, node, objects, known);
  }
  return objects;
}

std::vector<FbxProperty> properties_of(const FbxDocument& document, std::uint32_t owner) {
  std::vector<FbxProperty> properties;
  std::uint32_t list = find_child(document, owner, "Properties70");
  const bool is_new = list != 0;
  if (!is_new) list = find_child(document, owner, "Properties60");
  if (list == 0) return properties;
  for (std::uint32_t node = first_child(list); node < document.nodes[list].end;
       node = document.nodes[node].end) {
    FbxValueCursor cursor = values_of(document, node);
    const std::optional<FbxValue> name = next_value(cursor);
    if (!name || name->kind != FbxValue::Kind::text) continue;
    FbxProperty property;
    property.name = name->text;
    // Type, label (in new files) and flags.
    for (int i = 0; i < (is_new ? 3 : 2); ++i) next_value(cursor);
    while (property.count < 3) {
      const std::optional<FbxValue> value = next_value(cursor);
      const bool is_number = value && value->kind <= FbxValue::Kind::number;
      if (!is_number) break;
      if (!std::isfinite(value->number)) refuse_fbx(document, node, "a number is not finite");
      if (property.count == 0) property.integer = value->integer;
      property.numbers[static_cast<size_t>(property.count++)] = value->number;
    }
    properties.push_back(property);
  }
  return properties;
}

std::uint32_t template_of(const FbxDocument& document, std::string_view kind) {
  const std::uint32_t definitions = find_child(document, 0, "Definitions");
  if (definitions == 0) return 0;
  for (std::uint32_t type = first_child(definitions); type < document.nodes[definitions].end;
       type = document.nodes[type].end) {
    if (document.nodes[type].name == "ObjectType" && text_of(document, type, 0) == kind) {
      return find_child(document, type, "PropertyTemplate");
    }
  }
  return 0;
}

}  // namespace mien::motion

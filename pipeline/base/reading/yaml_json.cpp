#include "pipeline/base/reading/yaml_json.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

#include "motion/text/as_number.h"
#include "pipeline/base/documents/fault_list.h"
#include "pipeline/base/reading/schema.h"
#include "pipeline/base/reading/yaml_tree.h"

namespace mien::pipeline {

namespace {

using nlohmann::json;

bool looks_like_number(std::string_view text) {
  if (text.starts_with('+') || text.starts_with('-')) text.remove_prefix(1);
  if (text.starts_with('.')) text.remove_prefix(1);
  return !text.empty() && text[0] >= '0' && text[0] <= '9';
}

bool is_infinity_or_nan(std::string_view text) {
  if (text.starts_with('+') || text.starts_with('-')) text.remove_prefix(1);
  return text == ".inf" || text == ".Inf" || text == ".INF" || text == ".nan" || text == ".NaN" ||
         text == ".NAN";
}

/// A number as JSON; whole values become integers however they are written.
std::optional<json> number(std::string_view text) {
  if (!looks_like_number(text)) return std::nullopt;
  if (text.starts_with('+')) text.remove_prefix(1);
  if (const auto value = motion::as_number<std::int64_t>(text)) return json(*value);
  if (const auto value = motion::as_number<std::uint64_t>(text)) return json(*value);
  const std::optional<double> value = motion::as_finite_number(text);
  if (!value) return std::nullopt;
  constexpr double exact = 9007199254740992.0;
  if (std::nearbyint(*value) == *value && std::abs(*value) < exact)
    return json(static_cast<std::int64_t>(*value));
  return json(*value);
}

json plain_scalar(const std::string& text) {
  if (text.empty() || text == "~" || text == "null" || text == "Null" || text == "NULL") return {};
  if (text == "true" || text == "True" || text == "TRUE") return true;
  if (text == "false" || text == "False" || text == "FALSE") return false;
  if (auto value = number(text)) return std::move(*value);
  return text;
}

class Converter {
 public:
  Converter(const Environment& environment, std::vector<Fault>& faults)
      : environment_(environment), faults_(faults) {}

  JsonReading read(const YamlNode& root, const json& schema) {
    json document = convert(root, root_of(schema), "");
    return {std::move(document), std::move(places_), std::move(renamed_)};
  }

 private:
  json convert(const YamlNode& node, SchemaNode schema, const std::string& path) {
    if (is_too_long(node, path)) return {};
    places_.values.emplace(path, node.place);
    switch (node.kind) {
      case YamlNode::Kind::scalar:
        return scalar(node, schema, path);
      case YamlNode::Kind::sequence:
        return sequence(node, resolved_schema(schema, json::array()), path);
      case YamlNode::Kind::map:
        return map(node, resolved_schema(schema, json::object()), path);
      case YamlNode::Kind::null:
        break;
    }
    return {};
  }

  /// The paths of all values are kept: many values below long names would take more memory than
  /// the machine has.
  bool is_too_long(const YamlNode& node, const std::string& path) {
    constexpr std::size_t most_bytes = std::size_t{256} << 20;
    const bool was_too_long = path_bytes_ > most_bytes;
    path_bytes_ += path.size();
    if (path_bytes_ <= most_bytes) return false;
    if (!was_too_long)
      faults_.push_back({node.place, "", "the paths of the values exceed 256 MiB in total",
                         "use shorter names, or less nesting"});
    return true;
  }

  json sequence(const YamlNode& node, SchemaNode schema, const std::string& path) {
    json array = json::array();
    for (std::size_t i = 0; i < node.children.size(); ++i)
      array.push_back(convert(node.children[i], element_schema(schema), element_path(path, i)));
    return array;
  }

  json map(const YamlNode& node, SchemaNode schema, const std::string& path) {
    json object = json::object();
    for (std::size_t i = 0; i < node.children.size(); ++i) {
      const std::string key = name_of_member(node, i, schema, path);
      const std::string member = member_path(path, key);
      places_.keys.emplace(member, node.keys[i].place);
      object[key] = convert(node.children[i], member_schema(schema, key), member);
    }
    return object;
  }

  /// The name that the member has now. It is a fault to give it by its former name, too.
  std::string name_of_member(const YamlNode& map, std::size_t index, SchemaNode schema,
                             const std::string& path) {
    const YamlNode& key = map.keys[index];
    const std::optional<std::string> now = name_now(schema, key.text);
    if (!now) return key.text;
    const bool has_both = std::ranges::find(map.keys, *now, &YamlNode::text) != map.keys.end();
    const std::string member = member_path(path, key.text);
    if (has_both)
      faults_.push_back(
          {key.place, member, "now called " + *now + ", which is given too", "remove it"});
    else
      renamed_.push_back({key.place, member, "now called " + *now, "rename it"});
    return has_both ? key.text : *now;
  }

  json scalar(const YamlNode& node, SchemaNode schema, const std::string& path) {
    Expansion expansion = expand(node.text, environment_);
    if (!expansion.wrong.empty()) {
      faults_.push_back({node.place, path, expansion.wrong, expansion.remedy});
      return {};
    }
    const bool is_text = expansion.expanded ? accepts_text(schema) : node.quoted;
    if (is_text) return expansion.text;
    if (is_infinity_or_nan(expansion.text))
      faults_.push_back({node.place, path, "not a finite number", "write a finite one"});
    return plain_scalar(expansion.text);
  }

  const Environment& environment_;
  std::vector<Fault>& faults_;
  Places places_;
  std::vector<Fault> renamed_;
  std::size_t path_bytes_ = 0;
};

JsonReading converted(const YamlNode& root, const json& schema, const Environment& environment,
                      std::vector<Fault>& faults) {
  return Converter(environment, faults).read(root, schema);
}

}  // namespace

JsonReading read_json(std::string_view yaml, const std::string& file, const json& schema,
                      const Environment& environment, std::vector<Fault>& faults) {
  return converted(read_yaml(yaml, file, faults), schema, environment, faults);
}

JsonReading read_valid_json(std::string_view yaml, const std::string& file, const json& schema,
                            const Environment& environment) {
  std::vector<Fault> faults;
  const YamlNode root = read_yaml(yaml, file, faults);
  if (!faults.empty()) throw Faults(std::move(faults));
  JsonReading reading = converted(root, schema, environment, faults);
  append(faults, check_schema(reading.document, schema, reading.places));
  if (!faults.empty()) throw Faults(std::move(faults));
  return reading;
}

std::vector<std::string> written_order(const json& map, const std::string& path,
                                       const Places& places) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : map.items()) keys.push_back(key);
  const auto position = [&](const std::string& key) {
    const Place place = key_place_of(places, member_path(path, key));
    return std::pair(place.line, place.column);
  };
  std::stable_sort(keys.begin(), keys.end(), [&](const auto& left, const auto& right) {
    return position(left) < position(right);
  });
  return keys;
}

}  // namespace mien::pipeline

#include <algorithm>
#include <regex>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "motion/text/nearest_word.h"
#include "pipeline/base/documents/csv.h"
#include "pipeline/base/documents/utf8.h"
#include "pipeline/base/reading/schema.h"

namespace mien::pipeline {

namespace {

using nlohmann::json;

std::string named(const json& type) {
  if (type == "string") return "text";
  if (type == "integer") return "a whole number";
  if (type == "number") return "a number";
  if (type == "boolean") return "true or false";
  if (type == "array") return "a list";
  return "a map of keys and values";
}

std::string shown(const json& value) {
  if (value.is_number_float()) return shortest(value.get<double>());
  std::string text = value.dump(-1, ' ', false, json::error_handler_t::replace);
  if (text.size() <= 60) return text;
  std::size_t end = 57;
  while ((static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;
  return text.substr(0, end) + "…";
}

std::string described(const json& value) {
  if (value.is_null()) return "empty";
  if (value.is_object()) return "a map";
  if (value.is_array()) return "a list";
  if (value.is_string()) return "the text " + shown(value);
  return shown(value);
}

/// JSON in the flow style that a manifest would use.
std::string as_yaml(const json& value) {
  if (value.is_string()) return value.get<std::string>();
  std::string text;
  if (value.is_array()) {
    for (const json& element : value) text += (text.empty() ? "" : ", ") + as_yaml(element);
    return "[" + text + "]";
  }
  if (value.is_object()) {
    for (const auto& [key, member] : value.items())
      text += (text.empty() ? "" : ", ") + key + ": " + as_yaml(member);
    return "{" + text + "}";
  }
  return shown(value);
}

std::string example_of(const json& node) {
  if (!node.contains("examples")) return "";
  return "for example " + as_yaml(node["examples"][0]);
}

/// " from 1 to 5", " of 1 or more"; empty without limits.
std::string range_of(const json& node) {
  const bool has_least = node.contains("minimum"), has_most = node.contains("maximum");
  if (has_least && has_most)
    return " from " + shown(node["minimum"]) + " to " + shown(node["maximum"]);
  if (has_least) return " of " + shown(node["minimum"]) + " or more";
  return has_most ? " of " + shown(node["maximum"]) + " or less" : "";
}

std::vector<std::string> words_of_choices(const json& node) {
  std::vector<std::string> words;
  for (const json& choice : node["enum"]) words.push_back(as_yaml(choice));
  return words;
}

/// What a branch of a union takes: "counted, none", "a whole number from 0 to 1000".
std::string named_branch(const json& branch) {
  if (branch.contains("enum")) return fmt::format("{}", fmt::join(words_of_choices(branch), ", "));
  return named(branch["type"]) + range_of(branch);
}

/// The branches of a union of types, resolved; empty for any other node.
std::vector<const json*> branches_of(SchemaNode node) {
  const SchemaNode whole = resolved_schema(node, {});
  std::vector<const json*> branches;
  if (!whole || !whole.node->contains("oneOf")) return branches;
  for (const json& branch : (*whole.node)["oneOf"]) {
    const SchemaNode resolved = resolved_schema({whole.root, &branch}, {});
    if (resolved.node->contains("type")) branches.push_back(resolved.node);
  }
  return branches;
}

/// The names that properties have now.
std::vector<std::string> keys_of(const json& properties) {
  std::vector<std::string> keys;
  for (const auto& [key, property] : properties.items())
    if (!property.contains("x-now")) keys.push_back(key);
  return keys;
}

/// Collects what is wrong with one value.
class Explainer {
 public:
  /// `branches`: those of the union of types of which `node` is one, if it is.
  Explainer(const json& value, SchemaNode node, const std::vector<const json*>& branches,
            const std::string& path, const Places& places)
      : value_(value), schema_(node), node_(*node.node), path_(path), places_(places) {
    for (const json* branch : branches) {
      if (branch == node.node) continue;
      or_else_ += ", or " + named_branch(*branch);
      if (branch->contains("properties")) maps_.push_back(&(*branch)["properties"]);
    }
  }

  std::vector<Fault> faults() {
    if (node_.contains("type") ? explain_type() : explain_union()) return std::move(faults_);
    if (node_.contains("enum")) explain_choice();
    if (value_.is_number()) explain_range();
    if (value_.is_string()) explain_text();
    if (value_.is_array()) explain_length();
    if (value_.is_object()) explain_object();
    return std::move(faults_);
  }

 private:
  void add(std::string wrong, std::string remedy) {
    faults_.push_back({place_of(places_, path_), path_, std::move(wrong), std::move(remedy)});
  }

  /// Whether the type is wrong.
  bool explain_type() {
    const json& type = node_["type"];
    const bool right =
        (type == "string" && value_.is_string()) ||
        (type == "integer" && value_.is_number_integer()) ||
        (type == "number" && value_.is_number()) || (type == "boolean" && value_.is_boolean()) ||
        (type == "array" && value_.is_array()) || (type == "object" && value_.is_object());
    if (right) return false;
    if (type == "string" && node_.contains("enum") && value_.is_primitive() && !value_.is_null() &&
        !is_unquoted_choice()) {
      explain_choice();
      return true;
    }
    std::string remedy = example_of(node_);
    if (type == "boolean") remedy = "write true or false";
    if (type == "string" && value_.is_primitive() && !value_.is_null())
      remedy = value_.is_number_float() ? "put it in quotes, exactly as it is written"
                                        : "put it in quotes: \"" + shown(value_) + "\"";
    add("must be " + named(type) + " but is " + described(value_), remedy);
    return true;
  }

  /// Whether a number or truth value would be one of the choices if it were in quotes.
  bool is_unquoted_choice() const {
    const std::vector<std::string> words = words_of_choices(node_);
    return std::ranges::find(words, shown(value_)) != words.end();
  }

  /// Whether no branch of a union of types takes the value.
  bool explain_union() {
    if (!node_.contains("oneOf")) return false;
    std::string types;
    for (const json* branch : branches_of(schema_)) {
      if (!types.empty()) types += " or ";
      types +=
          branch->contains("enum") ? "one of " + named_branch(*branch) : named((*branch)["type"]);
    }
    add("must be " + types + " but is " + described(value_), example_of(node_));
    return true;
  }

  std::string example_or(const char* remedy) const {
    const std::string example = example_of(node_);
    return example.empty() ? remedy : example;
  }

  void explain_choice() {
    const json& choices = node_["enum"];
    if (std::find(choices.begin(), choices.end(), value_) != choices.end()) return;
    const std::vector<std::string> words = words_of_choices(node_);
    // A single number is the version of a format.
    if (words.size() == 1 && choices[0].is_number_integer() && value_.is_number_integer() &&
        value_ > choices[0])
      return add("is version " + shown(value_) + ", which this version of mien does not know",
                 "use a newer version of mien, or write " + words[0]);
    if (words.size() == 1 && or_else_.empty())
      return add("must be " + words[0] + " but is " + shown(value_), "write " + words[0]);
    const std::string word = value_.is_string() ? value_.get<std::string>() : shown(value_);
    const bool is_near = motion::nearest_word(word, words).has_value();
    const std::string choices_listed = fmt::format("{}", fmt::join(words, ", "));
    if (is_near) {
      add(shown(value_) + " is not one of " + choices_listed, motion::did_you_mean(word, words));
    } else {
      add(shown(value_) + " is not one of the choices",
          (words.size() == 1 ? "use " : "use one of ") + choices_listed + or_else_ +
              otherwise(word));
    }
  }

  /// A hint on the intention behind a text that is not one of the choices: a map whose colon YAML
  /// does not see, or what the schema says (x-otherwise).
  std::string otherwise(const std::string& word) const {
    const std::size_t colon = word.find(':');
    const std::string key = word.substr(0, colon);
    if (colon != std::string::npos &&
        std::ranges::any_of(maps_, [&](const json* map) { return map->contains(key); }))
      return "; write {" + key + ": " + word.substr(colon + 1) + "}, with a space after the colon";
    if (!node_.contains("x-otherwise")) return "";
    std::string hint = "; " + node_["x-otherwise"].get<std::string>();
    constexpr std::string_view blank = "…";
    const std::size_t at = hint.find(blank);
    return at == std::string::npos ? hint : hint.replace(at, blank.size(), word);
  }

  void explain_range() {
    const double value = value_.get<double>();
    const bool low = node_.contains("minimum") && value < node_["minimum"].get<double>();
    const bool high = node_.contains("maximum") && value > node_["maximum"].get<double>();
    if (!low && !high) return;
    add(shown(value_) + " is out of range",
        "use " + named(node_["type"]) + range_of(node_) + or_else_);
  }

  void explain_text() {
    const auto& text = value_.get_ref<const std::string&>();
    if (node_.contains("minLength") && count_characters(text) < node_["minLength"])
      add("must not be empty", example_or("write a text"));
    if (node_.contains("pattern") &&
        !std::regex_search(text, std::regex(node_["pattern"].get<std::string>())))
      add(shown(value_) + " " + node_["x-rule"].get<std::string>(), example_of(node_));
  }

  void explain_length() {
    const std::size_t least = node_.value("minItems", std::size_t{0});
    const std::size_t most = node_.value("maxItems", value_.size());
    if (value_.size() >= least && value_.size() <= most) return;
    const std::string range = least == most           ? std::to_string(least)
                              : value_.size() < least ? "at least " + std::to_string(least)
                                                      : "at most " + std::to_string(most);
    add(fmt::format("has {} element{} but must have {}", value_.size(),
                    value_.size() == 1 ? "" : "s", range),
        example_or(value_.size() < least ? "add elements" : "remove some"));
  }

  void explain_object() {
    if (value_.size() < node_.value("minProperties", std::size_t{0}))
      add("must not be empty", example_or("state at least one of its keys, or omit it"));
    explain_missing_keys();
    explain_unknown_keys();
    if (node_.contains("oneOf")) explain_exclusive_keys();
  }

  /// Whether an unknown key, reported separately, is a misspelling of one of these.
  bool is_misspelt(const std::vector<std::string>& keys) const {
    if (!node_.contains("properties") || node_.value("additionalProperties", json()) != false)
      return false;
    const std::vector<std::string> known = keys_of(node_["properties"]);
    for (const auto& [key, member] : value_.items()) {
      if (node_["properties"].contains(key)) continue;
      const auto meant = motion::nearest_word(key, known);
      if (meant && std::ranges::find(keys, *meant) != keys.end()) return true;
    }
    return false;
  }

  void explain_missing_keys() {
    if (!node_.contains("required")) return;
    for (const json& key : node_["required"]) {
      const std::string name = key.get<std::string>();
      if (value_.contains(name) || is_misspelt({name})) continue;
      std::string remedy = "add it";
      const SchemaNode member = resolved_schema(member_schema(schema_, name), {});
      if (member && member.node->contains("examples"))
        remedy += ", for example " + name + ": " + as_yaml((*member.node)["examples"][0]);
      faults_.push_back({place_of(places_, path_), member_path(path_, name), "missing", remedy});
    }
  }

  void explain_unknown_keys() {
    if (!node_.contains("properties") || node_.value("additionalProperties", json()) != false)
      return;
    const std::vector<std::string> known = keys_of(node_["properties"]);
    constexpr std::size_t most_remedies = 1000;  // limit, because finding one is slow
    const json& properties = node_["properties"];
    for (const auto& [key, member] : value_.items()) {
      if (properties.contains(key)) continue;
      const std::string path = member_path(path_, key);
      faults_.push_back({key_place_of(places_, path), path, "unknown key",
                         faults_.size() < most_remedies ? motion::did_you_mean(key, known) : ""});
    }
  }

  /// oneOf: [{required: [a]}, {required: [b]}, …]
  void explain_exclusive_keys() {
    std::vector<std::string> all;
    std::vector<std::string> given;
    for (const json& branch : node_["oneOf"]) {
      const auto key = branch["required"][0].get<std::string>();
      all.push_back(key);
      if (value_.contains(key)) given.push_back(key);
    }
    if (given.empty()) {
      if (!is_misspelt(all))
        add(fmt::format("has none of {}", fmt::join(all, ", ")), "give one of them");
    } else if (given.size() > 1) {
      add(fmt::format("{} exclude each other", fmt::join(given, " and ")), "keep one of them");
    }
  }

  const json& value_;
  SchemaNode schema_;
  const json& node_;
  const std::string& path_;
  const Places& places_;
  std::string or_else_;  ///< ", or a whole number from 0 to 1000": what other branches take
  std::vector<const json*> maps_;  ///< keys of the other branches
  std::vector<Fault> faults_;
};

}  // namespace

std::vector<Fault> explain(const json& value, SchemaNode node, const std::string& path,
                           const Places& places) {
  const std::vector<const json*> branches = branches_of(node);
  node = resolved_schema(node, value);
  if (!node) return {};
  return Explainer(value, node, branches, path, places).faults();
}

}  // namespace mien::pipeline

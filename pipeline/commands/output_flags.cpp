#include "pipeline/commands/output_flags.h"

#include <algorithm>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "pipeline/base/documents/environment.h"
#include "pipeline/base/reading/field_reader.h"
#include "pipeline/base/reading/option_document.h"
#include "pipeline/base/reading/schema.h"

namespace mien::pipeline {

namespace {

using nlohmann::json;

json output_schema() {
  const json& manifest = manifest_schema();
  json schema = manifest["definitions"]["output"];
  schema["definitions"] = manifest["definitions"];
  return schema;
}

/// Keys of the options that concern the picture, in the order of their list.
class PictureKeys {
 public:
  std::vector<std::string> take() { return std::move(keys_); }

  template <class Value, class... Words>
  void operator()(const char* key, const Value&, unsigned concerns, Words&&...) {
    if ((concerns & concerns::picture) != 0) keys_.emplace_back(key);
  }
  template <class Value, class Form>
  void by(const char*, const Value&, unsigned, Form) {}

 private:
  std::vector<std::string> keys_;
};

std::vector<std::string> picture_keys() {
  PictureKeys keys;
  const Output output;
  fields_of(keys, output);
  return keys.take();
}

std::string flag_of(std::string key) {
  std::ranges::replace(key, '_', '-');
  return "--" + key;
}

/// "(1 to 240)", "(draft, standard, final)", or nothing.
std::string limits_of(const json& schema) {
  if (schema.contains("enum")) {
    std::string words;
    for (const json& word : schema["enum"])
      words += (words.empty() ? "" : ", ") + word.get<std::string>();
    return fmt::format(" ({})", words);
  }
  if (!schema.contains("minimum") || !schema.contains("maximum")) return "";
  return fmt::format(" ({} to {})", schema["minimum"].dump(), schema["maximum"].dump());
}

/// 960x540 and 1,2,3,4 as YAML has them.
std::string as_array(std::string text) {
  if (text.starts_with('[')) return text;
  std::ranges::replace(text, 'x', ',');
  for (std::size_t comma = text.find(','); comma != std::string::npos;
       comma = text.find(',', comma + 2))
    text.insert(comma + 1, " ");
  return "[" + text + "]";
}

std::string default_of(const json& schema) {
  const json& value = schema["default"];
  if (value.is_string()) return value.get<std::string>();
  return value.is_array() ? fmt::format("{}x{}", value[0].dump(), value[1].dump()) : value.dump();
}

}  // namespace

CommandOption OutputFlags::option_of(const std::string& key) {
  const json& schema = manifest_schema()["definitions"]["output"]["properties"][key];
  const std::string text = schema["description"].get<std::string>() + limits_of(schema);
  const auto take = [this, key](const std::string& value) { given_[key] = value; };
  is_array_[key] = schema["type"] == "array";
  if (schema["type"] == "boolean") return flag(flag_of(key), take, text);
  return option(flag_of(key), take, text)
      .with_default(schema.contains("default") ? default_of(schema) : "");
}

std::vector<CommandOption> OutputFlags::options() {
  std::vector<CommandOption> options;
  for (const std::string& key : picture_keys()) options.push_back(option_of(key));
  return options;
}

OutputReading OutputFlags::read() const {
  std::string yaml;
  for (const auto& [key, text] : given_)
    yaml += fmt::format("{}: {}\n", key, is_array_.at(key) ? as_array(text) : text);
  if (yaml.empty()) return {};
  JsonReading reading = read_options(yaml, output_schema(), process_environment());
  const ReadingContext context{reading.places, [](const std::string& path) { return path; }};
  OutputReading result;
  pipeline::read({reading.document, "", context}, result.output);
  result.places = std::move(reading.places);
  return result;
}

}  // namespace mien::pipeline

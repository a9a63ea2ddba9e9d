#include <algorithm>
#include <optional>
#include <span>

#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "pipeline/regression/settings.h"
#include "render/image/tone.h"

namespace mien::pipeline {

namespace {

using OrderedJson = nlohmann::ordered_json;

/// The files that a setting's content was made of; none where it is not known.
OrderedJson files_in(const std::string& value) {
  OrderedJson json = value.empty() ? OrderedJson() : OrderedJson::parse(value, nullptr, false);
  return json.is_object() ? json : OrderedJson::object();
}

/// "clip content: walk.bvh has changed (0123abcd → 4567cdef)"
std::string content_text(const SettingChange& change) {
  constexpr std::size_t most_listed = 8;
  const OrderedJson before = files_in(change.before), now = files_in(change.now);
  std::vector<std::string> texts;
  for (const auto& [name, content] : before.items()) {
    if (!now.contains(name))
      texts.push_back(name + " was removed");
    else if (now.at(name) != content)
      texts.push_back(name + " has changed (" + content.get<std::string>() + " → " +
                      now.at(name).get<std::string>() + ")");
  }
  for (const auto& [name, content] : now.items())
    if (!before.contains(name)) texts.push_back(name + " is new");
  const auto listed_texts = std::span(texts).first(std::min(texts.size(), most_listed));
  std::string text = fmt::to_string(fmt::join(listed_texts, ", "));
  if (texts.size() > most_listed)
    text += " and " + std::to_string(texts.size() - most_listed) + " more files";
  return change.path + (text.empty() ? " has changed" : ": " + text);
}

/// What of sRGB's 256 codes a channel of a linear colour is, if it is one.
std::optional<int> code_of(double channel) {
  for (int code = 0; code < 256; ++code) {
    const auto byte = static_cast<std::uint8_t>(code);
    if (render::linear_from_srgb8(byte, byte, byte)[0] == static_cast<float>(channel)) return code;
  }
  return {};
}

bool is_colour(const std::string& path) {
  const std::size_t dot = path.rfind('.');
  const std::string name = dot == std::string::npos ? path : path.substr(dot + 1);
  return name.ends_with("colour") || name == "horizon" || name == "zenith" || name == "below";
}

/// "#c08040", as people write it; empty where it is none of these.
std::string hex_text(const OrderedJson& colour) {
  if (!colour.is_array() || colour.size() != 3) return "";
  std::string text = "#";
  for (const OrderedJson& channel : colour) {
    const auto code = channel.is_number() ? code_of(channel.get<double>()) : std::nullopt;
    if (!code) return "";
    text += fmt::format("{:02x}", *code);
  }
  return text;
}

/// The value as it was written: numbers stored as floats have the digits of floats.
std::string value_text(const OrderedJson& value) {
  if (value.is_number_float()) {
    const auto number = value.get<double>();
    const auto single = static_cast<float>(number);
    return static_cast<double>(single) == number ? fmt::format("{}", single) : value.dump();
  }
  if (!value.is_array()) return value.dump();
  std::string text;
  for (const OrderedJson& member : value) text += (text.empty() ? "" : ", ") + value_text(member);
  return "[" + text + "]";
}

/// A value of a setting as people write it.
std::string shown_value(const std::string& path, const std::string& value) {
  const OrderedJson json = OrderedJson::parse(value, nullptr, false);
  if (json.is_discarded()) return value;
  const std::string hex = is_colour(path) ? hex_text(json) : "";
  return hex.empty() ? value_text(json) : '"' + hex + '"';
}

}  // namespace

std::string change_text(const SettingChange& change) {
  if (change.path.ends_with(content_words)) return content_text(change);
  const auto shown = [&](const std::string& value) { return shown_value(change.path, value); };
  if (change.before.empty()) return change.path + " " + shown(change.now) + " is new";
  if (change.now.empty()) return change.path + " " + shown(change.before) + " was removed";
  return change.path + " " + shown(change.before) + " → " + shown(change.now);
}

}  // namespace mien::pipeline

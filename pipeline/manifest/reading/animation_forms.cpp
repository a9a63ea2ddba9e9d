#include <array>
#include <cstdlib>
#include <string>

#include <fmt/format.h>

#include "pipeline/base/documents/csv.h"
#include "pipeline/base/reading/field_reader.h"
#include "pipeline/base/reading/field_writer.h"
#include "pipeline/manifest/animation.h"

namespace mien::pipeline {

namespace {

constexpr std::string_view frame_word = "frame ";

}  // namespace

void MomentForm::read(const DocumentValue& given, motion::Moment& moment) {
  if (given.value.is_number()) moment = {given.value.get<double>(), false};
  if (!given.value.is_string()) return;
  const auto& text = given.value.get_ref<const std::string&>();
  const bool is_frame = text.starts_with(frame_word);
  const char* number = text.c_str() + (is_frame ? frame_word.size() : 0);
  moment = {std::strtod(number, nullptr), is_frame};
}

OrderedJson MomentForm::write(const motion::Moment& moment, const WritingOptions&) {
  if (!moment.is_frame) return moment.value;
  return fmt::format("{}{}", frame_word, shortest(moment.value));
}

void OptionalMomentForm::read(const DocumentValue& given, std::optional<motion::Moment>& moment) {
  MomentForm::read(given, moment.emplace());
}

OrderedJson OptionalMomentForm::write(const std::optional<motion::Moment>& moment,
                                      const WritingOptions& how) {
  return moment ? MomentForm::write(*moment, how) : OrderedJson();
}

namespace {

constexpr std::string_view both_arms = "arms";

/// A word, or a list of words.
void read_parts(const nlohmann::json& given, std::vector<motion::FrozenPart>& parts) {
  const auto add = [&](const nlohmann::json& word) {
    if (!word.is_string()) return;
    const auto& text = word.get_ref<const std::string&>();
    for (const auto& [name, part] : frozen_words)
      if (text == name || (text == both_arms && std::string_view(name).ends_with("-arm")))
        parts.push_back(part);
  };
  if (!given.is_array()) return add(given);
  for (const nlohmann::json& word : given) add(word);
}

}  // namespace

void FreezingForm::read(const DocumentValue& given, motion::Freezing& freezing) {
  freezing = {};
  const bool is_map = given.value.is_object();
  const nlohmann::json* parts = is_map ? member(given.value, "parts") : &given.value;
  if (parts != nullptr) read_parts(*parts, freezing.parts);
  std::ranges::sort(freezing.parts);
  const auto repeated = std::unique(freezing.parts.begin(), freezing.parts.end());
  freezing.parts.erase(repeated, freezing.parts.end());
  if (const nlohmann::json* at = is_map ? member(given.value, "at") : nullptr)
    MomentForm::read({*at, member_path(given.path, "at"), given.context}, freezing.at.emplace());
}

OrderedJson FreezingForm::write(const motion::Freezing& freezing, const WritingOptions& how) {
  if (freezing.parts.empty()) return {};
  OrderedJson parts = OrderedJson::array();
  for (const motion::FrozenPart part : freezing.parts) parts.push_back(word_of(frozen_words, part));
  if (!freezing.at) return parts;
  return {{"parts", std::move(parts)}, {"at", MomentForm::write(*freezing.at, how)}};
}

void EndsForm::read(const DocumentValue& given, motion::MotionEnds& ends) {
  ends = {};
  ends.loops = given.value == "loop";
  if (!given.value.is_object()) return;
  assign(member(given.value, "before"), ends.hold_before);
  assign(member(given.value, "after"), ends.hold_after);
}

OrderedJson EndsForm::write(const motion::MotionEnds& ends, const WritingOptions&) {
  if (ends.loops) return "loop";
  OrderedJson held = OrderedJson::object();
  if (ends.hold_before > 0.0) held["before"] = ends.hold_before;
  if (ends.hold_after > 0.0) held["after"] = ends.hold_after;
  return held.empty() ? OrderedJson() : held;
}

void PlaceForm::read(const DocumentValue& given, std::optional<motion::Vec3>& place) {
  std::optional<std::array<double, 3>> numbers;
  assign(&given.value, numbers);
  if (numbers) place.emplace((*numbers)[0], (*numbers)[1], (*numbers)[2]);
}

OrderedJson PlaceForm::write(const std::optional<motion::Vec3>& place, const WritingOptions&) {
  if (!place) return {};
  return OrderedJson::array({place->x(), place->y(), place->z()});
}

}  // namespace mien::pipeline

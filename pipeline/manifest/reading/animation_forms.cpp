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

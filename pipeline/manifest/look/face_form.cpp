#include "pipeline/manifest/look/face_form.h"

#include <algorithm>
#include <iterator>
#include <string_view>

#include "pipeline/base/reading/field_reader.h"
#include "pipeline/base/reading/field_writer.h"

namespace mien::pipeline {

namespace {

constexpr std::string_view hidden_word = "hidden";
constexpr std::string_view neutral_word = "neutral";

constexpr std::string_view file_options[] = {"file", "take", "start", "fps"};

/// The options of a file of weights.
void read_file(const DocumentValue& given, scenes::Face& face) {
  if (const nlohmann::json* file = member(given.value, "file"))
    pipeline::read({*file, member_path(given.path, "file"), given.context}, face.file);
  assign(member(given.value, "take"), face.take);
  assign(member(given.value, "start"), face.start_s);
  assign(member(given.value, "fps"), face.frames_per_second);
}

/// The weights, which have all other names.
void read_weights(const DocumentValue& given, scenes::Face& face) {
  for (const std::string& name : written_order(given.value, given.path, given.context.places)) {
    if (std::ranges::find(file_options, name) != std::end(file_options)) continue;
    assign(&given.value[name], face.weights.emplace_back(name, 0.0).second);
  }
}

}  // namespace

void FaceForm::read(const DocumentValue& given, scenes::Face& face) {
  face = scenes::Face();
  face.is_hidden = given.value == hidden_word;
  if (!given.value.is_object()) return;
  read_file(given, face);
  read_weights(given, face);
}

OrderedJson FaceForm::write(const scenes::Face& face, const WritingOptions& how) {
  if (face.is_hidden) return hidden_word;
  if (face.file.empty()) return written(face.weights, how);
  OrderedJson map = {{"file", written(face.file, how)}};
  if (!face.take.empty()) map["take"] = face.take;
  if (face.start_s != 0.0) map["start"] = face.start_s;
  if (face.frames_per_second) map["fps"] = *face.frames_per_second;
  return map;
}

void PersonFaceForm::read(const DocumentValue& given, std::optional<scenes::Face>& face) {
  FaceForm::read(given, face.emplace());
}

OrderedJson PersonFaceForm::write(const std::optional<scenes::Face>& face,
                                  const WritingOptions& how) {
  if (!face) return {};
  return face->is_neutral() ? OrderedJson(neutral_word) : FaceForm::write(*face, how);
}

}  // namespace mien::pipeline

#include <algorithm>

#include "motion/formats/motion_format.h"
#include "pipeline/base/reading/field_reader.h"
#include "pipeline/base/reading/field_writer.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/manifest/reading/example_source.h"
#include "pipeline/manifest/reading/recipes.h"
#include "scenes/figures/figure.h"

namespace mien::pipeline {

namespace {

using nlohmann::json;

constexpr std::string_view builtin_prefix = "builtin:";

constexpr Words<Examples::Labels> label_words = {{"from-name", Examples::Labels::from_name},
                                                 {"file-name", Examples::Labels::file_name}};

bool holds(const json& array, std::string_view word) {
  return std::find(array.begin(), array.end(), word) != array.end();
}

}  // namespace

ScalesSource scales_in(const std::filesystem::path& file) { return {file, read_scales(file)}; }

ScaleSet scales_of(const ScalesSource& source) {
  return source.file.empty() ? builtin_scales() : source.set;
}

void VideoKindsForm::read(const DocumentValue& given, std::vector<render::VideoKind>& video) {
  if (!given.value.is_array()) return;
  video.clear();
  for (const render::VideoTraits& traits : render::video_kinds()) {
    if (holds(given.value, traits.name)) video.push_back(traits.kind);
  }
}

OrderedJson VideoKindsForm::write(const std::vector<render::VideoKind>& video,
                                  const WritingOptions&) {
  OrderedJson names = OrderedJson::array();
  for (const render::VideoKind kind : video) names.push_back(render::traits_of(kind).name);
  return names;
}

void ClipsForm::read(const DocumentValue& given, std::vector<std::string>& clips) {
  if (!given.value.is_array()) return;
  clips.clear();
  for (const motion::MotionFormat& format : motion::motion_formats()) {
    const std::string name(format.ending.substr(1));
    if (format.is_of_clips() && holds(given.value, name)) clips.push_back(name);
  }
}

OrderedJson ClipsForm::write(const std::vector<std::string>& clips, const WritingOptions&) {
  return clips;
}

void SubjectForm::read(const DocumentValue& given, std::string& subject) {
  if (given.value.is_number_integer()) subject = given.value.dump();
  assign(&given.value, subject);
}

OrderedJson SubjectForm::write(const std::string& subject, const WritingOptions&) {
  return subject;
}

void EqualizeGroupForm::read(const DocumentValue& given, std::optional<EqualizeGroup>& group_by) {
  if (given.value.is_boolean()) group_by.reset();
  if (given.value == false) return;
  group_by = EqualizeGroup::study;
  if (given.value.is_object()) assign(member(given.value, "by"), *group_by, equalize_group_words);
}

OrderedJson EqualizeGroupForm::write(const std::optional<EqualizeGroup>& group_by,
                                     const WritingOptions&) {
  if (group_by == EqualizeGroup::figure) return {{"by", "figure"}};
  return group_by.has_value();
}

void EqualizeForm::read(const DocumentValue& given, Equalize& equalize) {
  if (given.value.is_object()) return pipeline::read(given, equalize);
  if (!given.value.is_array()) return;
  const auto group_by = [&](const char* word) {
    return holds(given.value, word) ? std::optional(EqualizeGroup::study) : std::nullopt;
  };
  equalize = {
      .luminance = group_by("luminance"),
      .size = group_by("size"),
      .place = group_by("place"),
      .duration = holds(given.value, "duration"),
      .loudness = holds(given.value, "loudness") ? std::optional(broadcast_lufs) : std::nullopt};
}

OrderedJson EqualizeForm::write(const Equalize& equalize, const WritingOptions& how) {
  const auto is_named = [](const std::optional<EqualizeGroup>& group_by) {
    return group_by != EqualizeGroup::figure;
  };
  const bool is_usual_loudness = !equalize.loudness || equalize.loudness == broadcast_lufs;
  if (!is_named(equalize.luminance) || !is_named(equalize.size) || !is_named(equalize.place) ||
      !is_usual_loudness)
    return written(equalize, how);
  OrderedJson words = OrderedJson::array();
  if (equalize.luminance) words.push_back("luminance");
  if (equalize.size) words.push_back("size");
  if (equalize.place) words.push_back("place");
  if (equalize.duration) words.push_back("duration");
  if (equalize.loudness) words.push_back("loudness");
  return words;
}

std::vector<std::vector<const Stimulus*>> equalized_groups(const std::vector<Stimulus>& stimuli,
                                                           EqualizeGroup group_by) {
  std::vector<std::string> names;
  std::vector<std::vector<const Stimulus*>> groups;
  for (const Stimulus& stimulus : stimuli) {
    const std::string name(
        group_by == EqualizeGroup::figure ? scenes::kind_of(stimulus.look.figure).name : "");
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) groups.emplace_back();
    const auto group = static_cast<std::size_t>(found - names.begin());
    if (found == names.end()) names.push_back(name);
    groups[group].push_back(&stimulus);
  }
  return groups;
}

void LabelsForm::read(const DocumentValue& given, Examples& examples) {
  assign(&given.value, examples.labels, label_words);
  pipeline::read(given, examples.given_labels);
}

OrderedJson LabelsForm::write(const Examples& examples, const WritingOptions& how) {
  if (!examples.given_labels.empty()) return written(examples.given_labels, how);
  return examples.labels == Examples::Labels::from_name ? "from-name" : "file-name";
}

void ExampleSetForm::read(const DocumentValue& given, Examples& examples) {
  if (!given.value.is_string()) return pipeline::read(given, examples);
  const auto& name = given.value.get_ref<const std::string&>();
  if (name.starts_with(builtin_prefix)) examples.builtin = name.substr(builtin_prefix.size());
  examples.blendable = examples.builtin != unblendable_set;
}

OrderedJson ExampleSetForm::write(const Examples& examples, const WritingOptions& how) {
  if (!examples.builtin.empty()) return std::string(builtin_prefix) + examples.builtin;
  return examples.folder.empty() ? OrderedJson() : written(examples, how);
}

void RatingsForm::read(const DocumentValue& given, Ratings& ratings) {
  if (!given.value.is_string()) return;
  ratings.source = Ratings::Source::file;
  assign(&given.value, ratings.source, ratings_words);
  if (ratings.source == Ratings::Source::file) pipeline::read(given, ratings.file);
}

OrderedJson RatingsForm::write(const Ratings& ratings, const WritingOptions& how) {
  for (const auto& [word, source] : ratings_words) {
    if (source == ratings.source) return word;
  }
  return written(ratings.file, how);
}

void ScalesForm::read(const DocumentValue& given, ScalesSource& scales) {
  if (given.value != "builtin") pipeline::read(given, scales.file);
}

OrderedJson ScalesForm::write(const ScalesSource& scales, const WritingOptions& how) {
  return scales.file.empty() ? OrderedJson("builtin") : written(scales.file, how);
}

void RecipesForm::read(const DocumentValue& given, RecipesSource& recipes) {
  assign(&given.value, recipes.name);
  if (builtin_recipes_text(recipes.name).empty()) pipeline::read(given, recipes.file);
}

OrderedJson RecipesForm::write(const RecipesSource& recipes, const WritingOptions& how) {
  return recipes.file.empty() ? OrderedJson(recipes.name) : written(recipes.file, how);
}

}  // namespace mien::pipeline

#include <algorithm>

#include "pipeline/manifest/example_source.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/manifest/recipes.h"
#include "pipeline/reading/field_reader.h"
#include "pipeline/reading/field_writer.h"
#include "scenes/figures/figure.h"

namespace mien::pipeline {

namespace {

using nlohmann::json;

constexpr std::string_view builtin_prefix = "builtin:";

/// Whether something is made alike at all, and among which.
void read_alike(const json& given, bool& asked, Among& among) {
  assign(&given, asked);
  if (!given.is_object()) return;
  asked = true;
  assign(member(given, "by"), among, among_words);
}

OrderedJson written_alike(bool asked, Among among) {
  if (!asked || among == Among::study) return asked;
  return {{"by", "figure"}};
}

constexpr Words<Examples::Labels> label_words = {{"from-name", Examples::Labels::from_name},
                                                 {"file-name", Examples::Labels::file_name}};

}  // namespace

ScalesSource scales_in(const std::filesystem::path& file) { return {file, read_scales(file)}; }

ScaleSet scales_of(const ScalesSource& source) {
  return source.file.empty() ? builtin_scales() : source.set;
}

void VideoKindsForm::read(const Given& given, std::vector<render::VideoKind>& video) {
  if (!given.value.is_array()) return;
  video.clear();
  for (const render::VideoTraits& traits : render::video_kinds()) {
    const bool is_in =
        std::find(given.value.begin(), given.value.end(), traits.name) != given.value.end();
    if (is_in) video.push_back(traits.kind);
  }
}

OrderedJson VideoKindsForm::write(const std::vector<render::VideoKind>& video, const Writing&) {
  OrderedJson names = OrderedJson::array();
  for (const render::VideoKind kind : video) names.push_back(render::traits_of(kind).name);
  return names;
}

void LuminanceForm::read(const Given& given, Equalize& equalize) {
  read_alike(given.value, equalize.luminance, equalize.luminance_among);
}

OrderedJson LuminanceForm::write(const Equalize& equalize, const Writing&) {
  return written_alike(equalize.luminance, equalize.luminance_among);
}

void SizeForm::read(const Given& given, Equalize& equalize) {
  read_alike(given.value, equalize.size, equalize.size_among);
}

OrderedJson SizeForm::write(const Equalize& equalize, const Writing&) {
  return written_alike(equalize.size, equalize.size_among);
}

void EqualizeForm::read(const Given& given, Equalize& equalize) {
  if (given.value.is_object()) return pipeline::read(given, equalize);
  if (!given.value.is_array()) return;
  const auto names = [&](const char* word) {
    return std::find(given.value.begin(), given.value.end(), word) != given.value.end();
  };
  equalize = {
      .luminance = names("luminance"), .size = names("size"), .duration = names("duration")};
}

OrderedJson EqualizeForm::write(const Equalize& equalize, const Writing& how) {
  const Equalize anywhere{
      .luminance = equalize.luminance, .size = equalize.size, .duration = equalize.duration};
  if (equalize != anywhere) return written(equalize, how);
  OrderedJson words = OrderedJson::array();
  if (equalize.luminance) words.push_back("luminance");
  if (equalize.size) words.push_back("size");
  if (equalize.duration) words.push_back("duration");
  return words;
}

std::vector<std::vector<const Stimulus*>> alike(const std::vector<Stimulus>& stimuli, Among among) {
  std::vector<std::string> names;
  std::vector<std::vector<const Stimulus*>> groups;
  for (const Stimulus& stimulus : stimuli) {
    const std::string name(among == Among::figure ? scenes::name_of(stimulus.look.figure) : "");
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) groups.emplace_back();
    const auto group = static_cast<std::size_t>(found - names.begin());
    if (found == names.end()) names.push_back(name);
    groups[group].push_back(&stimulus);
  }
  return groups;
}

void LabelsForm::read(const Given& given, Examples& examples) {
  assign(&given.value, examples.labels, label_words);
  pipeline::read(given, examples.given_labels);
}

OrderedJson LabelsForm::write(const Examples& examples, const Writing& how) {
  if (!examples.given_labels.empty()) return written(examples.given_labels, how);
  return examples.labels == Examples::Labels::from_name ? "from-name" : "file-name";
}

void ExampleSetForm::read(const Given& given, Examples& examples) {
  if (!given.value.is_string()) return pipeline::read(given, examples);
  const auto& name = given.value.get_ref<const std::string&>();
  if (name.starts_with(builtin_prefix)) examples.builtin = name.substr(builtin_prefix.size());
  examples.blendable = examples.builtin != unblendable_set;
}

OrderedJson ExampleSetForm::write(const Examples& examples, const Writing& how) {
  if (!examples.builtin.empty()) return std::string(builtin_prefix) + examples.builtin;
  return examples.folder.empty() ? OrderedJson() : written(examples, how);
}

void RatingsForm::read(const Given& given, Ratings& ratings) {
  if (!given.value.is_string()) return;
  ratings.source = Ratings::Source::file;
  assign(&given.value, ratings.source, ratings_words);
  if (ratings.source == Ratings::Source::file) pipeline::read(given, ratings.file);
}

OrderedJson RatingsForm::write(const Ratings& ratings, const Writing& how) {
  for (const auto& [word, source] : ratings_words) {
    if (source == ratings.source) return word;
  }
  return written(ratings.file, how);
}

void ScalesForm::read(const Given& given, ScalesSource& scales) {
  if (given.value != "builtin") pipeline::read(given, scales.file);
}

OrderedJson ScalesForm::write(const ScalesSource& scales, const Writing& how) {
  return scales.file.empty() ? OrderedJson("builtin") : written(scales.file, how);
}

void RecipesForm::read(const Given& given, RecipesSource& recipes) {
  assign(&given.value, recipes.name);
  if (builtin_recipes_text(recipes.name).empty()) pipeline::read(given, recipes.file);
}

OrderedJson RecipesForm::write(const RecipesSource& recipes, const Writing& how) {
  return recipes.file.empty() ? OrderedJson(recipes.name) : written(recipes.file, how);
}

}  // namespace mien::pipeline

#include <cmath>
#include <type_traits>
#include <utility>
#include <variant>

#include "pipeline/base/reading/field_reader.h"
#include "pipeline/base/reading/field_writer.h"
#include "pipeline/manifest/look/look_fields.h"
#include "pipeline/manifest/look/point_form.h"
#include "pipeline/manifest/look/set_file.h"

namespace mien::pipeline {

namespace {

using nlohmann::json;

constexpr double eyes_apart_m = 0.063;
constexpr double millimetres_per_metre = 1000.0;

/// What stands under a figure's name: its options, or the file that it is read from.
auto& under_name(auto& options) {
  if constexpr (requires { options.file; }) {
    return options.file;
  } else {
    return options;
  }
}

}  // namespace

void JointsForm::read(const DocumentValue& given, scenes::PointLightOptions& dots) {
  assign(&given.value, dots.joint_set);
  pipeline::read(given, dots.joints);
  if (!dots.joints.empty()) dots.joint_set.clear();
}

OrderedJson JointsForm::write(const scenes::PointLightOptions& dots, const WritingOptions& how) {
  return dots.joints.empty() ? OrderedJson(dots.joint_set) : written(dots.joints, how);
}

void MillimetresForm::read(const DocumentValue& given, std::optional<double>& metres) {
  if (given.value.is_number()) metres = given.value.get<double>() / millimetres_per_metre;
}

OrderedJson MillimetresForm::write(const std::optional<double>& metres, const WritingOptions&) {
  if (!metres) return {};
  // Back to the written number, which division and multiplication may miss by a rounding.
  return std::round(*metres * millimetres_per_metre * 1e6) / 1e6;
}

template <class Figures>
void FigureForm<Figures>::read(const DocumentValue& given, Figures& figure) {
  figure = Figures();
  scenes::for_each_kind<Figures>([&]<class Options>(Options options) {
    const char* name = Options::kind.name;
    const json* map = member(given.value, name);
    if (map != nullptr)
      pipeline::read({*map, member_path(given.path, name), given.context}, under_name(options));
    const bool is_named = !scenes::FromFile<Options> && given.value == name;
    if (map != nullptr || is_named) figure = std::move(options);
  });
}

template <class Figures>
OrderedJson FigureForm<Figures>::write(const Figures& figure, const WritingOptions& how) {
  const auto map = [&]<class Options>(const Options& options) -> OrderedJson {
    if (std::is_empty_v<Options>) return options.kind.name;
    return {{options.kind.name, written(under_name(options), how)}};
  };
  return std::visit(map, figure);
}

template struct FigureForm<scenes::Figure>;
template struct FigureForm<scenes::BodyFigure>;

void PosesForm::read(const DocumentValue& given, scenes::TrailOptions& trail) {
  const json& map = given.value;
  const bool has_others = map.contains("before") || map.contains("after") || map.contains("traces");
  if (has_others && !map.contains("poses")) trail.poses = 0;
}

OrderedJson PosesForm::write(const scenes::TrailOptions& trail, const WritingOptions&) {
  return {{"poses", trail.poses}};
}

void StereoForm::read(const DocumentValue& given, std::optional<double>& separation_m) {
  separation_m = eyes_apart_m;
  assign(member(given.value, "separation"), *separation_m);
}

OrderedJson StereoForm::write(const std::optional<double>& separation_m, const WritingOptions&) {
  if (!separation_m) return {};
  return {{"separation", *separation_m}};
}

void PersonHandsForm::read(const DocumentValue& given, std::optional<scenes::Hands>& hands) {
  assign(&given.value, hands.emplace(), hands_words);
}

OrderedJson PersonHandsForm::write(const std::optional<scenes::Hands>& hands,
                                   const WritingOptions&) {
  return hands ? OrderedJson(word_of(hands_words, *hands)) : OrderedJson();
}

void SceneForm::read(const DocumentValue& given, Look& look) {
  look.background.clear();
  assign(&given.value, look.scene);
  assign(member(given.value, "set"), look.scene);
  assign(member(given.value, "background"), look.background);
  const bool is_shipped = !builtin_set_text(look.scene).empty();
  look.scene_file = is_shipped ? std::filesystem::path() : given.context.resolve(look.scene);
}

/// What a set holds counts by itself in keys.
OrderedJson SceneForm::write(const Look& look, const WritingOptions& how) {
  if (look.scene.empty()) return {};
  // Without the file itself, which `written` would add to the key.
  const std::string name =
      look.scene_file.empty() ? look.scene : look.scene_file.filename().generic_string();
  const bool is_name = look.scene_file.empty() || how.for_key;
  const OrderedJson set = is_name ? OrderedJson(name) : written(look.scene_file, how);
  if (look.background.empty()) return set;
  return {{"set", set}, {"background", look.background}};
}

}  // namespace mien::pipeline

#include "pipeline/production/run/resolved_settings.h"

#include <variant>

#include "pipeline/base/reading/field_writer.h"
#include "pipeline/manifest/look/look_fields.h"
#include "pipeline/manifest/look/point_form.h"
#include "pipeline/production/film/film.h"

namespace mien::pipeline {

namespace {

const Writing by_name{.for_key = true};  // files by name

/// All that a struct says, with what it has anyway.
template <class Value>
OrderedJson all_of(const Value& value) {
  std::vector<FieldEntry> entries = entries_of(value, by_name);
  std::erase_if(entries, [](const FieldEntry& entry) { return entry.value.is_null(); });
  return nested_map(entries);
}

/// A figure with all its options; a name without options, or a file, is all that there is.
OrderedJson figure_of(const scenes::Figure& figure) {
  OrderedJson map = FigureForm<scenes::Figure>::write(figure, by_name);
  const auto complete = [&]<class Options>(const Options& options) {
    if constexpr (HasFields<const Options>) map.front() = all_of(options);
  };
  if (map.is_object()) std::visit(complete, figure);
  return map;
}

OrderedJson step_of(const ModificationStep& step) {
  OrderedJson map = OrderedJson::object();
  if (!step.emotion.empty()) map["emotion"] = step.emotion;
  map["strength"] = step.strength;
  map.update(step.style ? all_of(*step.style) : all_of(step.modification));
  if (step.pose) map["pose"] = all_of(*step.pose);
  return map;
}

OrderedJson film_of(const Stimulus& film) {
  OrderedJson map = all_of(film);
  const OrderedJson said = map["look"];
  map["look"] = {{"scene", said.value("scene", OrderedJson(scene_of(film.look)))},
                 {"figure", figure_of(film.look.figure)},
                 {"camera", all_of(film.look.camera)}};
  for (const auto& [key, value] : said.items()) {
    if (!map["look"].contains(key)) map["look"][key] = value;
  }
  map["output"]["samples_per_pixel"] =
      quality_of(FilmSettings{.output = film.output}).samples_per_pixel;
  return map;
}

}  // namespace

OrderedJson resolved_settings(const Stimulus& stimulus) {
  OrderedJson map = film_of(stimulus);
  map.erase("modify");
  if (stimulus.modify.empty()) map.erase("on_fault");
  if (!is_blend(stimulus)) map.erase("interpolation");
  for (const ModificationStep& step : stimulus.modify) map["modify"].push_back(step_of(step));
  return map;
}

OrderedJson resolved_settings(const Overlay& overlay) {
  const OrderedJson film = film_of(overlay.film);
  OrderedJson map = all_of(overlay);
  map["look"] = film["look"];
  map["output"] = film["output"];
  return map;
}

}  // namespace mien::pipeline

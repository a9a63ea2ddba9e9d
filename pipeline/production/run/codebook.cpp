#include "pipeline/production/run/codebook.h"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "pipeline/manifest/people.h"
#include "pipeline/production/design/close_levels.h"
#include "pipeline/production/design/confounds.h"
#include "pipeline/production/film/film_dots.h"
#include "pipeline/production/film/film_exposure.h"
#include "pipeline/production/film/film_framing.h"
#include "pipeline/production/film/film_tables.h"
#include "pipeline/production/report/study_tasks.h"
#include "pipeline/production/report/tables.h"
#include "pipeline/production/run/stimuli_table.h"
#include "pipeline/production/synthesis/durations_task.h"
#include "pipeline/production/synthesis/motion_task.h"

namespace mien::pipeline {

namespace {

using nlohmann::ordered_json;

std::vector<TableForm> table_forms(const Equalize& equalize, bool has_any_dots,
                                   bool has_clip_points, bool has_several_people) {
  std::vector<TableForm> forms = {stimuli_form};
  for (const TableForm& form : study_table_forms()) forms.push_back(form);
  for (const TableForm& form : film_table_forms()) forms.push_back(form);
  forms.push_back(warnings_form);
  forms.push_back(confounds_form);
  forms.push_back(close_levels_form);
  if (has_several_people) forms.push_back(people_table.form);
  if (equalize.duration) forms.push_back(durations_form);
  if (equalize.size) forms.push_back(sizes_form);
  if (equalize.place) forms.push_back(places_form);
  if (equalize.luminance) forms.push_back(exposure_form);
  if (has_any_dots) forms.push_back(dots_form);
  if (has_clip_points) forms.push_back(clip_points_form);
  return forms;
}

bool has_table_of_points(const Stimulus& stimulus) {
  return std::ranges::count(stimulus.output.clips, "csv") > 0;
}

ordered_json as_json(const Column& column, const std::string& name) {
  ordered_json json = {{"name", name}};
  if (!column.unit.empty()) json["unit"] = column.unit;
  json["meaning"] = column.meaning;
  return json;
}

ordered_json as_json(const TableForm& form, const std::vector<std::string>& factors) {
  ordered_json columns = ordered_json::array();
  for (const Column& column : form.columns) {
    const TableForm alone{form.path, form.rows, {&column, 1}};
    for (const std::string& name : header_of(alone, factors))
      columns.push_back(as_json(column, name));
  }
  return {{"file", form.path}, {"row", form.rows}, {"columns", columns}};
}

}  // namespace

std::vector<TableForm> all_table_forms() {
  constexpr EqualizeGroup study = EqualizeGroup::study;
  return table_forms({.luminance = study, .size = study, .place = study, .duration = true}, true,
                     true, true);
}

std::vector<TableForm> table_forms_of(const Manifest& manifest) {
  return table_forms(manifest.equalize, std::ranges::any_of(manifest.stimuli, has_dots),
                     std::ranges::any_of(manifest.stimuli, has_table_of_points),
                     has_people(manifest));
}

std::string codebook_json(const Manifest& manifest) {
  const std::vector<std::string> factors = factors_of(manifest);
  ordered_json tables = ordered_json::array();
  for (const TableForm& form : table_forms_of(manifest)) tables.push_back(as_json(form, factors));
  const ordered_json book = {
      {"study", manifest.study}, {"empty", "fields without a value are empty"}, {"tables", tables}};
  return book.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

std::string codebook_markdown() {
  std::string text;
  for (const TableForm& form : all_table_forms()) text += markdown_of(form) + "\n";
  text.pop_back();
  return text;
}

}  // namespace mien::pipeline

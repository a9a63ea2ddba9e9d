#include "pipeline/production/report/design_section.h"

#include <cmath>
#include <span>

#include <fmt/format.h>

#include "pipeline/base/documents/html.h"
#include "pipeline/production/report/report_sections.h"

namespace mien::pipeline {

namespace {

/// With more levels, a table would be too wide; all are in metrics/confounds.csv.
constexpr std::size_t most_levels = 8;

/// η² from which on it is set in bold.
constexpr double much_explained = 0.9;

std::string value_of(const LevelProperty& level, const StimulusProperty& property) {
  if (!property.is_number) return html_escaped(level.text);
  if (level.stimuli == 1) return fmt::format("{:.3g}", level.mean);
  return fmt::format("{:.3g} <small>({:.3g}–{:.3g})</small>", level.mean, level.lowest,
                     level.highest);
}

std::string note_of(const FactorProperty& relation) {
  switch (relation.relation) {
    case PropertyRelation::same:
      return "";
    case PropertyRelation::varies:
      if (!std::isfinite(relation.explained)) return "varies within levels";
      return relation.explained >= much_explained
                 ? fmt::format("<strong>η² = {:.2f}</strong>", relation.explained)
                 : fmt::format("η² = {:.2f}", relation.explained);
    case PropertyRelation::follows:
      return "<strong>follows the factor</strong>";
    case PropertyRelation::intended:
      return "follows the factor, as intended";
  }
  return "";
}

std::string heading_of(const StimulusProperty& property) {
  std::string text = property.name;
  if (property.is_number) text += fmt::format(" <small>{}</small>", property.unit);
  return text;
}

std::string table_of_factor(std::span<const FactorProperty> relations) {
  const std::vector<LevelProperty>& levels = relations.front().levels;
  const bool shows_levels = levels.size() <= most_levels;
  std::string rows, same;
  for (const FactorProperty& relation : relations) {
    if (relation.relation == PropertyRelation::same) {
      same += (same.empty() ? "" : ", ") + std::string(relation.property->name);
      continue;
    }
    rows += "<tr><th scope=\"row\">" + heading_of(*relation.property) + "</th>";
    if (shows_levels)
      for (const LevelProperty& level : relation.levels)
        rows += "<td>" + value_of(level, *relation.property) + "</td>";
    rows += "<td>" + note_of(relation) + "</td></tr>\n";
  }
  std::string text = "<h3>" + html_escaped(relations.front().factor) + "</h3>\n";
  if (!rows.empty()) {
    text += "<div class=\"wide\"><table><thead><tr><th></th>";
    if (shows_levels)
      for (const LevelProperty& level : levels)
        text += fmt::format("<th scope=\"col\">{} <small>({})</small></th>",
                            html_escaped(level.level), level.stimuli);
    text +=
        "<th scope=\"col\">relation</th></tr></thead>\n<tbody>" + rows + "</tbody></table></div>\n";
  }
  if (!same.empty()) text += "<p>The same in all of these stimuli: " + same + ".</p>\n";
  return text;
}

}  // namespace

std::string design_section(const std::vector<FactorProperty>& relations) {
  std::string tables;
  for (std::size_t first = 0; first < relations.size();) {
    std::size_t end = first;
    while (end < relations.size() && relations[end].factor == relations[first].factor) ++end;
    tables += table_of_factor(std::span(relations).subspan(first, end - first));
    first = end;
  }
  if (tables.empty()) return "";
  return titled_section(
      "Factors of the design",
      "<p>Properties of the stimuli at each level of each factor (in parentheses: number of "
      "stimuli). Numbers are means, followed by the lowest and the highest value; η² is the share "
      "of their variance that the levels explain. A property that is constant within levels and "
      "differs between them cannot be told from the factor. All values: <a "
      "href=\"metrics/confounds.csv\">confounds.csv</a>.</p>\n" +
          tables);
}

}  // namespace mien::pipeline

#include "pipeline/production/report/report_tables.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "motion/measures/distance/distance.h"
#include "pipeline/base/documents/html.h"
#include "pipeline/production/report/foils.h"
#include "pipeline/production/sheets/sheet.h"
#include "pipeline/production/synthesis/parameter_label.h"

namespace mien::pipeline {

namespace {

constexpr int most_weights = 6;

/// What blends can have of a parameter, and beside which others.
std::string range_cell(const FeasibleParameter& parameter) {
  return fmt::format("<span title=\"{}\">{:.2f}–{:.2f}</span>",
                     html_escaped(to_sentence(parameter)), parameter.range.least,
                     parameter.range.most);
}

bool is_listed(const std::string& id, const Synthesis& made) {
  const auto is_id = [&](const auto& value) { return value.first == id; };
  return std::ranges::any_of(made.requested, is_id) || std::ranges::any_of(made.held, is_id);
}

/// In the language, where there are words of it.
std::string parameter_name(const std::string& id, const Stimulus& stimulus, Motions& motions,
                           NameLanguage language) {
  const ParameterLabel label = label_of(id, stimulus, motions.repertoire());
  return html_escaped(name_in(language, english_text(label), japanese_text(label)));
}

/// A name, a bar from 0 to 1, and cells of numbers.
std::string bar_row(const std::string& name, double share,
                    std::initializer_list<std::string> cells) {
  return fmt::format(
      "<tr><th scope=\"row\">{}</th><td class=\"bar\"><meter min=\"0\" max=\"1\" "
      "value=\"{:.3f}\"></meter></td><td>{}</td></tr>\n",
      name, share, fmt::join(cells, "</td><td>"));
}

/// The row of those that are left out; nothing where they weigh nothing.
std::string smaller_weights(const std::vector<std::pair<double, std::string>>& weights, int shown) {
  double sum = 0.0;
  int count = 0;
  for (std::size_t i = static_cast<std::size_t>(shown); i < weights.size(); ++i) {
    if (weights[i].first == 0.0) continue;
    sum += weights[i].first;
    ++count;
  }
  if (count == 0) return "";
  return fmt::format(
      "<tr><th scope=\"row\">{} more (metrics/weights.csv)</th><td></td><td>{:.2f}</td></tr>\n",
      count, sum);
}

/// "5.0°", "+2.3 %", "less than 0.1 %"
std::string difference_text(const CertifiedAspect& aspect) {
  if (aspect.aspect == FoilAspect::posture) return fmt::format("{:.1f}°", aspect.difference);
  const double percent = 100.0 * aspect.difference;
  return std::abs(percent) < 0.1 ? "less than 0.1 %" : fmt::format("{:+.1f} %", percent);
}

}  // namespace

std::string parameter_table(const Stimulus& stimulus, const Synthesis& made, Motions& motions,
                            NameLanguage language) {
  if (made.weights.size() == 0) return "";
  std::string rows;
  const auto add = [&](const std::string& id, const std::string& requested,
                       const std::string& possible, double reached) {
    rows += bar_row(parameter_name(id, stimulus, motions, language), reached,
                    {requested, fmt::format("{:.2f}", reached), possible});
  };
  for (std::size_t i = 0; i < made.requested.size(); ++i) {
    const std::string possible = i < made.feasible.size() ? range_cell(made.feasible[i]) : "";
    add(made.requested[i].first, fmt::format("{:.2f}", made.requested[i].second), possible,
        made.reached[i].second);
  }
  for (std::size_t i = 0; i < made.held.size(); ++i)
    add(made.held[i].first, fmt::format("held {:.2f}", made.held[i].second), "",
        made.held_reached[i].second);
  if (rows.empty()) return rows;
  return html_table({"parameter", "", ">requested", ">reached", ">feasible range"}, rows);
}

std::string other_parameters(const Stimulus& stimulus, const Synthesis& made, Motions& motions,
                             NameLanguage language) {
  if (made.weights.size() == 0 || (made.requested.empty() && made.held.empty())) return "";
  std::string rows;
  int count = 0;
  for (const auto& [id, value] : rated_values(made, motions.repertoire())) {
    if (is_listed(id, made)) continue;
    ++count;
    rows += bar_row(parameter_name(id, stimulus, motions, language), value,
                    {fmt::format("{:.2f}", value)});
  }
  if (rows.empty()) return rows;
  return fmt::format("<details><summary>{} {}</summary>\n{}</details>\n", count,
                     count == 1 ? "other parameter" : "other parameters",
                     html_table({"parameter", "", ">value"}, rows));
}

std::string weight_table(const Synthesis& made, Motions& motions) {
  if (made.weights.size() == 0) return "";
  std::vector<std::pair<double, std::string>> weights;
  for (Eigen::Index i = 0; i < made.weights.size(); ++i) {
    weights.emplace_back(made.weights[i],
                         motions.repertoire().names[static_cast<std::size_t>(i)].name);
  }
  std::stable_sort(weights.begin(), weights.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::string rows;
  int shown = 0;
  for (const auto& [weight, name] : weights) {
    if (weight < 0.005 || shown == most_weights) break;
    ++shown;
    rows += bar_row(html_escaped(name), weight, {fmt::format("{:.2f}", weight)});
  }
  return html_table({"example", "", ">weight"}, rows + smaller_weights(weights, shown));
}

std::string distance_table(std::span<const Sheet* const> sheets, Motions& motions) {
  std::string rows;
  for (const Sheet* sheet : sheets) {
    for (const auto& [target, created] : pairs_on(*sheet)) {
      const motion::Example& wanted = motions.of(target).motion;
      const motion::Example& came = motions.of(created).motion;
      const motion::Distance d = motions.distance(target, created);
      // A gallery shows motions side by side without claiming that they are similar.
      const std::string below = sheet->gallery.empty() ? (d.matches() ? "yes" : "no") : "";
      rows += fmt::format(
          "<tr><th scope=\"row\">{}</th><td>{}</td><td>{:.4f}</td><td>{:.3f}</td><td>{:.4f}</td>"
          "<td>{}</td><td>{}</td></tr>\n",
          html_escaped(target), html_escaped(created), d.mean, d.sum, d.mpjpe, below,
          html_escaped(beside_verdict(d, wanted, came)));
    }
  }
  return html_table(
      {"target", "created", ">D (m)", ">D_sum (m): sum over joints and moments", ">MPJPE (m)",
       "D &lt; 0.06 m (the matching threshold)", "joint with the largest mean distance; durations"},
      rows);
}

std::string feature_agreement_table(std::span<const Sheet* const> sheets, Motions& motions) {
  std::string rows;
  for (const Sheet* sheet : sheets) {
    const std::vector<motion::FeatureChange> changes = feature_changes(*sheet, motions);
    const auto moved = std::ranges::count_if(changes, &motion::FeatureChange::moved);
    const auto agree = std::ranges::count_if(changes, &motion::FeatureChange::agrees);
    if (moved == 0) continue;
    rows += fmt::format("<tr><th scope=\"row\">{}</th><td>{}</td><td>{}</td><td>{}</td></tr>\n",
                        html_escaped(sheet->target), html_escaped(sheet->created), moved, agree);
  }
  if (rows.empty()) return rows;
  return html_table(
      {"target", "created", ">features in which the target differs from the reference motion",
       ">of these, changed in the same direction in the created motion"},
      rows);
}

std::string foil_table(std::span<const Stimulus> stimuli, Motions& motions) {
  std::string rows;
  for (const auto& [id, foil, aspects] : foil_certificates(stimuli, motions)) {
    for (const CertifiedAspect& aspect : aspects) {
      rows += fmt::format(
          "<tr><th scope=\"row\">{}</th><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n",
          html_escaped(id), html_escaped(foil.of), name_of(aspect.aspect), difference_text(aspect),
          aspect.aspect == foil.differ ? "intended to differ"
          : aspect.is_held()           ? "within tolerance"
                                       : "<strong>also differs</strong>");
    }
  }
  if (rows.empty()) return "";
  return html_table({"foil", "of stimulus", "aspect", ">difference", ""}, rows);
}

std::vector<motion::FeatureChange> feature_changes(const Sheet& sheet, Motions& motions) {
  if (!sheet.gallery.empty() || sheet.reference.empty()) return {};
  const auto values = [&](const std::string& name) {
    return motion::measure_features(motions.of(name).motion);
  };
  return motion::feature_changes(values(sheet.reference), values(sheet.target),
                                 values(sheet.created));
}

}  // namespace mien::pipeline

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pipeline/study/results/result_rows.h"
#include "pipeline/study/results/within_columns.h"

namespace mien::pipeline {

namespace {

/// An effect on a scale.
struct EffectRow {
  const AnswerSet& in;
  const ScaleEffects& all;
  const FactorEffect& of;

  const Scale& scale() const { return in.scales[all.scale]; }
};

/// A cell's mean on a scale.
struct CellRow {
  const AnswerSet& in;
  const Crossing& crossing;
  const ScaleEffects& all;
  const FactorCell& of;

  const Scale& scale() const { return in.scales[all.scale]; }
};

using ContrastRow = ResultRow<FactorContrast>;

constexpr auto effect_columns = result_table<EffectRow>(
    "results/anova.csv", "scale and effect of the analysis of variance",
    {scale_column,
     {"effect", "", "factor, or factors of an interaction", [](auto& r) { return r.of.name; }},
     {"people", "", "participants who rated every cell of the design",
      [](auto& r) { return r.all.people; }},
     {"incomplete", "", "participants who rated some cells, but not all; not analysed",
      [](auto& r) { return r.all.incomplete; }},
     {"ungrouped", "",
      "participants who rated every cell, but are in no group of at least two; not analysed",
      [](auto& r) { return r.all.ungrouped; }},
     {"ss", "scale units²", "sum of squares of the effect (type III)",
      [](auto& r) { return r.of.test.squares; }},
     {"df", "", "its degrees of freedom", [](auto& r) { return r.of.test.degrees; }},
     {"ss_error", "scale units²", "sum of squares of its error term",
      [](auto& r) { return r.of.test.error_squares; }},
     {"df_error", "", "degrees of freedom of the error term",
      [](auto& r) { return r.of.test.error_degrees; }},
     {"f", "", "F statistic; empty if the error term is 0", [](auto& r) { return r.of.test.f; }},
     {"p_uncorrected", "", "p without this correction, assuming sphericity",
      [](auto& r) { return p_field(r.of.test.p); }},
     {"epsilon", "", "Greenhouse and Geisser's estimate of the departure from sphericity",
      [](auto& r) { return r.of.test.epsilon; }},
     {"df_corrected", "", "degrees of freedom times epsilon",
      [](auto& r) { return r.of.test.epsilon * r.of.test.degrees; }},
     {"df_error_corrected", "", "the same for the error term",
      [](auto& r) { return r.of.test.epsilon * r.of.test.error_degrees; }},
     {"p", "", "p with the corrected degrees of freedom",
      [](auto& r) { return p_field(r.of.test.p_corrected); }},
     {"p_adjusted", "", "this p corrected for multiple comparisons, over the whole table",
      [](auto& r) { return p_field(r.of.adjusted); }},
     {"eta_partial", "0–1", "partial η²", [](auto& r) { return r.of.test.partial_eta; }},
     {"eta_partial_low", "0–1", "lower end of its 90 % interval (noncentral F)",
      [](auto& r) { return r.of.test.partial_eta_low; }},
     {"eta_partial_high", "0–1", "upper end", [](auto& r) { return r.of.test.partial_eta_high; }},
     {"eta_generalized", "0–1", "generalized η²; groups of participants count as measured",
      [](auto& r) { return r.of.test.generalized_eta; }}});

constexpr auto cell_columns = result_table<CellRow>(
    "results/cell_means.csv", "scale and cell of the design",
    {scale_column,
     {"group", "", "group of participants; empty without groups",
      [](auto& r) { return r.of.group; }},
     {"cell", "", "level of each factor",
      [](auto& r) { return cell_name(r.in.factors, r.crossing, r.of.cell); }},
     {"stimuli", "", "ids of its stimuli, separated by spaces",
      [](auto& r) {
        std::vector<std::string> ids;
        for (const std::size_t stimulus : r.crossing.cells[r.of.cell])
          ids.push_back(r.in.stimuli[stimulus].id);
        return fmt::format("{}", fmt::join(ids, " "));
      }},
     {"people", "", "participants who rated every cell of the design",
      [](auto& r) { return r.of.people; }},
     {"mean", "scale units", "mean of these participants' means",
      [](auto& r) { return r.of.mean; }},
     {"sd", "scale units", "standard deviation of these participants' means (n − 1)",
      [](auto& r) { return r.of.deviation; }},
     {"low", "scale units",
      "lower end of the 95 % interval for comparisons within participants (Cousineau 2005, Morey "
      "2008)",
      [](auto& r) { return r.of.mean - r.of.margin; }},
     {"high", "scale units", "upper end", [](auto& r) { return r.of.mean + r.of.margin; }}});

constexpr auto contrast_columns = result_table<ContrastRow>(
    "results/contrasts.csv", "scale and contrast of levels",
    {{"kind", "",
      "planned (stated in the manifest) or pairwise (two levels of a factor); p values are "
      "corrected over the planned contrasts, and over the pairs of levels of each factor, on all "
      "scales",
      [](auto& r) { return word_of(contrast_kind_words, r.of.kind); }},
     {"contrast", "", "its name", [](auto& r) { return r.of.name; }},
     {"factors", "", "factors whose levels are compared", [](auto& r) { return r.of.factors; }},
     {"weights", "", "levels with their weights", [](auto& r) { return r.of.weights; }},
     {"settings", "",
      "combinations of levels of the other factors in which all these levels were rated, separated "
      "by semicolons; only these are compared",
      [](auto& r) { return fmt::format("{}", fmt::join(r.of.settings, "; ")); }},
     scale_column,
     {"incomplete", "", "participants who rated some of the cells, but not all; not analysed",
      [](auto& r) { return r.of.incomplete; }},
     {"people", "", "participants who rated all of the cells",
      [](auto& r) { return r.of.within.people; }},
     {"cohens_dz_low", "", "lower end of the 95 % interval of cohens_dz (noncentral t)",
      [](auto& r) { return r.of.dz_ends.low; }},
     {"cohens_dz_high", "", "upper end", [](auto& r) { return r.of.dz_ends.high; }}},
    within_columns<ContrastRow>);

}  // namespace

void add_factors(const Results& results, std::vector<WrittenTable>& tables) {
  const AnswerSet& answer_set = results.answer_set;
  std::vector<EffectRow> effects;
  std::vector<CellRow> cells;
  for (const ScaleEffects& scale : results.effects.scales) {
    for (const FactorEffect& effect : scale.effects) effects.push_back({answer_set, scale, effect});
    for (const FactorCell& cell : scale.cells)
      cells.push_back({answer_set, results.effects.crossing, scale, cell});
  }
  add_table(effect_columns, effects, answer_set.simulated, tables);
  add_table(cell_columns, cells, answer_set.simulated, tables);
  add_results(contrast_columns, results.contrasts, answer_set, tables);
}

}  // namespace mien::pipeline

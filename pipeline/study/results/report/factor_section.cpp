#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pipeline/base/documents/html.h"
#include "pipeline/study/results/report/html_row.h"
#include "pipeline/study/results/report/page_tables.h"

namespace mien::pipeline {

namespace {

/// "2, 22" or, with corrected degrees of freedom, "1.40, 15.4".
std::string degrees_text(const VarianceEffect& test) {
  if (test.epsilon > 1.0 - 1e-9) return fmt::format("{:g}, {:g}", test.degrees, test.error_degrees);
  return fmt::format("{:.2f}, {:.1f}", test.epsilon * test.degrees,
                     test.epsilon * test.error_degrees);
}

std::string effects_table(const Results& results) {
  const AnswerSet& answer_set = results.answer_set;
  std::string rows;
  for (const ScaleEffects& scale : results.effects.scales)
    for (const FactorEffect& effect : scale.effects)
      rows +=
          HtmlRow()
              .text(scale_name(answer_set.scales[scale.scale]), effect.name)
              .number(scale.people, effect.test.f, degrees_text(effect.test), effect.test.epsilon,
                      p_text(effect.test.p), p_text(effect.test.p_corrected),
                      p_text(effect.adjusted), decimal(effect.test.partial_eta, 3),
                      interval_text(effect.test.partial_eta_low, effect.test.partial_eta_high, 3),
                      decimal(effect.test.generalized_eta, 3))
              .html(effect.adjusted < answer_set.alpha);
  return wide_table({"<scale", "<effect", "n", "F", "df", "ε", "p, uncorrected", "p",
                     "p, corrected", "partial η²", "90 % interval", "generalized η²"},
                    rows);
}

std::string cells_table(const Results& results) {
  const AnswerSet& answer_set = results.answer_set;
  const bool has_groups = !results.effects.between.empty();
  std::string rows;
  for (const ScaleEffects& scale : results.effects.scales) {
    for (const FactorCell& cell : scale.cells) {
      HtmlRow row;
      row.text(scale_name(answer_set.scales[scale.scale]));
      if (has_groups) row.text(cell.group);
      row.text(cell_name(answer_set.factors, results.effects.crossing, cell.cell))
          .number(cell.people, cell.mean, cell.deviation,
                  interval_text(cell.mean - cell.margin, cell.mean + cell.margin));
      rows += row.html();
    }
  }
  std::vector<std::string_view> heads = {"<scale", "<cell", "n",
                                         "mean",   "SD",    "95 % interval, within"};
  if (has_groups) heads.insert(heads.begin() + 1, "<group");
  return wide_table(heads, rows);
}

std::string contrasts_table(const Results& results, ContrastKind kind) {
  const AnswerSet& answer_set = results.answer_set;
  std::string rows;
  for (const FactorContrast& c : results.contrasts) {
    if (c.kind != kind) continue;
    const WithinParticipants& w = c.within;
    HtmlRow row;
    row.text(c.name);
    row.text(kind == ContrastKind::planned ? c.weights : c.factors);
    rows +=
        row.text(scale_name(answer_set.scales[c.scale]))
            .number(w.people, c.incomplete, w.t.mean, interval_text(w.t.low(0.95), w.t.high(0.95)),
                    w.all_equal ? "all equal" : decimal(w.t.t), p_text(w.t.p),
                    p_text(c.paired_adjusted), w.dz, interval_text(c.dz_ends.low, c.dz_ends.high),
                    p_text(w.wilcoxon.p), p_text(c.wilcoxon_adjusted))
            .prose(fmt::format("{}", fmt::join(c.settings, "; ")))
            .html(c.paired_adjusted < answer_set.alpha);
  }
  return wide_table(
      {"<contrast", kind == ContrastKind::planned ? "<weights" : "<factor", "<scale", "n",
       "incomplete", "difference", "95 % interval", "t", "p", "p, corrected", "d<sub>z</sub>",
       "95 % interval", "p, Wilcoxon", "p, corrected", "<settings compared"},
      rows);
}

/// Sentences on participants who are not analysed, scale by scale.
std::string left_out_html(const Results& results) {
  std::vector<std::string> sentences;
  for (const ScaleEffects& scale : results.effects.scales) {
    const std::string name = scale_name(results.answer_set.scales[scale.scale]);
    const auto people = [](int count) {
      return counted_noun(static_cast<std::size_t>(count), "participant", "participants");
    };
    if (scale.incomplete > 0)
      sentences.push_back(
          fmt::format("{}: {} {} analysed ratings of some cells of the design, but not of all, and "
                      "{} left out.",
                      name, people(scale.incomplete), scale.incomplete == 1 ? "has" : "have",
                      scale.incomplete == 1 ? "is" : "are"));
    if (scale.ungrouped > 0)
      sentences.push_back(fmt::format("{}: {} without a group of at least two left out.", name,
                                      people(scale.ungrouped)));
    if (scale.effects.empty())
      sentences.push_back(
          fmt::format("{}: no analysis of variance, because only {} rated every cell{}.", name,
                      people(scale.people),
                      results.effects.between.empty() ? "" : ", in fewer than two groups"));
  }
  return html_list("", sentences);
}

constexpr char method[] =
    "Analysis of variance of each scale, with {}, of the "
    "participants’ means of each cell (type III sums of squares). Each effect is tested with its "
    "own error term; p is corrected for departures from sphericity by Greenhouse and Geisser’s ε, "
    "with which the degrees of freedom are multiplied, and then for multiple comparisons over all "
    "effects on all scales. Only participants who rated every cell are included. Partial η² has a "
    "90 % interval (noncentral F), which excludes 0 if p is below .05; generalized η² can be "
    "compared between designs. Stimuli are treated as fixed: conclusions are about these videos. "
    "Ratings are treated as numbers; the scripts in analysis/ fit mixed models with random "
    "participants {} and, for ordered categories, cumulative link mixed models.";

constexpr char contrast_method[] =
    "Contrasts are tested within participants, regardless of groups, by a paired t test, and by "
    "the Wilcoxon signed-rank "
    "test of ranks, of each participant’s weighted sum of cell means. Only settings (combinations "
    "of the other factors’ levels) in which all compared levels were rated are used. p values are "
    "corrected over all planned contrasts on all their scales, and over all pairs of levels of a "
    "factor on all scales. d_z: mean over standard deviation of these sums, with its interval "
    "(noncentral t). Only participants are random in these tests: they are valid for these videos.";

/// Whether the mixed models of the scripts have random stimuli (r_scripts.cpp).
bool has_random_stimuli(const Results& results) {
  const Crossing& crossing = results.effects.crossing;
  return crossing.empty() || crossing.stimuli() > crossing.cells.size();
}

std::string method_text(const Results& results) {
  const std::string& between = results.effects.between;
  return fmt::format(method,
                     between.empty() ? "all factors within participants"
                                     : "the factors of the videos within participants and " +
                                           between + " between them",
                     has_random_stimuli(results)
                         ? "and stimuli"
                         : "(each cell of the design has one video, which cannot be told apart "
                           "from the cell)");
}

std::string contrast_method_text(const Results& results, bool are_planned) {
  std::string text = contrast_method;
  if (are_planned && !results.effects.crossing.empty() && has_random_stimuli(results))
    text +=
        " With several videos in a cell, analysis/lme4.R tests the same planned contrasts with "
        "random participants and stimuli.";
  return text;
}

}  // namespace

std::string factor_section_html(const Results& results, const std::string& figures) {
  const std::string effects = effects_table(results);
  const std::string planned = contrasts_table(results, ContrastKind::planned);
  const std::string pairs = contrasts_table(results, ContrastKind::pairwise);
  if (effects.empty() && planned.empty() && pairs.empty() && results.effects.reason.empty())
    return "";
  std::string html;
  if (!results.effects.crossing.empty()) html += html_paragraph(method_text(results));
  if (!results.effects.reason.empty()) html += html_paragraph(results.effects.reason);
  html += html_list("", crossing_sentences(results.answer_set, results.effects.crossing));
  html += left_out_html(results) + effects + figures +
          closed_table("Means of all cells", cells_table(results));
  if (!planned.empty() || !pairs.empty())
    html += html_paragraph(contrast_method_text(results, !planned.empty()));
  if (!planned.empty()) html += "<h3>Planned contrasts</h3>\n" + planned;
  return html + closed_table("All pairs of levels", pairs);
}

}  // namespace mien::pipeline

#include <algorithm>

#include <fmt/format.h>

#include "pipeline/study/results/comparisons.h"
#include "pipeline/study/results/report/html_row.h"
#include "pipeline/study/results/report/page_tables.h"

namespace mien::pipeline {

namespace {

/// What was found within persons.
HtmlRow& within_cells(HtmlRow& row, const WithinPersons& w, double paired_adjusted,
                      double wilcoxon_adjusted) {
  return row.number(w.people, w.t.mean, interval_text(w.t.low(0.95), w.t.high(0.95)),
                    w.all_alike ? "all equal" : decimal(w.t.t), p_text(w.t.p),
                    p_text(paired_adjusted), w.gz, fmt::format("{:g}", w.wilcoxon.w_plus),
                    fmt::format("{}, {}, {}", w.wilcoxon.used, w.wilcoxon.zeros, w.wilcoxon.tied),
                    p_text(w.wilcoxon.p), p_text(wilcoxon_adjusted), w.location.estimate,
                    interval_text(w.location.low, w.location.high), w.wilcoxon.rank_biserial);
}

std::string comparison_html(const Gathered& gathered, const Comparison& c) {
  const ReportedStimulus& stimulus = gathered.stimuli[c.stimulus];
  const std::string against = c.against ? gathered.stimuli[*c.against].id : "same setting";
  HtmlRow row;
  row.text(stimulus.id, against, scale_name(gathered.scales[c.scale]))
      .number(c.mean, c.mean_against,
              fmt::format("{} ({})", decimal(c.welch.t), decimal(c.welch.degrees, 1)),
              p_text(c.welch.p));
  return within_cells(row, c.within, c.paired_adjusted, c.wilcoxon_adjusted)
      .html(c.paired_adjusted < gathered.alpha);
}

}  // namespace

std::string best_seen_html(const Results& results) {
  const Gathered& gathered = results.gathered;
  std::string rows;
  for (const BestSeen& best : best_seen(gathered, results.comparisons)) {
    const Comparison& c = best.comparison;
    const double sign = best.is_high ? 1.0 : -1.0;
    const double low = c.within.t.low(0.95);
    const double high = c.within.t.high(0.95);
    rows += HtmlRow()
                .text(best.end, best.setting.empty() ? "all" : best.setting,
                      gathered.stimuli[c.stimulus].id)
                .number(sign * c.within.t.mean,
                        best.is_high ? interval_text(low, high) : interval_text(-high, -low),
                        c.within.people, p_text(c.welch.p), p_text(c.within.t.p),
                        p_text(c.paired_adjusted), sign * c.within.gz)
                .html(best.is_found);
  }
  return wide_table(
      {"<perceived", "<setting", "<highest-rated video", "difference from the other videos",
       "95 % interval", "n", "p, thesis", "p, paired", "p, corrected", "g<sub>z</sub>"},
      rows);
}

std::string comparisons_html(const Results& results, ComparisonFamily family,
                             const std::string& made) {
  const Gathered& gathered = results.gathered;
  const bool has_own = std::ranges::any_of(results.comparisons, [&](const Comparison& c) {
    return c.family == family && c.own_end != 0;
  });
  std::string rows;
  for (const Comparison& c : results.comparisons) {
    const bool is_asked = made.empty() || gathered.stimuli[c.stimulus].made == made;
    const bool is_shown = !has_own || c.own_end != 0;
    if (c.family == family && is_asked && is_shown) rows += comparison_html(gathered, c);
  }
  return wide_table({"<video",
                     "<compared with",
                     "<scale",
                     "mean",
                     "comparison mean",
                     "Welch t (df)",
                     "p",
                     "n",
                     "within-participant difference",
                     "95 % interval",
                     "t",
                     "p",
                     "p, corrected",
                     "g<sub>z</sub>",
                     "V",
                     "nonzero, zero, tied",
                     "p, Wilcoxon",
                     "p, corrected",
                     "Hodges–Lehmann",
                     "95 % interval",
                     "rank-biserial"},
                    rows);
}

std::string overall_html(const Results& results, ComparisonFamily family) {
  std::string rows;
  for (const OverallComparison& c : results.overall) {
    if (c.family != family) continue;
    HtmlRow row;
    row.text(c.emotion.empty() ? "all" : c.emotion).number(c.matched, c.mean, c.mean_against);
    rows += within_cells(row, c.within, c.paired_adjusted, c.wilcoxon_adjusted)
                .html(c.paired_adjusted < results.gathered.alpha);
  }
  return wide_table(
      {"<emotion", "matched", "mean", "comparison mean", "n", "within-participant difference",
       "95 % interval", "t", "p", "p, corrected", "g<sub>z</sub>", "V", "nonzero, zero, tied",
       "p, Wilcoxon", "p, corrected", "Hodges–Lehmann", "95 % interval", "rank-biserial"},
      rows);
}

}  // namespace mien::pipeline

#include "pipeline/results/page_tables.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "pipeline/documents/html.h"
#include "pipeline/results/best_seen.h"

namespace mien::pipeline {

namespace {

/// With a true minus sign; "–" for what is not known.
std::string decimal(double value, int digits = 2) {
  if (std::isnan(value)) return "–";
  if (std::isinf(value)) return value > 0 ? "∞" : "−∞";
  const std::string text = fmt::format("{:.{}f}", std::abs(value), digits);
  const bool is_zero = text.find_first_not_of("0.") == std::string::npos;
  return value < 0.0 && !is_zero ? "−" + text : text;
}

std::string interval_text(double low, double high, int digits = 2) {
  return std::isnan(low) ? "–"
                         : fmt::format("[{}, {}]", decimal(low, digits), decimal(high, digits));
}

std::string percent_text(double share) {
  return std::isnan(share) ? "–" : decimal(100.0 * share, 0) + " %";
}

std::string share_interval(double low, double high) {
  return fmt::format("[{}, {}] %", decimal(100.0 * low, 0), decimal(100.0 * high, 0));
}

/// A row of cells; those of `text` are set left.
class HtmlRow {
 public:
  HtmlRow& text(const std::string& plain) { return cell("text", html_escaped(plain)); }
  HtmlRow& prose(const std::string& plain) { return cell("prose", html_escaped(plain)); }
  HtmlRow& number(const std::string& plain) { return cell("", html_escaped(plain)); }
  HtmlRow& number(int count) { return cell("", std::to_string(count)); }
  std::string html(bool is_found = false) const {
    return (is_found ? "<tr class=\"found\">" : "<tr>") + cells_ + "</tr>\n";
  }

 private:
  HtmlRow& cell(std::string_view css_class, const std::string& html) {
    cells_ += css_class.empty() ? "<td>" : fmt::format("<td class=\"{}\">", css_class);
    cells_ += html + "</td>";
    return *this;
  }
  std::string cells_;
};

/// Heads that begin with "<" are of columns of text.
std::string wide_table(std::initializer_list<std::string_view> heads, const std::string& rows) {
  if (rows.empty()) return "";
  std::string html = "<div class=\"wide\"><table><thead><tr>";
  for (const std::string_view head : heads)
    html += head.starts_with('<') ? fmt::format("<th class=\"text\">{}</th>", head.substr(1))
                                  : fmt::format("<th>{}</th>", head);
  return html + "</tr></thead>\n<tbody>" + rows + "</tbody></table></div>\n";
}

std::string scale_name(const Scale& scale) { return scale.low + " – " + scale.high; }

/// What was found within persons.
HtmlRow& within_cells(HtmlRow& row, const WithinPersons& w, double paired_adjusted,
                      double wilcoxon_adjusted) {
  return row.number(w.people)
      .number(decimal(w.t.mean))
      .number(interval_text(w.t.low(0.95), w.t.high(0.95)))
      .number(w.all_alike ? "all alike" : decimal(w.t.t))
      .number(p_text(w.t.p))
      .number(p_text(paired_adjusted))
      .number(decimal(w.gz))
      .number(fmt::format("{:g}", w.wilcoxon.w_plus))
      .number(fmt::format("{}, {}, {}", w.wilcoxon.used, w.wilcoxon.zeros, w.wilcoxon.tied))
      .number(p_text(w.wilcoxon.p))
      .number(p_text(wilcoxon_adjusted))
      .number(decimal(w.location.estimate))
      .number(interval_text(w.location.low, w.location.high))
      .number(decimal(w.wilcoxon.rank_biserial));
}

/// The page asks which of two is more of the scale's high end.
std::string asked_of_two(const Gathered& gathered, const std::string& item) {
  const auto scale = std::ranges::find(gathered.scales, item, &Scale::id);
  return scale == gathered.scales.end() ? item : "more " + scale->high;
}

std::string comparison_html(const Gathered& gathered, const Comparison& c) {
  const ReportedStimulus& stimulus = gathered.stimuli[c.stimulus];
  const std::string against = c.against ? gathered.stimuli[*c.against].id : "its setting";
  HtmlRow row;
  row.text(stimulus.id)
      .text(against)
      .text(scale_name(gathered.scales[c.scale]))
      .number(decimal(c.mean))
      .number(decimal(c.mean_against))
      .number(fmt::format("{} ({})", decimal(c.welch.t), decimal(c.welch.degrees, 1)))
      .number(p_text(c.welch.p));
  return within_cells(row, c.within, c.paired_adjusted, c.wilcoxon_adjusted)
      .html(c.paired_adjusted < gathered.alpha);
}

/// What is remarkable about a session.
std::string state_of(const ParticipantSummary& p, const Gathered& gathered) {
  const bool is_too_short = p.is_unfinished && gathered.without_unfinished;
  std::string state;
  if (p.is_unfinished) state = "not finished";
  if (p.is_excluded) state += (state.empty() ? "" : ", ") + std::string("left out");
  if (p.is_excluded && !is_too_short) state += ": attention checks";
  if (p.is_constant && !p.is_excluded)
    state += std::string(state.empty() ? "" : "; ") + "kept, though always at the same place";
  return state;
}

}  // namespace

std::string p_text(double p) {
  if (std::isnan(p)) return "–";
  if (p < 0.001) return "< .001";
  const std::string text = fmt::format("{:.3f}", p);
  return text.starts_with('0') ? text.substr(1) : text;
}

std::string sessions_html(const Results& results) {
  std::string rows;
  for (const ParticipantSummary& p : results.participants)
    rows += HtmlRow()
                .text(p.participant)
                .number(p.trials)
                .number(p.answers)
                .number(fmt::format("{} of {}", p.passed, p.checks))
                .number(std::isnan(p.median_rt_ms) ? "–" : decimal(p.median_rt_ms / 1000.0, 1))
                .number(p.stalls)
                .number(p.blurs)
                .text(state_of(p, results.gathered))
                .html();
  return wide_table({"<participant", "trials", "answers", "checks passed", "median answer, s",
                     "stalls", "window left", "<"},
                    rows);
}

std::string demographics_html(const Results& results) {
  std::string rows;
  for (const DemographicSummary& d : demographics_of(results.demographics, results.gathered))
    rows += HtmlRow()
                .text(d.question)
                .text(d.answer)
                .number(d.is_count ? decimal(d.value, 0) : decimal(d.value))
                .number(d.people)
                .html();
  return wide_table({"<question", "<answer", "", "people"}, rows);
}

std::string best_seen_html(const Results& results) {
  const Gathered& gathered = results.gathered;
  std::string rows;
  for (const BestSeen& best : best_seen(gathered, results.comparisons)) {
    const Comparison& c = best.comparison;
    const double sign = best.is_high ? 1.0 : -1.0;
    const double low = c.within.t.low(0.95);
    const double high = c.within.t.high(0.95);
    rows += HtmlRow()
                .text(best.end)
                .text(best.setting.empty() ? "all" : best.setting)
                .text(gathered.stimuli[c.stimulus].id)
                .number(decimal(sign * c.within.t.mean))
                .number(best.is_high ? interval_text(low, high) : interval_text(-high, -low))
                .number(c.within.people)
                .number(p_text(c.welch.p))
                .number(p_text(c.within.t.p))
                .number(p_text(c.paired_adjusted))
                .number(decimal(sign * c.within.gz))
                .html(best.is_found);
  }
  return wide_table({"<seen", "<setting", "<most in", "above the other videos", "95 % interval",
                     "n", "p, thesis", "p, paired", "p, corrected", "g<sub>z</sub>"},
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
                     "<against",
                     "<scale",
                     "mean",
                     "mean against",
                     "Welch t (df)",
                     "p",
                     "n",
                     "difference within persons",
                     "95 % interval",
                     "t",
                     "p",
                     "p, corrected",
                     "g<sub>z</sub>",
                     "V",
                     "n ≠ 0, zeros, tied",
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
    row.text(c.emotion.empty() ? "all" : c.emotion)
        .number(decimal(c.mean))
        .number(decimal(c.mean_against));
    rows += within_cells(row, c.within, c.paired_adjusted, c.wilcoxon_adjusted)
                .html(c.paired_adjusted < results.gathered.alpha);
  }
  return wide_table(
      {"<emotion", "mean", "mean against", "n", "difference within persons", "95 % interval", "t",
       "p", "p, corrected", "g<sub>z</sub>", "V", "n ≠ 0, zeros, tied", "p, Wilcoxon",
       "p, corrected", "Hodges–Lehmann", "95 % interval", "rank-biserial"},
      rows);
}

std::string recall_html(const Results& results) {
  std::string rows;
  for (const Confusion& confusion : results.confusions) {
    for (const ConfusionRow& row : confusion.rows) {
      if (row.own < 0) continue;
      rows += HtmlRow()
                  .text(row.emotion)
                  .text(confusion.of)
                  .text(confusion.by_points ? "points of ratings" : "choices")
                  .number(row.judged)
                  .number(percent_text(row.recall))
                  .number(std::isnan(row.low) ? "–" : share_interval(row.low, row.high))
                  .number(percent_text(confusion.chance))
                  .number(row.hits)
                  .number(p_text(row.p))
                  .number(p_text(row.adjusted))
                  .html(row.adjusted < results.gathered.alpha && row.recall > confusion.chance);
    }
  }
  return wide_table({"<shown", "<of", "<by", "judged", "recall", "95 % interval (Wilson)", "chance",
                     "seen most", "p, binomial", "p, corrected"},
                    rows);
}

std::string agreement_html(const Results& results) {
  std::string rows;
  for (const Reliability& r : results.reliability) {
    const Intraclass& icc = r.intraclass;
    rows += HtmlRow()
                .text(scale_name(results.gathered.scales[r.scale]))
                .number(icc.stimuli)
                .number(icc.raters)
                .number(decimal(icc.answers_per_stimulus, 1))
                .number(decimal(icc.one))
                .number(decimal(icc.one_k))
                .number(decimal(icc.two))
                .number(decimal(icc.two_k))
                .number(decimal(icc.three))
                .number(decimal(icc.three_k))
                .number(r.complete_people)
                .number(decimal(r.alpha))
                .html();
  }
  return wide_table({"<scale", "videos", "people", "k", "ICC(1)", "ICC(1,k)", "ICC(2,1)",
                     "ICC(2,k)", "ICC(3,1)", "ICC(3,k)", "saw all", "Cronbach’s α"},
                    rows);
}

std::string preferences_html(const Results& results) {
  std::string rows;
  for (const PreferenceCount& c : results.preferences)
    rows += HtmlRow()
                .text(results.gathered.stimuli[c.one].id)
                .text(results.gathered.stimuli[c.other].id)
                .text(asked_of_two(results.gathered, c.item))
                .number(fmt::format("{} of {}", c.for_one, c.trials))
                .number(share_interval(c.low, c.high))
                .number(p_text(c.p))
                .number(p_text(c.adjusted))
                .html(c.adjusted < results.gathered.alpha);
  return wide_table({"<one", "<other", "<asked", "for the first", "95 % interval (Wilson)",
                     "p, binomial", "p, corrected"},
                    rows);
}

std::string remarks_html(const std::vector<Remark>& remarks) {
  std::string rows;
  for (const Remark& remark : remarks)
    rows += HtmlRow().text(remark.stimulus).text(remark.participant).prose(remark.text).html();
  return wide_table({"<video", "<participant", "<comment"}, rows);
}

}  // namespace mien::pipeline

#include "pipeline/study/results/report/page_tables.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "pipeline/study/results/comparisons.h"
#include "pipeline/study/results/report/html_row.h"

namespace mien::pipeline {

namespace {

/// Appends the headings of within_cells.
std::vector<std::string_view> with_within_heads(std::vector<std::string_view> heads) {
  heads.insert(heads.end(),
               {"n", "within-participant difference", "95 % interval", "t", "p", "p, corrected",
                "g<sub>z</sub>", "V", "nonzero, zero, tied", "p, Wilcoxon", "p, corrected",
                "Hodges–Lehmann", "95 % interval", "rank-biserial"});
  return heads;
}

/// Appends the tests within participants.
HtmlRow& within_cells(HtmlRow& row, const WithinParticipants& w, double paired_adjusted,
                      double wilcoxon_adjusted) {
  // Without participants there are no ranks.
  const bool is_empty = w.people == 0;
  const std::string rank_sum = is_empty ? "–" : fmt::format("{:g}", w.wilcoxon.w_plus);
  const std::string ranked =
      is_empty ? "–"
               : fmt::format("{}, {}, {}", w.wilcoxon.used, w.wilcoxon.zeros, w.wilcoxon.tied);
  return row.number(w.people, w.t.mean, interval_text(w.t.low(0.95), w.t.high(0.95)),
                    w.all_equal ? "all equal" : decimal(w.t.t), p_text(w.t.p),
                    p_text(paired_adjusted), w.gz, rank_sum, ranked, p_text(w.wilcoxon.p),
                    p_text(wilcoxon_adjusted), w.location.estimate,
                    interval_text(w.location.low, w.location.high), w.wilcoxon.rank_biserial);
}

std::string comparison_html(const AnswerSet& answer_set, const Comparison& c) {
  const ReportedStimulus& stimulus = answer_set.stimuli[c.stimulus];
  const std::string against = c.against ? answer_set.stimuli[*c.against].id : "same setting";
  HtmlRow row;
  row.text(stimulus.id, against, scale_name(answer_set.scales[c.scale]))
      .number(c.mean, c.mean_against,
              fmt::format("{} ({})", decimal(c.welch.t), decimal(c.welch.degrees, 1)),
              p_text(c.welch.p));
  return within_cells(row, c.within, c.paired_adjusted, c.wilcoxon_adjusted)
      .html(c.paired_adjusted < answer_set.alpha);
}

/// What quality rules flag: "excluded: longest run of equal answers 14 > 12; 3 answers flagged".
std::string flags_of(const ParticipantSummary& p, const QualityFlags& quality) {
  std::string flags = p.is_excluded ? "excluded" : "";
  if (quality.leaves_out(p.participant))
    flags += ": " + p.reasons;
  else if (!p.reasons.empty())
    flags += (p.is_excluded ? "; flagged: " : "included; flagged: ") + p.reasons;
  if (p.flagged_answers > 0)
    flags += (flags.empty() ? "" : "; ") +
             counted_noun(static_cast<std::size_t>(p.flagged_answers), "answer", "answers") +
             " flagged";
  return flags;
}

/// Notes on a session: excluded, unfinished, straight-lining, flags.
std::string state_of(const ParticipantSummary& p, const AnswerSet& answer_set) {
  const bool is_too_short = p.is_unfinished && answer_set.without_unfinished;
  std::string state;
  if (p.is_unfinished) state = "not finished";
  if (!answer_set.quality.stated.empty()) {
    const std::string flags = flags_of(p, answer_set.quality);
    state += (state.empty() || flags.empty() ? "" : ", ") + flags;
  } else {
    if (p.is_excluded) state += (state.empty() ? "" : ", ") + std::string("excluded");
    if (p.is_excluded && !is_too_short) state += ": attention checks";
  }
  if (p.is_straight_lining && !p.is_excluded)
    state += std::string(state.empty() ? "" : "; ") + "included; straight-lining";
  return state;
}

}  // namespace

std::string best_seen_html(const Results& results) {
  const AnswerSet& answer_set = results.answer_set;
  std::string rows;
  for (const BestSeen& best : best_seen(answer_set, results.comparisons)) {
    const Comparison& c = best.comparison;
    const double sign = best.is_high ? 1.0 : -1.0;
    const double low = c.within.t.low(0.95);
    const double high = c.within.t.high(0.95);
    rows += HtmlRow()
                .text(best.end, best.setting.empty() ? "all" : best.setting,
                      answer_set.stimuli[c.stimulus].id)
                .number(sign * c.within.t.mean,
                        best.is_high ? interval_text(low, high) : interval_text(-high, -low),
                        c.within.people, p_text(c.welch.p), p_text(c.within.t.p),
                        p_text(c.paired_adjusted), sign * c.within.gz)
                .html(best.is_significant);
  }
  return wide_table(
      {"<perceived", "<setting", "<highest-rated video", "difference from the other videos",
       "95 % interval", "n", "p, Welch", "p, paired", "p, corrected", "g<sub>z</sub>"},
      rows);
}

std::string comparisons_html(const Results& results, ComparisonFamily family,
                             const std::string& made) {
  const AnswerSet& answer_set = results.answer_set;
  const bool has_own = std::ranges::any_of(results.comparisons, [&](const Comparison& c) {
    return c.family == family && c.intended_end != 0;
  });
  std::string rows;
  for (const Comparison& c : results.comparisons) {
    const bool is_asked = made.empty() || answer_set.stimuli[c.stimulus].made == made;
    const bool is_shown = !has_own || c.intended_end != 0;
    if (c.family == family && is_asked && is_shown) rows += comparison_html(answer_set, c);
  }
  return wide_table(with_within_heads({"<video", "<compared with", "<scale", "mean",
                                       "comparison mean", "Welch t (df)", "p"}),
                    rows);
}

std::string overall_html(const Results& results, ComparisonFamily family) {
  std::string rows;
  for (const OverallComparison& c : results.overall) {
    if (c.family != family) continue;
    HtmlRow row;
    row.text(c.emotion.empty() ? "all" : c.emotion).number(c.matched, c.mean, c.mean_against);
    rows += within_cells(row, c.within, c.paired_adjusted, c.wilcoxon_adjusted)
                .html(c.paired_adjusted < results.answer_set.alpha);
  }
  return wide_table(with_within_heads({"<emotion", "matched pairs", "mean", "comparison mean"}),
                    rows);
}

std::string sessions_html(const Results& results) {
  std::string rows;
  for (const ParticipantSummary& p : results.participants)
    rows += HtmlRow()
                .text(p.participant)
                .number(p.trials, p.answers, fmt::format("{} of {}", p.passed, p.checks),
                        std::isnan(p.median_rt_ms) ? "–" : decimal(p.median_rt_ms / 1000.0, 1),
                        p.stalls, p.blurs)
                .text(state_of(p, results.answer_set))
                .html();
  return wide_table({"<participant", "trials completed", "answers analysed", "checks passed",
                     "median response time, s", "stalls", "tab switches", "<"},
                    rows);
}

std::string retest_summary_html(const Results& results) {
  std::string rows;
  for (const RetestSummary& s : results.retest_summaries)
    rows +=
        HtmlRow()
            .text(s.participant.empty() ? "all" : s.participant, s.item.empty() ? "all" : s.item)
            .number(s.answers,
                    fmt::format("{} ({})", s.equal, percent_text(1.0 * s.equal / s.answers)),
                    s.mean_difference, s.retest.r, interval_text(s.retest.low, s.retest.high))
            .text(s.is_excluded ? "excluded" : "")
            .html();
  return wide_table({"<participant", "<item", "repeated answers", "identical",
                     "mean absolute difference", "test–retest r", "95 % interval", "<"},
                    rows);
}

std::string retest_answers_html(const Results& results) {
  std::string rows;
  for (const RetestAnswer& answer : results.retest_answers)
    rows += HtmlRow()
                .text(answer.participant, answer.stimulus, answer.against, answer.item)
                .number(fmt::format("{}, {}", answer.first_trial, answer.second_trial))
                .text(answer.first, answer.second)
                .number(answer.difference ? decimal(*answer.difference) : "–")
                .html();
  return wide_table({"<participant", "<video", "<reference", "<item", "trials", "<first", "<second",
                     "difference"},
                    rows);
}

std::string demographics_html(const Results& results) {
  std::string rows;
  for (const DemographicSummary& d : demographics_of(results.demographics, results.answer_set))
    rows += HtmlRow()
                .text(d.question, d.answer)
                .number(d.is_count ? decimal(d.value, 0) : decimal(d.value), d.people)
                .html();
  return wide_table({"<question", "<answer", "", "participants"}, rows);
}

std::string groups_html(const Results& results) {
  const AnswerSet& answer_set = results.answer_set;
  std::string rows;
  for (const GroupComparison& c : results.groups)
    rows += HtmlRow()
                .text(c.question, c.one + " – " + c.other, answer_set.stimuli[c.stimulus].id,
                      scale_name(answer_set.scales[c.scale]))
                .number(fmt::format("{} ({})", decimal(c.mean_one), c.people_one),
                        fmt::format("{} ({})", decimal(c.mean_other), c.people_other), c.welch.mean,
                        interval_text(c.welch.low(0.95), c.welch.high(0.95)),
                        fmt::format("{} ({})", decimal(c.welch.t), decimal(c.welch.degrees, 1)),
                        p_text(c.welch.p), p_text(c.adjusted), c.g)
                .html(c.adjusted < answer_set.alpha);
  return wide_table({"<question", "<answers", "<video", "<scale", "mean (n), first group",
                     "mean (n), second group", "difference", "95 % interval", "Welch t (df)", "p",
                     "p, corrected", "g"},
                    rows);
}

std::string recall_html(const Results& results, bool by_points) {
  std::string rows;
  for (const Confusion& confusion : results.confusions) {
    for (const ConfusionRow& row : confusion.rows) {
      if (row.own < 0 || confusion.by_points != by_points) continue;
      rows += HtmlRow()
                  .text(row.emotion, confusion.of)
                  .number(row.judged, percent_text(row.recall),
                          std::isnan(row.low) ? "–" : share_interval(row.low, row.high),
                          percent_text(confusion.chance),
                          by_points ? fmt::format("{} of {}", row.hits, row.decided)
                                    : std::to_string(row.hits),
                          p_text(row.p), p_text(row.adjusted))
                  .html(row.adjusted < results.answer_set.alpha && row.is_above(confusion.chance));
    }
  }
  return by_points ? wide_table({"<intended", "<of", "presentations", "recall (share of points)",
                                 "95 % interval (Wilson)", "chance", "top response", "p, binomial",
                                 "p, corrected"},
                                rows)
                   : wide_table({"<intended", "<of", "presentations", "recall (share of choices)",
                                 "95 % interval (Wilson)", "chance", "chosen", "p, binomial",
                                 "p, corrected"},
                                rows);
}

std::string agreement_html(const Results& results) {
  std::string rows;
  for (const Reliability& r : results.reliability) {
    const Intraclass& icc = r.intraclass;
    rows += HtmlRow()
                .text(scale_name(results.answer_set.scales[r.scale]))
                .number(icc.stimuli, icc.raters, decimal(icc.answers_per_stimulus, 1), icc.one,
                        icc.one_k, icc.two, icc.two_k, icc.three, icc.three_k, r.complete_people,
                        r.alpha)
                .text(r.remark)
                .html();
  }
  return wide_table(
      {"<scale", "videos", "participants", "k", "ICC(1)", "ICC(1,k)", "ICC(2,1)", "ICC(2,k)",
       "ICC(3,1)", "ICC(3,k)", "rated all videos", "Cronbach’s α", "<remark"},
      rows);
}

std::string preferences_html(const Results& results) {
  std::string rows;
  for (const PreferenceCount& c : results.preferences)
    rows += HtmlRow()
                .text(results.answer_set.stimuli[c.one].id, results.answer_set.stimuli[c.other].id,
                      pair_question(results.answer_set, c.item))
                .number(fmt::format("{} of {}", c.for_one, c.trials), c.ties,
                        share_interval(c.low, c.high), p_text(c.p), p_text(c.adjusted))
                .html(c.adjusted < results.answer_set.alpha);
  return wide_table({"<first", "<second", "<item", "first chosen", "ties", "95 % interval (Wilson)",
                     "p, binomial", "p, corrected"},
                    rows);
}

std::string remarks_html(const std::vector<Remark>& remarks) {
  std::string rows;
  for (const Remark& remark : remarks)
    rows += HtmlRow().text(remark.stimulus, remark.participant).prose(remark.text).html();
  return wide_table({"<video", "<participant", "<comment"}, rows);
}

}  // namespace mien::pipeline

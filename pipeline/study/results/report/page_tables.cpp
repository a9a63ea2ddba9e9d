#include "pipeline/study/results/report/page_tables.h"

#include <cmath>

#include <fmt/format.h>

#include "pipeline/study/results/report/html_row.h"

namespace mien::pipeline {

namespace {

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

std::string catch_summary_html(const Results& results) {
  std::string rows;
  for (const CatchSummary& s : results.catch_summaries)
    rows += HtmlRow()
                .text(s.participant.empty() ? "all" : s.participant)
                .text(s.item.empty() ? "all" : s.item)
                .number(s.answers)
                .number(fmt::format("{} ({})", s.equal, percent_text(1.0 * s.equal / s.answers)))
                .number(decimal(s.mean_difference))
                .number(decimal(s.retest.r))
                .number(interval_text(s.retest.low, s.retest.high))
                .text(s.is_excluded ? "left out" : "")
                .html();
  return wide_table({"<participant", "<asked", "answered twice", "the same",
                     "mean size of the difference", "test–retest r", "95 % interval", "<"},
                    rows);
}

std::string catch_answers_html(const Results& results) {
  std::string rows;
  for (const CatchAnswer& answer : results.catch_answers)
    rows += HtmlRow()
                .text(answer.participant)
                .text(answer.stimulus)
                .text(answer.against)
                .text(answer.item)
                .number(fmt::format("{}, {}", answer.first_trial, answer.second_trial))
                .text(answer.first)
                .text(answer.second)
                .number(answer.difference ? decimal(*answer.difference) : "–")
                .html();
  return wide_table(
      {"<participant", "<video", "<beside", "<asked", "trials", "<first", "<second", "difference"},
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

std::string groups_html(const Results& results) {
  const Gathered& gathered = results.gathered;
  std::string rows;
  for (const GroupComparison& c : results.groups)
    rows += HtmlRow()
                .text(c.question)
                .text(c.one + " – " + c.other)
                .text(gathered.stimuli[c.stimulus].id)
                .text(scale_name(gathered.scales[c.scale]))
                .number(fmt::format("{} ({})", decimal(c.mean_one), c.people_one))
                .number(fmt::format("{} ({})", decimal(c.mean_other), c.people_other))
                .number(decimal(c.welch.mean))
                .number(interval_text(c.welch.low(0.95), c.welch.high(0.95)))
                .number(fmt::format("{} ({})", decimal(c.welch.t), decimal(c.welch.degrees, 1)))
                .number(p_text(c.welch.p))
                .number(p_text(c.adjusted))
                .number(decimal(c.g))
                .html(c.adjusted < gathered.alpha);
  return wide_table({"<question", "<answers", "<video", "<scale", "mean (n) of the first",
                     "mean (n) of the other", "difference", "95 % interval", "Welch t (df)", "p",
                     "p, corrected", "g"},
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

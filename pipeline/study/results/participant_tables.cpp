#include "pipeline/study/results/result_rows.h"

namespace mien::pipeline {

namespace {

using SessionRow = ResultRow<ParticipantSummary>;
using CatchRow = ResultRow<CatchAnswer>;
using CatchSummaryRow = ResultRow<CatchSummary>;
using DemographicRow = ResultRow<DemographicSummary>;
using RemarkRow = ResultRow<Remark>;
using WordRow = ResultRow<GivenWord>;

constexpr SharedColumn named_stimulus_column = {"stimulus", "", "the stimulus",
                                                [](auto& r) { return r.of.stimulus; }};
constexpr SharedColumn item_column = {"item", "", "the scale or question",
                                      [](auto& r) { return r.of.item; }};
constexpr SharedColumn excluded_column = {"excluded", "",
                                          "1 for who is left out, by the rule of the report",
                                          [](auto& r) { return r.of.is_excluded; }};

constexpr auto session_columns = result_table<SessionRow>(
    "results/sessions.csv", "a participant",
    {{"participant", "", "who answered", [](auto& r) { return r.of.participant; }},
     {"trials", "", "trials done, practice and checks among them",
      [](auto& r) { return r.of.trials; }},
     {"answers", "", "answers that are analysed, unless the participant is excluded",
      [](auto& r) { return r.of.answers; }},
     {"checks", "", "attention checks", [](auto& r) { return r.of.checks; }},
     {"passed", "", "of these passed", [](auto& r) { return r.of.passed; }},
     excluded_column,
     {"median_rt_ms", "ms", "median time of an answer", [](auto& r) { return r.of.median_rt_ms; }},
     {"stalls", "", "times that a video stopped for want of data",
      [](auto& r) { return r.of.stalls; }},
     {"dropped_frames", "", "frames that were not shown",
      [](auto& r) { return r.of.dropped_frames; }},
     {"blurs", "", "times that the window was left", [](auto& r) { return r.of.blurs; }},
     {"constant", "", "1 for who answered everything at the same place; kept",
      [](auto& r) { return r.of.is_constant; }},
     {"unfinished", "", "1 for who answered fewer trials than were planned",
      [](auto& r) { return r.of.is_unfinished; }}});

constexpr auto demographics_columns = result_table<DemographicRow>(
    "results/demographics.csv", "an answer to a question",
    {{"question", "", "the question", [](auto& r) { return r.of.question; }},
     {"answer", "", "a word, or which number of numbers", [](auto& r) { return r.of.answer; }},
     {"value", "", "how many gave it, or the number", [](auto& r) { return r.of.value; }},
     {"people", "", "who answered the question", [](auto& r) { return r.of.people; }}});

constexpr auto catch_columns = result_table<CatchRow>(
    "results/catch_trials.csv", "a question answered twice",
    {{"participant", "", "who answered twice", [](auto& r) { return r.of.participant; }},
     excluded_column,
     named_stimulus_column,
     {"against", "", "the other one of a pair, or the reference beside",
      [](auto& r) { return r.of.against; }},
     item_column,
     {"first_trial", "", "number of the trial that counts",
      [](auto& r) { return r.of.first_trial; }},
     {"second_trial", "", "number of the catch trial, which does not count",
      [](auto& r) { return r.of.second_trial; }},
     {"first", "scale points", "answer that counts; of choices, pairs and words what it was",
      [](auto& r) { return r.of.first; }},
     {"second", "scale points", "answer of the catch trial", [](auto& r) { return r.of.second; }},
     {"difference", "scale points", "second less first; of ratings alone",
      [](auto& r) { return r.of.difference ? field_of(*r.of.difference) : ""; }},
     {"equal", "", "1 where both are the same", [](auto& r) { return r.of.is_equal(); }}});

constexpr auto catch_summary_columns = result_table<CatchSummaryRow>(
    "results/catch_summary.csv", "some who answered twice",
    {{"participant", "", "whose answers; empty: of all who count",
      [](auto& r) { return r.of.participant; }},
     {"item", "", "the scale or question; empty: all", [](auto& r) { return r.of.item; }},
     excluded_column,
     {"answers", "", "questions answered twice", [](auto& r) { return r.of.answers; }},
     {"equal", "", "of these the same both times", [](auto& r) { return r.of.equal; }},
     {"share_equal", "0–1", "their share", [](auto& r) { return 1.0 * r.of.equal / r.of.answers; }},
     {"mean_absolute_difference", "scale points", "mean size of second less first",
      [](auto& r) { return r.of.mean_difference; }},
     {"retest_r", "-1–1",
      "test-retest correlation: Pearson's of first with second ratings; empty where one of them "
      "does not vary",
      [](auto& r) { return r.of.retest.r; }},
     {"retest_low", "-1–1", "lower end of its 95 % interval (Fisher's z)",
      [](auto& r) { return r.of.retest.low; }},
     {"retest_high", "-1–1", "upper end", [](auto& r) { return r.of.retest.high; }}});

/// Of texts that people wrote.
constexpr auto remarks_table(std::string_view path, std::string_view rows) {
  return result_table<RemarkRow>(
      path, rows,
      {{"participant", "", "who wrote it", [](auto& r) { return r.of.participant; }},
       named_stimulus_column,
       item_column,
       {"text", "", "what was written", [](auto& r) { return r.of.text; }}});
}

constexpr auto comment_columns = remarks_table("results/comments.csv", "a comment");
constexpr auto word_columns = remarks_table("results/words.csv", "an answer in words");

constexpr auto word_count_columns = result_table<WordRow>(
    "results/word_counts.csv", "a word for a stimulus",
    {named_stimulus_column,
     item_column,
     {"word", "", "a word: answers are divided at commas, semicolons and ends of lines",
      [](auto& r) { return r.of.word; }},
     {"people", "", "who gave it", [](auto& r) { return r.of.people; }},
     {"asked", "", "who gave any word about the stimulus", [](auto& r) { return r.of.asked; }}});

}  // namespace

void add_participants(const Results& results, std::vector<WrittenTable>& tables) {
  const Gathered& gathered = results.gathered;
  add_results(session_columns, results.participants, gathered, tables);
  add_results(demographics_columns, demographics_of(results.demographics, gathered), gathered,
              tables);
  add_results(catch_columns, results.catch_answers, gathered, tables);
  add_results(catch_summary_columns, results.catch_summaries, gathered, tables);
  add_results(comment_columns, gathered.remarks, gathered, tables);
  add_results(word_columns, gathered.words, gathered, tables);
  add_results(word_count_columns, results.words, gathered, tables);
}

}  // namespace mien::pipeline

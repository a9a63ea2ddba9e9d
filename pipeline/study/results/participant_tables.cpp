#include "pipeline/study/results/result_rows.h"

namespace mien::pipeline {

namespace {

using SessionRow = ResultRow<ParticipantSummary>;
using RetestRow = ResultRow<RetestAnswer>;
using RetestSummaryRow = ResultRow<RetestSummary>;
using DemographicRow = ResultRow<DemographicSummary>;
using FlowRow = ResultRow<FlowStage>;
using RemarkRow = ResultRow<Remark>;
using WordRow = ResultRow<WordFrequency>;
using RuleRow = ResultRow<RuleCount>;
using FlagRow = ResultRow<ListedFlag>;

constexpr SharedColumn named_stimulus_column{"stimulus", "", "stimulus id",
                                             [](auto& r) { return r.of.stimulus; }};
constexpr SharedColumn item_column{"item", "", "scale or question id",
                                   [](auto& r) { return r.of.item; }};
constexpr SharedColumn excluded_column{"excluded", "",
                                       "1 for participants excluded by the report's rule",
                                       [](auto& r) { return r.of.is_excluded; }};

constexpr ResultColumn<SessionRow> session_list[] = {
    {"participant", "", "participant id", [](auto& r) { return r.of.participant; }},
    {"trials", "", "trials completed, including practice and checks",
     [](auto& r) { return r.of.trials; }},
    {"answers", "", "answers analysed, unless the participant is excluded",
     [](auto& r) { return r.of.answers; }},
    {"checks", "", "attention checks", [](auto& r) { return r.of.checks; }},
    {"passed", "", "attention checks passed", [](auto& r) { return r.of.passed; }},
    excluded_column,
    {"median_rt_ms", "ms", "median response time of the answers analysed",
     [](auto& r) { return r.of.median_rt_ms; }},
    {"stalls", "", "buffering interruptions", [](auto& r) { return r.of.stalls; }},
    {"dropped_frames", "", "dropped video frames", [](auto& r) { return r.of.dropped_frames; }},
    {"blurs", "", "tab switches", [](auto& r) { return r.of.blurs; }},
    {"constant", "",
     "1 for straight-lining: three or more answers on scales, all at the same position; included",
     [](auto& r) { return r.of.is_straight_lining; }},
    {"unfinished", "",
     "1 if the participant answered fewer trials than planned; whether the last page was reached "
     "is "
     "in the table of participants",
     [](auto& r) { return r.of.is_unfinished; }}};

constexpr auto session_columns =
    result_table<SessionRow>("results/sessions.csv", "participant", session_list);

/// For questionnaires with quality rules.
constexpr auto flagged_session_columns = result_table<SessionRow>(
    "results/sessions.csv", "participant", session_list,
    std::to_array<ResultColumn<SessionRow>>(
        {{"flagged_answers", "",
          "answers that quality rules flag, whether or not they are analysed",
          [](auto& r) { return r.of.flagged_answers; }},
         {"reasons", "", "reasons for which quality rules flag the participant; empty: none",
          [](auto& r) { return r.of.reasons; }}}));

constexpr auto rule_columns = result_table<RuleRow>(
    "results/quality_rules.csv", "quality rule, and of all rules together",
    {{"rule", "", "key of the rule in the manifest; empty: all rules together",
      [](auto& r) { return r.of.rule; }},
     {"bound", "", "its value", [](auto& r) { return r.of.bound; }},
     {"flags", "", "what it flags", [](auto& r) { return r.of.words; }},
     {"participants", "", "participants who are flagged, or some of whose answers are",
      [](auto& r) { return r.of.is_examined ? std::to_string(r.of.participants) : ""; }},
     {"answers", "",
      "answers that are flagged, or whose participant is; without practice, warm-up, attention "
      "checks and repeated stimuli; both are empty if the rule could not be applied",
      [](auto& r) { return r.of.is_examined ? std::to_string(r.of.answers) : ""; }},
     {"excluded", "", "1 if the report leaves out what the rule flags",
      [](auto& r) { return r.of.is_excluded; }}});

constexpr auto flag_columns = result_table<FlagRow>(
    "results/quality_flags.csv", "flagged answer or participant, and rule",
    {{"participant", "", "participant id", [](auto& r) { return r.of.participant; }},
     {"trial", "", "trial of the flagged answer; empty: the participant is flagged",
      [](auto& r) { return r.of.trial == 0 ? std::string() : std::to_string(r.of.trial); }},
     named_stimulus_column,
     {"against", "", "the other stimulus of a pair, or the reference shown beside it",
      [](auto& r) { return r.of.against; }},
     item_column,
     {"rule", "", "key of the rule in the manifest",
      [](auto& r) { return word_of(quality_rule_words, r.of.flag.rule); }},
     {"reason", "", "reason, with the number that breaks the rule",
      [](auto& r) { return r.of.flag.reason; }},
     {"excluded", "", "1 if the report leaves out the answer or participant for it",
      [](auto& r) { return r.of.is_excluded; }}});

constexpr auto flow_columns = result_table<FlowRow>(
    "results/participant_flow.csv", "stage of participation",
    {{"stage", "", "what happened; without refusals and withdrawals, of which nothing is kept",
      [](auto& r) { return r.of.stage; }},
     {"sessions", "", "number of sessions, or of participants who gave answers",
      [](auto& r) { return r.of.sessions; }}});

constexpr auto demographics_columns = result_table<DemographicRow>(
    "results/demographics.csv", "question and answer",
    {{"question", "", "question id", [](auto& r) { return r.of.question; }},
     {"answer", "",
      "the answer, or for numbers the statistic: mean, standard deviation, least or most",
      [](auto& r) { return r.of.answer; }},
     {"value", "", "number of participants who gave this answer, or the value of the statistic",
      [](auto& r) { return r.of.value; }},
     {"people", "", "participants who answered the question",
      [](auto& r) { return r.of.people; }}});

constexpr auto retest_columns = result_table<RetestRow>(
    "results/retest.csv", "repeated answer",
    {{"participant", "", "participant id", [](auto& r) { return r.of.participant; }},
     excluded_column,
     named_stimulus_column,
     {"against", "", "the other stimulus of a pair, or the reference shown beside it",
      [](auto& r) { return r.of.against; }},
     item_column,
     {"first_trial", "", "number of the first trial, which is analysed",
      [](auto& r) { return r.of.first_trial; }},
     {"second_trial", "", "number of the repeated trial, which is not analysed",
      [](auto& r) { return r.of.second_trial; }},
     {"first", "scale units",
      "first answer, which is analysed; for choices, pairs and words the answer itself",
      [](auto& r) { return r.of.first; }},
     {"second", "scale units", "answer in the repeated trial", [](auto& r) { return r.of.second; }},
     {"difference", "scale units", "second minus first; ratings only",
      [](auto& r) { return r.of.difference ? number_field(*r.of.difference) : ""; }},
     {"equal", "", "1 if both answers are the same", [](auto& r) { return r.of.is_equal(); }}});

constexpr auto retest_summary_columns = result_table<RetestSummaryRow>(
    "results/retest_summary.csv", "participant and item with repeated answers, and per total",
    {{"participant", "", "participant id; empty: all participants analysed",
      [](auto& r) { return r.of.participant; }},
     {"item", "", "scale or question id; empty: all", [](auto& r) { return r.of.item; }},
     excluded_column,
     {"answers", "", "number of repeated answers", [](auto& r) { return r.of.answers; }},
     {"equal", "", "number of repeated answers that are the same as the first",
      [](auto& r) { return r.of.equal; }},
     {"share_equal", "0–1", "proportion of repeated answers that are the same as the first",
      [](auto& r) { return 1.0 * r.of.equal / r.of.answers; }},
     {"mean_absolute_difference", "scale units",
      "mean absolute difference between second and first ratings; empty without ratings",
      [](auto& r) { return r.of.mean_difference; }},
     {"retest_r", "-1–1",
      "test–retest correlation (Pearson) of first with second ratings; empty if there are too few "
      "or either has no variance",
      [](auto& r) { return r.of.retest.r; }},
     {"retest_low", "-1–1", "lower end of its 95 % interval (Fisher's z)",
      [](auto& r) { return r.of.retest.low; }},
     {"retest_high", "-1–1", "upper end", [](auto& r) { return r.of.retest.high; }}});

/// The form of tables of free texts.
constexpr auto remarks_table(std::string_view path, std::string_view rows) {
  return result_table<RemarkRow>(
      path, rows,
      {{"participant", "", "participant id", [](auto& r) { return r.of.participant; }},
       named_stimulus_column,
       item_column,
       {"text", "", "text as written", [](auto& r) { return r.of.text; }}});
}

constexpr auto comment_columns = remarks_table("results/comments.csv", "comment");
constexpr auto word_columns = remarks_table("results/words.csv", "free-text answer");

constexpr auto word_count_columns = result_table<WordRow>(
    "results/word_counts.csv", "stimulus and word",
    {named_stimulus_column,
     item_column,
     {"word", "", "a word; answers are split at commas, semicolons and line ends",
      [](auto& r) { return r.of.word; }},
     {"people", "", "number of participants who gave it", [](auto& r) { return r.of.people; }},
     {"asked", "", "number of participants who gave any word for the stimulus and question",
      [](auto& r) { return r.of.respondents; }}});

}  // namespace

void add_participants(const Results& results, std::vector<WrittenTable>& tables) {
  const AnswerSet& answer_set = results.answer_set;
  if (results.rule_counts.empty())
    add_results(session_columns, results.participants, answer_set, tables);
  else
    add_results(flagged_session_columns, results.participants, answer_set, tables);
  add_results(rule_columns, results.rule_counts, answer_set, tables);
  add_results(flag_columns, results.quality_flags, answer_set, tables);
  add_results(flow_columns, results.flow, answer_set, tables);
  add_results(demographics_columns, demographics_of(results.demographics, answer_set), answer_set,
              tables);
  add_results(retest_columns, results.retest_answers, answer_set, tables);
  add_results(retest_summary_columns, results.retest_summaries, answer_set, tables);
  add_results(comment_columns, answer_set.remarks, answer_set, tables);
  add_results(word_columns, answer_set.words, answer_set, tables);
  add_results(word_count_columns, results.words, answer_set, tables);
}

}  // namespace mien::pipeline

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pipeline/study/results/result_rows.h"

namespace mien::pipeline {

namespace {

struct WorthRow {
  const AnswerSet& in;
  const PairWorth& all;
  const StimulusWorth& of;
};

struct WorthContrastRow {
  const AnswerSet& in;
  const PairWorth& all;
  const WorthContrast& of;
};

using WorthTestRow = ResultRow<PairWorth>;

struct TriadsRow {
  const AnswerSet& in;
  const PairWorth& all;
  const ParticipantTriads& of;
};

constexpr SharedColumn worth_item_column{"item", "", "scale or question id",
                                         [](auto& r) { return r.all.item; }};

constexpr auto worth_columns = result_table<WorthRow>(
    "results/worth.csv", "scale and stimulus or condition of a study of pairs or sets",
    {worth_item_column,
     {"compared", "",
      "id of the stimulus; if the analysis names factors, a combination of their levels, for all "
      "stimuli with these levels",
      [](auto& r) { return r.of.name; }},
     {"comparisons", "", "comparisons with others; of sets, implied ones",
      [](auto& r) { return r.of.comparisons(); }},
     {"chosen", "", "comparisons in which it was chosen", [](auto& r) { return r.of.chosen; }},
     {"other_chosen", "", "comparisons in which the other one was chosen",
      [](auto& r) { return r.of.other_chosen; }},
     {"ties", "", "comparisons in which neither was preferred", [](auto& r) { return r.of.ties; }},
     {"record", "", "why there is no worth: always chosen, never chosen …; empty if there is one",
      [](auto& r) { return record_text(r.of); }},
     {"group", "",
      "stimuli whose worths can be compared have the same number; differences between groups are "
      "infinite or unknown",
      [](auto& r) { return r.of.group; }},
     {"worth", "log-odds",
      "log-worth of Bradley and Terry's model, with a sum of zero in each group: a difference of 1 "
      "means odds of e to 1 of being chosen",
      [](auto& r) { return r.of.worth; }},
     {"se", "log-odds", "its standard error, treating all answers as independent",
      [](auto& r) { return r.of.error; }},
     {"low", "log-odds", "lower end of the reported 95 % interval",
      [](auto& r) { return r.all.ends_of(r.of).low; }},
     {"high", "log-odds", "upper end", [](auto& r) { return r.all.ends_of(r.of).high; }},
     {"interval", "",
      "how the reported interval was determined: participants (bootstrap), or answers (profile "
      "likelihood, treating all answers as independent); empty for sets whose participants are too "
      "few for an interval",
      [](auto& r) {
        return !r.all.has_intervals() ? "" : r.all.is_by_participants ? "participants" : "answers";
      }},
     {"bootstrap_low", "log-odds", "lower end of the interval from resampled participants",
      [](auto& r) { return r.of.by_participants.low; }},
     {"bootstrap_high", "log-odds", "upper end", [](auto& r) { return r.of.by_participants.high; }},
     {"profile_low", "log-odds", "lower end of the profile-likelihood interval",
      [](auto& r) { return r.of.by_answers.low; }},
     {"profile_high", "log-odds", "upper end", [](auto& r) { return r.of.by_answers.high; }},
     {"elo", "Elo points",
      "rating by Elo's method (begins with 1500, step 32), which depends on the order of the "
      "comparisons: mean over 100 random orders",
      [](auto& r) { return r.of.elo.mean; }},
     {"elo_sd", "Elo points", "standard deviation of that rating over the orders",
      [](auto& r) { return r.of.elo.deviation; }}});

using ScoreRow = ResultRow<BestWorstScore>;

constexpr auto score_columns = result_table<ScoreRow>(
    "results/best_worst.csv", "scale and stimulus of a study of sets",
    {{"scale", "", "scale id", [](auto& r) { return r.of.scale; }},
     stimulus_column,
     {"shown", "", "answered sets with the stimulus", [](auto& r) { return r.of.shown; }},
     {"best", "", "of these, sets in which it was closest to the high end of the scale",
      [](auto& r) { return r.of.best; }},
     {"worst", "", "sets in which it was closest to the low end",
      [](auto& r) { return r.of.worst; }},
     {"score", "-1–1", "(best − worst) / shown", [](auto& r) { return r.of.score(); }},
     {"people", "", "participants who answered sets with the stimulus",
      [](auto& r) { return r.of.people; }},
     {"low", "-1–1",
      "lower end of the 95 % interval of the mean of the participants' scores "
      "(Student)",
      [](auto& r) { return r.of.ends.low; }},
     {"high", "-1–1", "upper end", [](auto& r) { return r.of.ends.high; }}});

constexpr auto worth_test_columns = result_table<WorthTestRow>(
    "results/worth_tests.csv", "scale of a study of pairs or sets",
    {{"item", "", "scale or question id", [](auto& r) { return r.of.item; }},
     {"people", "", "participants who compared stimuli", [](auto& r) { return r.of.people; }},
     {"stimuli", "", "number of stimuli, or conditions, compared",
      [](auto& r) { return r.of.stimuli.size(); }},
     {"comparisons", "", "number of answers", [](auto& r) { return r.of.comparisons; }},
     {"ties", "", "answers that prefer neither", [](auto& r) { return r.of.ties; }},
     {"within_conditions", "",
      "further comparisons, which are left out: of two stimuli of the same condition",
      [](auto& r) { return r.of.within_conditions; }},
     {"chi_equal", "",
      "likelihood-ratio statistic of the test that all worths are equal; empty for sets",
      [](auto& r) { return r.of.equal.chi; }},
     {"df_equal", "", "its degrees of freedom", [](auto& r) { return r.of.equal.degrees; }},
     {"p_equal", "", "its p, treating all answers as independent",
      [](auto& r) { return p_field(r.of.equal.p); }},
     {"p_equal_adjusted", "", "p_equal corrected for multiple comparisons, over the table",
      [](auto& r) { return p_field(r.of.equal_adjusted); }},
     {"order", "log-odds",
      "order effect: log-odds in favour of the stimulus on the left (of pairs shown in turn, the "
      "first) if both are of equal worth; "
      "empty if it cannot be determined",
      [](auto& r) { return r.of.fit.order; }},
     {"order_se", "log-odds", "its standard error, treating all answers as independent",
      [](auto& r) { return r.of.fit.order_error; }},
     {"order_low", "log-odds", "lower end of its 95 % interval from resampled participants",
      [](auto& r) { return r.of.order_ends.low; }},
     {"order_high", "log-odds", "upper end", [](auto& r) { return r.of.order_ends.high; }},
     {"chi_order", "", "likelihood-ratio statistic of the test that there is no order effect",
      [](auto& r) { return r.of.order.chi; }},
     {"p_order", "", "its p (1 degree of freedom), treating all answers as independent",
      [](auto& r) { return p_field(r.of.order.p); }},
     {"p_order_adjusted", "", "p_order corrected for multiple comparisons, over the table",
      [](auto& r) { return p_field(r.of.order_adjusted); }},
     {"tie", "log",
      "parameter of ties: logarithm of P(tie)/√(P(one chosen)·P(other chosen)); empty without ties",
      [](auto& r) { return r.of.fit.tie; }},
     {"tie_se", "log", "its standard error", [](auto& r) { return r.of.fit.tie_error; }},
     {"resamples", "", "resamples of participants", [](auto& r) { return r.of.resamples; }},
     {"without_estimate", "", "resamples in which not all worths are finite",
      [](auto& r) { return r.of.without_estimate; }},
     {"triads", "", "sets of three stimuli that were all compared with each other",
      [](auto& r) { return r.of.transitivity.triads; }},
     {"weak", "", "of these, those whose proportions of choices violate weak transitivity",
      [](auto& r) { return r.of.transitivity.weak; }},
     {"moderate", "", "those that violate moderate transitivity",
      [](auto& r) { return r.of.transitivity.moderate; }},
     {"strong", "", "those that violate strong transitivity",
      [](auto& r) { return r.of.transitivity.strong; }}});

constexpr auto worth_contrast_columns = result_table<WorthContrastRow>(
    "results/worth_contrasts.csv", "scale and contrast of log-worths of a study of pairs",
    {worth_item_column,
     {"kind", "",
      "planned (stated in the manifest) or pairwise (two stimuli or conditions); p values are "
      "corrected over all contrasts of a kind, on all scales",
      [](auto& r) { return word_of(contrast_kind_words, r.of.kind); }},
     {"contrast", "", "its name", [](auto& r) { return r.of.name; }},
     {"weights", "", "levels, or stimuli or conditions, with their weights",
      [](auto& r) { return r.of.weights; }},
     {"settings", "",
      "of a planned contrast: combinations of levels of the other factors in which all these "
      "levels were compared, separated by semicolons; log-worths are averaged over them",
      [](auto& r) { return fmt::format("{}", fmt::join(r.of.settings, "; ")); }},
     {"difference", "log-odds", "sum of the log-worths times their weights; empty without worths",
      [](auto& r) { return r.of.difference; }},
     {"low", "log-odds", "lower end of its 95 % interval", [](auto& r) { return r.of.ends.low; }},
     {"high", "log-odds", "upper end", [](auto& r) { return r.of.ends.high; }},
     {"se", "log-odds", "its standard error", [](auto& r) { return r.of.error; }},
     {"interval", "",
      "how interval, standard error and p were determined: participants (bootstrap; Student's t), "
      "or answers (information matrix, treating all answers as independent; z)",
      [](auto& r) { return r.all.is_by_participants ? "participants" : "answers"; }},
     {"statistic", "", "difference / se: t or z", [](auto& r) { return r.of.statistic; }},
     {"df", "", "degrees of freedom of t; empty for z", [](auto& r) { return r.of.degrees; }},
     {"p", "", "its two-sided p", [](auto& r) { return p_field(r.of.p); }},
     {"p_adjusted", "", "p corrected for multiple comparisons",
      [](auto& r) { return p_field(r.of.adjusted); }}});

constexpr auto triads_columns = result_table<TriadsRow>(
    "results/circular_triads.csv", "scale and participant who compared all stimuli with each other",
    {worth_item_column,
     {"participant", "", "participant id", [](auto& r) { return r.in.people[r.of.person]; }},
     {"circular", "", "circular triads: a preferred to b, b to c, and c to a",
      [](auto& r) { return r.of.triads.circular; }},
     {"most", "", "greatest possible number of them", [](auto& r) { return r.of.triads.most; }},
     {"by_chance", "", "number expected of random answers",
      [](auto& r) { return r.of.triads.by_chance; }},
     {"zeta", "0–1",
      "Kendall's coefficient of consistence: 1 without circular triads, 0 with as many as possible",
      [](auto& r) { return r.of.triads.zeta; }}});

}  // namespace

void add_worths(const Results& results, std::vector<WrittenTable>& tables) {
  const AnswerSet& answer_set = results.answer_set;
  add_results(score_columns, results.best_worst, answer_set, tables);
  std::vector<WorthRow> worths;
  std::vector<WorthContrastRow> contrasts;
  std::vector<TriadsRow> triads;
  for (const PairWorth& worth : results.worths) {
    for (const StimulusWorth& one : worth.stimuli) worths.push_back({answer_set, worth, one});
    for (const WorthContrast& one : worth.contrasts) contrasts.push_back({answer_set, worth, one});
    for (const ParticipantTriads& one : worth.triads) triads.push_back({answer_set, worth, one});
  }
  add_table(worth_columns, worths, answer_set.simulated, tables);
  add_results(worth_test_columns, results.worths, answer_set, tables);
  add_table(worth_contrast_columns, contrasts, answer_set.simulated, tables);
  add_table(triads_columns, triads, answer_set.simulated, tables);
}

}  // namespace mien::pipeline

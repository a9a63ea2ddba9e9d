#include "pipeline/study/results/quality_lists.h"

#include <algorithm>
#include <optional>
#include <set>
#include <tuple>

#include <fmt/format.h>

#include "motion/text/excerpt.h"

namespace mien::pipeline {

namespace {

bool has_rule(const std::vector<QualityFlag>& flags, std::optional<QualityRule> rule) {
  return rule ? std::ranges::count(flags, *rule, &QualityFlag::rule) > 0 : !flags.empty();
}

/// Counts what a rule flagged or, without a rule, what any of them did.
void count_flagged(std::optional<QualityRule> rule, const QualityFlags& flags,
                   const std::vector<AnswerRow>& rows, RuleCount& count) {
  std::set<std::string> participants;
  for (const auto& [participant, own] : flags.participants)
    if (has_rule(own, rule)) participants.insert(participant);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const AnswerRow& row = rows[i];
    const bool is_own = has_rule(flags.of_answer(i), rule);
    if (!row.counts() || (!is_own && !has_rule(flags.of_participant(row.participant), rule)))
      continue;
    ++count.answers;
    participants.insert(row.participant);
  }
  count.participants = static_cast<int>(participants.size());
}

StatedRule attention_rule(const AttentionRule& rule) {
  const int most = rule.max_failed_checks;
  return {QualityRule::max_failed_checks, std::to_string(most),
          fmt::format("participants who failed more than {} attention check{}", most,
                      most == 1 ? "" : "s")};
}

}  // namespace

std::vector<ListedFlag> listed_flags(const AnswerSet& answer_set, std::vector<AnswerRow> rows) {
  const QualityFlags& quality = answer_set.quality;
  std::vector<ListedFlag> all;
  if (quality.stated.empty()) return all;
  separate_participants(rows);
  for (const auto& [participant, flags] : quality.participants)
    for (const QualityFlag& flag : flags)
      all.push_back({.participant = participant,
                     .flag = flag,
                     .is_excluded = is_excluding(flag.rule, quality.rules)});
  for (const auto& [index, flags] : quality.answers) {
    const AnswerRow& row = rows[index];
    for (const QualityFlag& flag : flags)
      all.push_back({row.participant, row.trial, row.stimulus, row.against, row.item, flag,
                     is_excluding(flag.rule, quality.rules)});
  }
  std::ranges::stable_sort(
      all, {}, [](const ListedFlag& one) { return std::tuple(one.participant, one.trial); });
  return all;
}

std::vector<RuleCount> rule_counts(const AnswerSet& answer_set, std::vector<AnswerRow> rows) {
  const QualityFlags& quality = answer_set.quality;
  std::vector<StatedRule> stated = quality.stated;
  if (stated.empty()) return {};
  if (has_attention_checks(answer_set))
    stated.insert(stated.begin(), attention_rule(answer_set.rule));
  separate_participants(rows);
  std::vector<RuleCount> counts;
  for (const StatedRule& one : stated) {
    counts.push_back(
        {.rule = std::string(word_of(quality_rule_words, one.rule)),
         .bound = one.bound,
         .words = one.flagged,
         .is_excluded = is_excluding(one.rule, quality.rules),
         .is_examined = one.rule != QualityRule::repeated_by || answer_set.is_repetition_known});
    count_flagged(one.rule, quality, rows, counts.back());
  }
  counts.push_back({.words = "all rules together",
                    .is_excluded = std::ranges::all_of(quality.stated, [&](const StatedRule& one) {
                      return is_excluding(one.rule, quality.rules);
                    })});
  count_flagged(std::nullopt, quality, rows, counts.back());
  return counts;
}

std::vector<std::string> flagged_sentences(const AnswerSet& answer_set) {
  std::vector<std::string> sentences;
  if (answer_set.quality.stated.empty()) return sentences;
  for (const auto& [participant, flags] : answer_set.quality.participants)
    sentences.push_back(fmt::format(
        "participant {} is {}: {}", motion::in_quotes(participant),
        answer_set.quality.leaves_out(participant) ? "excluded" : "flagged, but included",
        reasons_text(flags)));
  return sentences;
}

}  // namespace mien::pipeline

#include "pipeline/study/results/quality_flags.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "motion/text/as_number.h"

namespace mien::pipeline {

namespace {

const std::vector<QualityFlag>& found_flags(const auto& map, const auto& key) {
  static const std::vector<QualityFlag> none;
  const auto found = map.find(key);
  return found == map.end() ? none : found->second;
}

/// "response time 180 ms < 250 ms", if `number` is less than `bound`.
void flag_below(QualityRule rule, const char* what, const std::optional<double>& number,
                const std::optional<double>& bound, std::vector<QualityFlag>& flags) {
  if (number && bound && *number < *bound)
    flags.push_back({rule, fmt::format("{} {} ms < {} ms", what, *number, *bound)});
}

void flag_above(QualityRule rule, const char* what, const std::optional<double>& number,
                const std::optional<double>& bound, std::vector<QualityFlag>& flags) {
  if (number && bound && *number > *bound)
    flags.push_back({rule, fmt::format("{} {} ms > {} ms", what, *number, *bound)});
}

std::vector<QualityFlag> flags_of_answer(const AnswerRow& row, const QualityRules& rules) {
  std::vector<QualityFlag> flags;
  flag_below(QualityRule::min_rt_ms, "response time", row.rt_ms, rules.min_rt_ms, flags);
  flag_above(QualityRule::max_rt_ms, "response time", row.rt_ms, rules.max_rt_ms, flags);
  flag_above(QualityRule::max_blur_ms, "window left for", row.blur_ms, rules.max_blur_ms, flags);
  return flags;
}

/// The raw answers on scales of each participant, in the order of trials.
std::map<std::string, std::vector<double>> raw_answers_on_scales(
    const std::vector<AnswerRow>& rows) {
  std::map<std::string, std::vector<std::pair<int, double>>> by_trial;
  for (const AnswerRow& row : rows) {
    const auto raw = motion::as_finite_number(row.value_raw);
    if (row.counts() && is_on_scale(row) && raw)
      by_trial[row.participant].emplace_back(row.trial, *raw);
  }
  std::map<std::string, std::vector<double>> all;
  for (auto& [participant, own] : by_trial) {
    std::ranges::stable_sort(own, {}, &std::pair<int, double>::first);
    for (const auto& [trial, raw] : own) all[participant].push_back(raw);
  }
  return all;
}

std::vector<QualityFlag> flags_of_participant(std::span<const double> raw,
                                              const QualityRules& rules) {
  std::vector<QualityFlag> flags;
  const int run = longest_run(raw);
  if (rules.max_longstring && run > *rules.max_longstring)
    flags.push_back(
        {QualityRule::max_longstring,
         fmt::format("longest run of equal answers {} > {}", run, *rules.max_longstring)});
  const double deviation = sample_deviation(raw);
  // Rounded down, so that the number shown is below the bound, too.
  if (rules.min_sd && deviation < *rules.min_sd)
    flags.push_back(
        {QualityRule::min_sd, fmt::format("standard deviation of answers {:g} < {}",
                                          std::floor(deviation * 1000.0) / 1000.0, *rules.min_sd)});
  return flags;
}

}  // namespace

bool QualityFlags::leaves_out(const std::string& participant) const {
  return std::ranges::any_of(of_participant(participant), [&](const QualityFlag& flag) {
    return is_excluding(flag.rule, rules);
  });
}

bool QualityFlags::leaves_out(std::size_t row) const {
  return rules.flagged == FlaggedAnswers::excluded && answers.contains(row);
}

const std::vector<QualityFlag>& QualityFlags::of_participant(const std::string& participant) const {
  return found_flags(participants, participant);
}

const std::vector<QualityFlag>& QualityFlags::of_answer(std::size_t row) const {
  return found_flags(answers, row);
}

std::string reasons_text(const std::vector<QualityFlag>& flags) {
  std::string text;
  for (const QualityFlag& flag : flags) text += (text.empty() ? "" : "; ") + flag.reason;
  return text;
}

int longest_run(std::span<const double> numbers) {
  int longest = 0;
  int run = 0;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    run = i > 0 && numbers[i] == numbers[i - 1] ? run + 1 : 1;
    longest = std::max(longest, run);
  }
  return longest;
}

double sample_deviation(std::span<const double> numbers) {
  if (numbers.size() < 2) return std::numeric_limits<double>::quiet_NaN();
  // Raw answers are whole numbers, whose sums are exact: a deviation that equals the bound is not
  // below it by rounding.
  double sum = 0.0;
  double squares = 0.0;
  for (const double number : numbers) {
    sum += number;
    squares += number * number;
  }
  const auto n = static_cast<double>(numbers.size());
  return std::sqrt(std::max(0.0, (n * squares - sum * sum) / (n * (n - 1.0))));
}

QualityFlags quality_flags(const Questionnaire& questionnaire, const std::vector<AnswerRow>& rows) {
  QualityFlags flags{.rules = questionnaire.analysis.quality,
                     .stated = stated_rules(questionnaire)};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (!rows[i].counts()) continue;
    std::vector<QualityFlag> own = flags_of_answer(rows[i], flags.rules);
    if (!own.empty()) flags.answers.emplace(i, std::move(own));
  }
  if (questionnaire.answer.words) return flags;
  for (const auto& [participant, raw] : raw_answers_on_scales(rows)) {
    std::vector<QualityFlag> own = flags_of_participant(raw, flags.rules);
    if (!own.empty()) flags.participants.emplace(participant, std::move(own));
  }
  return flags;
}

void add_failed_attention(const std::vector<Attention>& attention, const AttentionRule& rule,
                          QualityFlags& flags) {
  for (const Attention& own : attention) {
    if (!own.is_excluded) continue;
    std::vector<QualityFlag>& list = flags.participants[own.participant];
    const std::string reason = fmt::format("failed attention checks {} > {}",
                                           own.checks - own.passed, rule.max_failed_checks);
    list.insert(list.begin(), QualityFlag{QualityRule::max_failed_checks, reason});
  }
}

}  // namespace mien::pipeline

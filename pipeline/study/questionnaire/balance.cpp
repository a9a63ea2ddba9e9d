#include "pipeline/study/questionnaire/balance.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "pipeline/manifest/adaptive_text.h"
#include "pipeline/manifest/questionnaire_content.h"
#include "pipeline/study/questionnaire/orders.h"
#include "pipeline/study/questionnaire/trial_subjects.h"
#include "pipeline/study/trials/trial_kind.h"

namespace mien::pipeline {

namespace {

std::string subject_of(std::vector<std::string> names) {
  std::ranges::sort(names);
  return fmt::format("{}", fmt::join(names, "/"));
}

bool is_same_pair(const std::vector<std::string>& stimuli) {
  return stimuli.size() == 2 && stimuli[0] == stimuli[1];
}

/// Whether a trial is not of the scale that the session begins with: continuous trials have the
/// same stimuli for each scale.
bool is_of_later_scale(const SessionPlan& plan, const Trial& trial) {
  const auto first = std::ranges::find_if(plan.trials, &Trial::is_analysed);
  return trial.kind->form != nullptr && trial.kind->form->is_continuous &&
         trial.items.front().item != first->items.front().item;
}

void count_session(const SessionPlan& plan, Balance& balance) {
  std::vector<std::string> seen;
  std::string before;  // empty: none, or a stimulus with itself
  int position = 0;
  for (const Trial& trial : plan.trials) {
    if (!trial.is_analysed() || is_of_later_scale(plan, trial)) continue;
    ++position;
    if (is_same_pair(trial.stimuli)) {
      ++balance.same[trial.stimuli[0]];
      before.clear();
      continue;
    }
    const std::string subject = subject_of(trial.stimuli);
    ++balance.seen[subject];
    ++balance.position_counts[{subject, std::to_string(position)}];
    if (!before.empty()) ++balance.succession_counts[{before, subject}];
    for (const std::string& other : seen) ++balance.concurrence_counts[std::minmax(subject, other)];
    if (trial.kind->form->has_places())
      for (std::size_t i = 0; i < trial.stimuli.size(); ++i)
        ++balance.places[{trial.stimuli[i], std::to_string(i + 1)}];
    else if (trial.stimuli.size() > 1)
      balance.left[subject] += trial.stimuli[0] < trial.stimuli[1];
    seen.push_back(subject);
    before = subject;
  }
  balance.max_positions = std::max(balance.max_positions, position);
}

void count_sides(const SessionPlan& plan, Balance& balance) {
  const auto analysed_trial = std::ranges::find_if(plan.trials, &Trial::is_analysed);
  if (analysed_trial == plan.trials.end()) return;
  const TrialForm& form = *analysed_trial->kind->form;
  if (!form.is_on_scale || form.is_grid) return;
  std::map<std::string, bool> flipped;  // the trials of a session ask all scales, or one each
  for (const Trial& trial : plan.trials)
    if (trial.is_analysed())
      for (const TrialItem& item : trial.items)
        if (item.item != form.item) flipped[item.item] = item.flipped;
  for (const auto& [item, is_flipped] : flipped) balance.flipped[item] += is_flipped;
}

CountRange range_over(const auto& counts, std::size_t possible) {
  if (counts.empty()) return {};
  CountRange range{counts.begin()->second, counts.begin()->second};
  for (const auto& [key, count] : counts) {
    range.least = std::min(range.least, count);
    range.most = std::max(range.most, count);
  }
  if (counts.size() < possible) range.least = 0;
  return range;
}

/// "3 participants", "1 participant", "2 to 3 participants"
std::string range_text(CountRange range, const std::string& unit) {
  if (!range.is_uniform()) return fmt::format("{} to {} {}s", range.least, range.most, unit);
  return fmt::format("{} {}{}", range.least, unit, range.least == 1 ? "" : "s");
}

/// "0 times", "once", "twice", "3 times", "2 to 3 times"
std::string times_text(CountRange range) {
  const bool is_word = range.is_uniform() && (range.least == 1 || range.least == 2);
  return is_word ? (range.least == 1 ? "once" : "twice") : range_text(range, "time");
}

std::string counted_trials(const std::map<std::string, int>& counts) {
  int all = 0;
  for (const auto& [stimulus, count] : counts) all += count;
  return fmt::format("{} trials", all);
}

void add_latin_sentence(const Manifest& manifest, const Balance& balance, int participants,
                        std::vector<std::string>& sentences) {
  if (questionnaire_of(manifest).order.kind != TrialOrder::Kind::latin) return;
  const auto count = static_cast<std::size_t>(balance.max_positions);
  if (count < balance.subjects.size())
    return sentences.push_back(
        "Latin square within each participant's stimuli: positions and order effects are fully "
        "balanced only when all participants see the same stimuli, which is not the case here.");
  const std::size_t rows = williams_rows(count);
  if (static_cast<std::size_t>(participants) % rows == 0)
    return sentences.push_back(
        "The Latin square is balanced: every stimulus appears equally often in every position and "
        "after every other stimulus.");
  sentences.push_back(
      fmt::format("The Latin square is not balanced with {} participants: balanced positions "
                  "require a multiple of {}{}.",
                  participants, count,
                  rows == count ? ", and so do balanced sequences"
                                : fmt::format(", balanced sequences a multiple of {}", rows)));
}

struct BalanceCount {
  const char* count;
  std::string one;
  std::string other;
  int times;
};

constexpr auto balance_columns = table_of<BalanceCount>(
    "balance.csv", "count",
    {{"count", "",
      "seen, place, follows, together, flipped (high end on the left), left (the first of a pair "
      "on "
      "the left, or shown first), same (the same stimulus shown twice) or in_set (place in a set)",
      [](auto& r) { return r.count; }},
     {"one", "", "what is counted: a stimulus, pair or scale", [](auto& r) { return r.one; }},
     {"other", "",
      "the stimulus that follows or occurs in the same session, or the position in the order",
      [](auto& r) { return r.other; }},
     {"times", "", "number of times", [](auto& r) { return r.times; }}});

struct PlannedTrial {
  const SessionPlan& plan;
  const Trial& trial;

  /// Joined by semicolons.
  std::string items(bool flipped_alone) const {
    std::string text;
    for (const TrialItem& item : trial.items)
      if (item.flipped || !flipped_alone) text += (text.empty() ? "" : ";") + item.item;
    return text;
  }
};

constexpr auto plans_columns = table_of<PlannedTrial>(
    "plans.csv", "trial of a participant",
    {{"participant", "", "participant id: position in the design, not a name",
      [](auto& r) { return r.plan.participant; }},
     {"trial", "", "number of the trial, from 1", [](auto& r) { return r.trial.number; }},
     {"block", "", "practice, main, or a level of the blocking factor",
      [](auto& r) { return r.trial.block; }},
     {"kind", "", "kind of trial", [](auto& r) { return r.trial.kind_name(); }},
     {"stimulus", "", "stimulus shown; of a pair, the one on the left, or shown first",
      [](auto& r) { return r.trial.stimuli.empty() ? "" : r.trial.stimuli[0]; }},
     {"against", "",
      "the other stimulus of a pair, the others of a set, separated by spaces, or the reference",
      [](auto& r) { return r.trial.against(); }},
     {"items", "", "items asked, in order, separated by semicolons",
      [](auto& r) { return r.items(false); }},
     {"flipped", "", "those of the items that have the high end on the left",
      [](auto& r) { return r.items(true); }},
     {"is_practice", "0/1", "1: practice trial, not analysed",
      [](auto& r) { return r.trial.practice; }},
     {"is_warmup", "0/1", "1: warm-up trial of the main part, not analysed",
      [](auto& r) { return r.trial.warm_up; }},
     {"is_check", "0/1", "1: an attention check (see `expected`) or a repeated stimulus",
      [](auto& r) { return r.trial.is_check; }},
     {"expected", "", "raw answer that passes the attention check; otherwise empty",
      [](auto& r) { return r.trial.expected; }},
     {"seed", "", "seed of the participant's order", [](auto& r) { return r.plan.seed; }},
     {"track", "",
      "track of an adaptive trial, whose level and stimulus depend on the answers; otherwise empty",
      [](auto& r) {
        return r.trial.is_adaptive() ? std::optional(r.trial.adaptive.track) : std::nullopt;
      }}});

}  // namespace

const TableForm balance_form = balance_columns.form();
const TableForm plans_form = plans_columns.form();

Balance balance_of(const Manifest& manifest, const std::vector<SessionPlan>& plans) {
  Balance balance;
  // What adaptive trials show depends on the answers.
  if (!questionnaire_of(manifest).adaptive.empty()) return balance;
  for (const std::vector<std::string>& stimuli : trial_subjects(manifest).stimuli) {
    if (is_same_pair(stimuli))
      balance.same.emplace(stimuli[0], 0);
    else
      balance.seen.emplace(subject_of(stimuli), 0);
  }
  for (const SessionPlan& plan : plans) {
    count_session(plan, balance);
    count_sides(plan, balance);
  }
  for (const auto& [subject, count] : balance.seen) balance.subjects.push_back(subject);
  return balance;
}

CountRange participant_range(const Balance& balance) {
  return range_over(balance.seen, balance.seen.size());
}

CountRange position_range(const Balance& balance) {
  return range_over(balance.position_counts,
                    balance.subjects.size() * static_cast<std::size_t>(balance.max_positions));
}

CountRange succession_range(const Balance& balance) {
  const std::size_t count = balance.subjects.size();
  return range_over(balance.succession_counts, count * (count - 1));
}

CountRange concurrence_range(const Balance& balance) {
  const std::size_t count = balance.subjects.size();
  return range_over(balance.concurrence_counts, count * (count - 1) / 2);
}

CountRange flipped_range(const Balance& balance) {
  return range_over(balance.flipped, balance.flipped.size());
}

CountRange left_range(const Balance& balance) {
  return range_over(balance.left, balance.left.size());
}

CountRange place_range(const Balance& balance) {
  std::set<std::string> stimuli, places;
  for (const auto& [key, count] : balance.places) {
    stimuli.insert(key.first);
    places.insert(key.second);
  }
  return range_over(balance.places, stimuli.size() * places.size());
}

CountRange same_range(const Balance& balance) {
  return range_over(balance.same, balance.same.size());
}

std::vector<std::string> balance_sentences(const Manifest& manifest, const Balance& balance,
                                           int participants) {
  if (!questionnaire_of(manifest).adaptive.empty()) return adaptive_sentences(manifest);
  const TrialForm& form = *questionnaire_of(manifest).trials;
  const bool is_in_turn =
      pair_presentation(questionnaire_of(manifest)) == PairPresentation::in_turn;
  std::vector<std::string> sentences = {
      fmt::format("Each {} is shown to {} of {}.", form.judged,
                  range_text(participant_range(balance), "participant"), participants),
      fmt::format("Each {} appears {} in each position.", form.judged,
                  times_text(position_range(balance))),
      fmt::format("Each {} directly follows every other one {}.", form.judged,
                  times_text(succession_range(balance))),
      fmt::format("Any two {} are both shown in {}.",
                  form.has_places()  ? "sets"
                  : form.stimuli > 1 ? "pairs"
                                     : "stimuli",
                  range_text(concurrence_range(balance), "session"))};
  if (!balance.flipped.empty())
    sentences.push_back(fmt::format("The high end of each scale is on the left for {}.",
                                    range_text(flipped_range(balance), "participant")));
  if (form.has_places())
    sentences.push_back(fmt::format("Each stimulus is shown {} in each place of a set.",
                                    times_text(place_range(balance))));
  else if (form.stimuli > 1)
    sentences.push_back(fmt::format("The first stimulus of each pair is {} {}.",
                                    is_in_turn ? "shown first" : "on the left",
                                    times_text(left_range(balance))));
  if (!balance.same.empty())
    sentences.push_back(fmt::format(
        "The pairs above have two different stimuli; the same stimulus is shown twice in {}, each "
        "stimulus in {}.",
        counted_trials(balance.same), range_text(same_range(balance), "trial")));
  if (scales_in_turn(manifest) > 1)
    sentences.emplace_back(
        "The scales are rated one after the other, with all stimuli each; the numbers above are of "
        "the scale that a session begins with.");
  add_latin_sentence(manifest, balance, participants, sentences);
  return sentences;
}

std::string balance_csv(const Balance& balance) {
  std::vector<BalanceCount> rows;
  const auto add = [&](const char* name, const auto& counts) {
    for (const auto& [subject, times] : counts) rows.push_back({name, subject, "", times});
  };
  const auto add_pairs = [&](const char* name, const Balance::PairCounts& counts) {
    for (const auto& [pair, times] : counts) rows.push_back({name, pair.first, pair.second, times});
  };
  add("seen", balance.seen);
  add_pairs("place", balance.position_counts);
  add_pairs("follows", balance.succession_counts);
  add_pairs("together", balance.concurrence_counts);
  add("flipped", balance.flipped);
  add("left", balance.left);
  add("same", balance.same);
  add_pairs("in_set", balance.places);
  return balance_columns.of(rows).csv;
}

std::string plans_csv(const std::vector<SessionPlan>& plans) {
  std::vector<PlannedTrial> rows;
  for (const SessionPlan& plan : plans)
    for (const Trial& trial : plan.trials) rows.push_back({plan, trial});
  return plans_columns.of(rows).csv;
}

}  // namespace mien::pipeline

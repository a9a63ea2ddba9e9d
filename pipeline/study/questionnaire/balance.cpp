#include "pipeline/study/questionnaire/balance.h"

#include <algorithm>

#include <fmt/format.h>

#include "pipeline/base/documents/csv.h"
#include "pipeline/manifest/asked.h"
#include "pipeline/study/questionnaire/latin_square.h"
#include "pipeline/study/questionnaire/trial_subjects.h"
#include "pipeline/study/trials/trial_kind.h"

namespace mien::pipeline {

namespace {

std::string subject_of(std::vector<std::string> names) {
  std::ranges::sort(names);
  return fmt::format("{}", fmt::join(names, "/"));
}

void count_session(const SessionPlan& plan, Balance& balance) {
  std::vector<std::string> seen;
  for (const Trial& trial : plan.trials) {
    if (!trial.is_analysed()) continue;
    const std::string subject = subject_of(trial.stimuli);
    ++balance.seen[subject];
    ++balance.at_place[{subject, std::to_string(seen.size() + 1)}];
    if (!seen.empty()) ++balance.follows[{seen.back(), subject}];
    for (const std::string& other : seen) ++balance.together[std::minmax(subject, other)];
    if (trial.stimuli.size() > 1) balance.left[subject] += trial.stimuli[0] < trial.stimuli[1];
    seen.push_back(subject);
  }
  balance.most_places = std::max(balance.most_places, static_cast<int>(seen.size()));
}

void count_sides(const SessionPlan& plan, Balance& balance) {
  const auto asked = std::ranges::find_if(plan.trials, &Trial::is_analysed);
  if (asked == plan.trials.end() || !asked->kind->form->is_on_scale) return;
  for (const AskedItem& item : asked->items) {
    if (item.item != asked->kind->form->item) balance.flipped[item.item] += item.flipped;
  }
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

std::string shown(CountRange range, const char* unit) {
  return range.is_even() ? fmt::format("{} {}", range.least, unit)
                         : fmt::format("{} to {} {}", range.least, range.most, unit);
}

void add_latin_sentence(const Manifest& manifest, const Balance& balance, int participants,
                        std::vector<std::string>& sentences) {
  if (questionnaire_of(manifest).order.kind != TrialOrder::Kind::latin) return;
  const auto count = static_cast<std::size_t>(balance.most_places);
  if (count < balance.subjects.size()) {
    return sentences.push_back(
        "Latin square within each participant's stimuli: positions and order effects are fully "
        "balanced only when all participants see the same stimuli, which is not the case here.");
  }
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

}  // namespace

Balance balance_of(const Manifest& manifest, const std::vector<SessionPlan>& plans) {
  Balance balance;
  for (const std::vector<std::string>& stimuli : trial_subjects(manifest).stimuli)
    balance.seen.emplace(subject_of(stimuli), 0);
  for (const SessionPlan& plan : plans) {
    count_session(plan, balance);
    count_sides(plan, balance);
  }
  for (const auto& [subject, count] : balance.seen) balance.subjects.push_back(subject);
  return balance;
}

CountRange seen_range(const Balance& balance) {
  return range_over(balance.seen, balance.seen.size());
}

CountRange place_range(const Balance& balance) {
  return range_over(balance.at_place,
                    balance.subjects.size() * static_cast<std::size_t>(balance.most_places));
}

CountRange follows_range(const Balance& balance) {
  const std::size_t count = balance.subjects.size();
  return range_over(balance.follows, count * (count - 1));
}

CountRange together_range(const Balance& balance) {
  const std::size_t count = balance.subjects.size();
  return range_over(balance.together, count * (count - 1) / 2);
}

CountRange flipped_range(const Balance& balance) {
  return range_over(balance.flipped, balance.flipped.size());
}

CountRange left_range(const Balance& balance) {
  return range_over(balance.left, balance.left.size());
}

std::vector<std::string> balance_sentences(const Manifest& manifest, const Balance& balance,
                                           int participants) {
  const TrialForm& form = *questionnaire_of(manifest).trials;
  std::vector<std::string> sentences = {
      fmt::format("Each {} is shown to {} of {}.", form.subject,
                  shown(seen_range(balance), "participants"), participants),
      fmt::format("Each {} appears {} in each position.", form.subject,
                  shown(place_range(balance), "times")),
      fmt::format("Each {} directly follows every other one {}.", form.subject,
                  shown(follows_range(balance), "times")),
      fmt::format("Every pair of {} co-occurs in {}.", form.stimuli > 1 ? "pairs" : "stimuli",
                  shown(together_range(balance), "sessions"))};
  if (!balance.flipped.empty()) {
    sentences.push_back(fmt::format("The high end of each scale is on the left for {}.",
                                    shown(flipped_range(balance), "participants")));
  }
  if (form.stimuli > 1) {
    sentences.push_back(fmt::format("The first stimulus of each pair is on the left {}.",
                                    shown(left_range(balance), "times")));
  }
  add_latin_sentence(manifest, balance, participants, sentences);
  return sentences;
}

std::string balance_csv(const Balance& balance) {
  CsvWriter csv({"count", "one", "other", "times"});
  for (const auto& [subject, count] : balance.seen)
    csv.row({"seen", subject, "", std::to_string(count)});
  const auto pairs = [&](const char* name, const Balance::PairCounts& counts) {
    for (const auto& [key, count] : counts)
      csv.row({name, key.first, key.second, std::to_string(count)});
  };
  pairs("place", balance.at_place);
  pairs("follows", balance.follows);
  pairs("together", balance.together);
  for (const auto& [item, count] : balance.flipped)
    csv.row({"flipped", item, "", std::to_string(count)});
  for (const auto& [pair, count] : balance.left) csv.row({"left", pair, "", std::to_string(count)});
  return csv.text();
}

std::string plans_csv(const std::vector<SessionPlan>& plans) {
  CsvWriter csv({"participant", "trial", "block", "kind", "stimulus", "against", "items", "flipped",
                 "is_practice", "is_warmup", "is_catch", "expected", "seed"});
  for (const SessionPlan& plan : plans) {
    for (const Trial& trial : plan.trials) {
      std::vector<std::string> items, flipped;
      for (const AskedItem& item : trial.items) {
        items.push_back(item.item);
        if (item.flipped) flipped.push_back(item.item);
      }
      const std::string first = trial.stimuli.empty() ? "" : trial.stimuli[0];
      const auto truth = [](bool value) { return std::string(value ? "1" : "0"); };
      csv.row({plan.participant, std::to_string(trial.number), trial.block,
               std::string(trial.kind_name()), first, trial.against(),
               fmt::format("{}", fmt::join(items, ";")), fmt::format("{}", fmt::join(flipped, ";")),
               truth(trial.practice), truth(trial.warm_up), truth(trial.is_catch), trial.expected,
               std::to_string(plan.seed)});
    }
  }
  return csv.text();
}

}  // namespace mien::pipeline

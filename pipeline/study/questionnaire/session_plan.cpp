#include "pipeline/study/questionnaire/session_plan.h"

#include <algorithm>
#include <cassert>

#include <fmt/format.h>

#include "pipeline/manifest/questionnaire_content.h"
#include "pipeline/manifest/questionnaire_grid.h"
#include "pipeline/manifest/ratings/answers/best_worst_item.h"
#include "pipeline/manifest/ratings/answers/grid_item.h"
#include "pipeline/study/questionnaire/adaptive_part.h"
#include "pipeline/study/questionnaire/main_part.h"
#include "pipeline/study/questionnaire/orders.h"
#include "pipeline/study/questionnaire/session_duration.h"
#include "pipeline/study/questionnaire/trial_subjects.h"
#include "pipeline/study/trials/trial_kind.h"

namespace mien::pipeline {

namespace {

/// Plans the sessions one after the other.
class Planner {
 public:
  explicit Planner(const Manifest& manifest)
      : manifest_(manifest),
        questionnaire_(questionnaire_of(manifest)),
        form_(*questionnaire_.trials),
        kind_(trial_kind_of(form_)),
        subjects_(trial_subjects(manifest)),
        grid_sets_(grid_sets(manifest)),
        response_scales_(response_scales_by_item(manifest)),
        shown_(subjects_.size()) {
    for (const Scale& scale : questionnaire_scales(manifest).scales) scales_.push_back(scale.id);
  }

  const TrialSubjects& subjects() const { return subjects_; }

  SessionPlan next(const std::vector<std::size_t>& share) {
    plan_ = {};
    plan_.index = index_;
    plan_.participant = participant_name(index_);
    // So that a double of JavaScript represents it exactly.
    plan_.seed = hashed_seed(manifest_.seed, plan_.participant) >> 11U;
    lay_choices();
    lay_items();
    if (form_.is_continuous) {
      lay_scales_in_turn(share);
    } else if (!questionnaire_.adaptive.empty()) {
      lay_practice();
      lay_adaptive();
    } else {
      lay_practice();
      lay_main(main_part(manifest_, subjects_, share, index_));
    }
    for (std::size_t i = 0; i < plan_.trials.size(); ++i)
      plan_.trials[i].number = static_cast<int>(i) + 1;
    ++index_;
    return std::move(plan_);
  }

 private:
  bool are_sides_random() const { return questionnaire_.answer.side == PoleSide::random; }

  /// Alternates between successive participants.
  bool is_flipped(const std::string& what, int index) const {
    const bool first = random_choice(2, manifest_.seed, fmt::format("side/{}/{}", what, index / 2));
    return are_sides_random() && first != (index % 2 == 1);
  }

  void lay_choices() {
    if (!form_.offers_choices) return;
    const auto choices = questionnaire_choices(manifest_);
    for (const std::size_t i : random_order(choices.size(), plan_.seed, "choices"))
      plan_.choices.push_back(choices[are_sides_random() ? i : plan_.choices.size()].first);
  }

  void lay_items() {
    items_.clear();
    if (!form_.item.empty()) items_.push_back({.item = std::string(form_.item)});
    const bool has_poles = form_.is_on_scale && !form_.is_grid && !questionnaire_.answer.words;
    for (const std::string& scale : scales_) {
      if (&form_ == &best_worst_form) {
        items_.push_back({.item = to_item(BestWorstItem{scale, true})});
        items_.push_back({.item = to_item(BestWorstItem{scale, false})});
        continue;
      }
      items_.push_back({.item = scale, .flipped = has_poles && is_flipped(scale, index_)});
    }
  }

  Trial trial_of(std::vector<std::string> stimuli, std::string block) const {
    return {.block = std::move(block),
            .kind = &kind_,
            .stimuli = std::move(stimuli),
            .reference = questionnaire_.reference,
            .items = items_};
  }

  /// A trial of a grid, with its stimuli in random places.
  Trial grid_trial(const GridSet& set, std::string block, const std::string& name) const {
    std::vector<std::string> placed;
    for (const std::size_t i : random_order(set.stimuli.size(), plan_.seed, "grid/" + name))
      placed.push_back(set.stimuli[i]);
    Trial trial = trial_of(std::move(placed), std::move(block));
    trial.reference = set.reference;
    trial.items.clear();
    for (const TrialItem& item : items_)
      for (std::size_t place = 1; place <= set.stimuli.size(); ++place)
        trial.items.push_back({.item = to_item(GridItem{item.item, place})});
    return trial;
  }

  void lay_practice_grids() {
    for (const GridSet& set : practice_grid_sets(manifest_)) {
      plan_.trials.push_back(
          grid_trial(set, "practice", fmt::format("practice/{}", plan_.trials.size())));
      plan_.trials.back().practice = true;
    }
  }

  void lay_practice() {
    if (form_.is_grid) return lay_practice_grids();
    const std::size_t each = stimuli_per_trial(questionnaire_);
    for (std::size_t i = 0; i + each <= questionnaire_.practice.size(); i += each) {
      const auto first = questionnaire_.practice.begin() + static_cast<std::ptrdiff_t>(i);
      Trial trial = trial_of({first, first + static_cast<std::ptrdiff_t>(each)}, "practice");
      trial.practice = true;
      plan_.trials.push_back(std::move(trial));
    }
  }

  /// One scale after the other, each with its practice. Over as many participants as there are
  /// scales, each scale is once in each place.
  void lay_scales_in_turn(const std::vector<std::size_t>& share) {
    const std::vector<TrialItem> all = items_;
    const std::size_t count = all.size();
    const bool is_fixed = questionnaire_.order.kind == TrialOrder::Kind::fixed;
    const auto place = static_cast<std::size_t>(index_);
    const std::vector<std::size_t> order =
        random_order(count, manifest_.seed, fmt::format("scales/{}", place / count));
    for (std::size_t round = 0; round < count; ++round) {
      items_ = {all[is_fixed ? round : order[(round + place) % count]]};
      lay_practice();
      round_ = static_cast<int>(round);
      lay_main(main_part(manifest_, subjects_, share, index_, round_));
    }
    round_ = 0;
  }

  void lay_main(const std::vector<MainTrial>& main) {
    const std::vector<std::size_t> checks = attention_places(main.size());
    std::vector<std::size_t> turned(subjects_.size());
    for (const MainTrial& one : main) turned[one.subject] = shown_[one.subject];
    for (std::size_t place = 0; place < main.size(); ++place) {
      const MainTrial& one = main[place];
      const std::string& block = subjects_.blocks[one.subject];
      Trial trial = form_.is_grid
                        ? grid_trial(grid_sets_[one.subject], block, std::to_string(place))
                        : trial_of(subjects_.stimuli[one.subject], block);
      trial.warm_up = one.warm_up;
      trial.is_check = one.repeated;
      if (form_.stimuli > 1 && !form_.is_grid) turn(trial, turned[one.subject]);
      if (trial.is_analysed()) ++shown_[one.subject];
      plan_.trials.push_back(std::move(trial));
      if (std::ranges::find(checks, place) != checks.end()) lay_attention(place);
    }
  }

  void lay_adaptive() {
    std::vector<Trial> trials = adaptive_part(manifest_, plan_.seed);
    const std::vector<std::size_t> checks = attention_places(trials.size());
    for (std::size_t place = 0; place < trials.size(); ++place) {
      trials[place].items = items_;
      plan_.trials.push_back(std::move(trials[place]));
      if (std::ranges::find(checks, place) != checks.end()) lay_attention(place);
    }
  }

  /// Which of a pair is at the left: alternates between showings, starting at random. A set is
  /// rotated, so that in as many showings as it has stimuli each is once in each place, in a random
  /// cyclic order.
  void turn(Trial& trial, std::size_t times) const {
    if (form_.is_set) {
      if (!are_sides_random()) return;
      const std::size_t count = trial.stimuli.size();
      const std::vector<std::string> stimuli = trial.stimuli;
      const std::string set = fmt::format("{}", fmt::join(stimuli, "/"));
      const std::vector<std::size_t> order =
          random_order(count, manifest_.seed, fmt::format("set/{}/{}", set, times / count));
      for (std::size_t i = 0; i < count; ++i)
        trial.stimuli[i] = stimuli[order[(i + times) % count]];
      return;
    }
    const std::string name = trial.stimuli[0] + "/" + trial.stimuli[1];
    if (is_flipped(name, static_cast<int>(times))) std::swap(trial.stimuli[0], trial.stimuli[1]);
  }

  /// The trials of the main part that attention checks follow.
  std::vector<std::size_t> attention_places(std::size_t trials) const {
    return places_of_checks(trials, static_cast<std::size_t>(questionnaire_.attention_every),
                            plan_.seed, in_round("attention"));
  }

  /// A name of random numbers that differ between the scales of continuous trials.
  std::string in_round(const std::string& name) const {
    return round_ == 0 ? name : fmt::format("{}/{}", name, round_);
  }

  void lay_attention(std::size_t place) {
    Trial check;
    check.block = plan_.trials.back().block;
    check.kind = &kind_;
    check.is_check = true;
    check.items = {items_[random_choice(items_.size(), plan_.seed, in_round("checked"), place)]};
    check.expected = expected_of(check, place);
    plan_.trials.push_back(std::move(check));
  }

  std::string expected_of(const Trial& check, std::size_t place) const {
    const TrialItem& item = check.items.front();
    const std::vector<std::string> answers = kind_.attention_answers(
        {check, item, find_scale(response_scales_, item.item), plan_.choices});
    return answers[random_choice(answers.size(), plan_.seed, in_round("expected"), place)];
  }

  const Manifest& manifest_;
  const Questionnaire& questionnaire_;
  const TrialForm& form_;
  const TrialKind& kind_;
  TrialSubjects subjects_;
  std::vector<GridSet> grid_sets_;  ///< of grid trials, in the order of the subjects
  std::vector<std::string> scales_;
  ResponseScales response_scales_;
  std::vector<std::size_t> shown_;  ///< how often each subject is analysed so far
  std::vector<TrialItem> items_;    ///< of the session being planned
  SessionPlan plan_;
  int index_ = 0;
  int round_ = 0;  ///< of the scales of continuous trials
};

}  // namespace

std::string participant_name(int index) { return fmt::format("p{:03}", index + 1); }

std::vector<SessionPlan> plan_sessions(const Manifest& manifest, const VideoSeconds& seconds,
                                       int count) {
  if (count == 0) count = questionnaire_of(manifest).participants;
  Planner planner(manifest);
  std::vector<SessionPlan> plans;
  const auto sessions = static_cast<std::size_t>(count);
  // In adaptive trials everybody may see all stimuli.
  const std::vector<std::vector<std::size_t>> shares =
      questionnaire_of(manifest).adaptive.empty()
          ? participant_subjects(manifest, planner.subjects(), sessions)
          : std::vector<std::vector<std::size_t>>(sessions);
  for (const auto& share : shares) {
    plans.push_back(planner.next(share));
    plans.back().expected_seconds = session_seconds(manifest, plans.back(), seconds);
  }
  return plans;
}

std::size_t next_plan(const std::vector<SessionPlan>& plans, const std::vector<int>& assigned,
                      const std::vector<int>& finished) {
  assert(!plans.empty() && assigned.size() == plans.size() && finished.size() == plans.size());
  std::map<std::string, int> seen;
  for (std::size_t i = 0; i < plans.size(); ++i) {
    for (const Trial& trial : plans[i].trials) {
      if (!trial.is_analysed()) continue;
      for (const std::string& stimulus : trial.stimuli) seen[stimulus] += finished[i];
    }
  }
  // Mean over a plan's stimuli of their number of finished sessions.
  const auto fill = [&](std::size_t i) {
    double sum = 0.0, count = 0.0;
    for (const Trial& trial : plans[i].trials) {
      if (!trial.is_analysed()) continue;
      for (const std::string& stimulus : trial.stimuli) sum += seen[stimulus];
      count += static_cast<double>(trial.stimuli.size());
    }
    return count == 0.0 ? 0.0 : sum / count;
  };
  std::size_t best = 0;
  for (std::size_t i = 1; i < plans.size(); ++i) {
    const bool is_rarer = assigned[i] < assigned[best];
    const bool is_emptier = assigned[i] == assigned[best] && fill(i) < fill(best) - 1e-9;
    if (is_rarer || is_emptier) best = i;
  }
  return best;
}

}  // namespace mien::pipeline

#include "pipeline/study/results/grid_screening.h"

#include <map>
#include <set>

#include <fmt/format.h>

#include "motion/text/as_number.h"
#include "pipeline/manifest/ratings/answers/trial_form.h"

namespace mien::pipeline {

namespace {

/// Share of the participants above which an anchor that they rate too high is not counted.
constexpr double unimpaired_share = 0.25;

/// A participant's ratings of hidden references, or of anchors.
struct Screened {
  int trials = 0;
  int missed = 0;  ///< of these, on the wrong side of the bound

  void add(bool is_missed) {
    ++trials;
    missed += is_missed ? 1 : 0;
  }
};

using ScreenedPeople = std::map<std::string, Screened>;

/// Adds a flag for each participant with too many such trials.
void flag_missed(const ScreenedPeople& people, QualityRule rule, const char* what,
                 QualityFlags& flags) {
  for (const auto& [participant, own] : people) {
    const double share = 1.0 * own.missed / own.trials;
    if (share <= post_screening_share) continue;
    flags.participants[participant].push_back(
        {rule, fmt::format("{} {:g} in {} of {} trials ({:.0f} % > {:.0f} %)", what,
                           post_screening_rating, own.missed, own.trials, 100.0 * share,
                           100.0 * post_screening_share)});
  }
}

/// The analysed ratings of grid trials with the given stimuli, as participant, stimulus and value.
void for_each_rating(const std::vector<AnswerRow>& rows, const std::set<std::string>& stimuli,
                     auto&& take) {
  for (const AnswerRow& row : rows) {
    const auto value = motion::as_finite_number(row.value);
    if (row.kind == grid_form.name && row.counts() && value && stimuli.contains(row.stimulus))
      take(row, *value);
  }
}

}  // namespace

void add_post_screening(const std::vector<GridSet>& sets, const std::vector<AnswerRow>& rows,
                        QualityFlags& flags) {
  std::set<std::string> references, anchors;
  for (const GridSet& set : sets) {
    if (!set.reference.empty()) references.insert(set.reference);
    if (!set.anchor.empty()) anchors.insert(set.anchor);
  }
  ScreenedPeople by_reference, by_anchor;
  for_each_rating(rows, references, [&](const AnswerRow& row, double value) {
    by_reference[row.participant].add(value < post_screening_rating);
  });
  std::map<std::string, Screened> of_anchor;
  for_each_rating(rows, anchors, [&](const AnswerRow& row, double value) {
    of_anchor[row.stimulus].add(value > post_screening_rating);
  });
  for_each_rating(rows, anchors, [&](const AnswerRow& row, double value) {
    const Screened& all = of_anchor[row.stimulus];
    if (1.0 * all.missed / all.trials <= unimpaired_share)
      by_anchor[row.participant].add(value > post_screening_rating);
  });
  flag_missed(by_reference, QualityRule::hidden_reference, "hidden reference rated below", flags);
  flag_missed(by_anchor, QualityRule::anchor, "anchor rated above", flags);
}

}  // namespace mien::pipeline

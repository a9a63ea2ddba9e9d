#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "pipeline/base/statistics/exact_number.h"
#include "pipeline/study/results/comparisons.h"

namespace mien::pipeline {

namespace {

/// A cell within which makings are compared: setting, emotion, and the emotion's scale.
struct MatchedCell {
  std::string setting;
  std::string emotion;
  std::size_t scale = 0;

  auto operator<=>(const MatchedCell&) const = default;
};

/// The stimuli of both makings in a cell, and the intended end of the scale.
struct CellSides {
  int end = 0;
  std::set<std::size_t> one;
  std::set<std::size_t> against;
};
using Cells = std::map<MatchedCell, CellSides>;

struct SideSums {
  ExactSum one;
  ExactSum against;
};

/// By person, then by cell.
std::map<std::size_t, std::map<MatchedCell, SideSums>> sums_in(const AnswerSet& answer_set,
                                                               const Cells& cells) {
  std::map<std::pair<std::size_t, std::size_t>, std::vector<Cells::const_iterator>> cells_of;
  for (auto cell = cells.begin(); cell != cells.end(); ++cell) {
    std::set<std::size_t> stimuli = cell->second.one;
    stimuli.insert(cell->second.against.begin(), cell->second.against.end());
    for (const std::size_t stimulus : stimuli)
      cells_of[{stimulus, cell->first.scale}].push_back(cell);
  }
  std::map<std::size_t, std::map<MatchedCell, SideSums>> sums;
  for (const AnalysedRating& rating : answer_set.ratings) {
    const auto found = cells_of.find({rating.stimulus, rating.scale});
    if (found == cells_of.end()) continue;
    const Scale& scale = answer_set.scales[rating.scale];
    const ExactNumber middle = (ExactNumber::of(scale.least) + ExactNumber::of(scale.most)) / 2;
    const ExactNumber from_middle = ExactNumber::of(rating.value) - middle;
    for (const auto& cell : found->second) {
      SideSums& own = sums[rating.person][cell->first];
      const ExactNumber towards = from_middle * cell->second.end;
      if (cell->second.one.contains(rating.stimulus)) own.one.add(towards);
      if (cell->second.against.contains(rating.stimulus)) own.against.add(towards);
    }
  }
  return sums;
}

OverallComparison overall_of(const AnswerSet& answer_set, ComparisonFamily family,
                             const std::string& emotion, const Cells& cells) {
  OverallComparison result;
  result.family = family;
  result.emotion = emotion;
  std::vector<double> differences, means, means_against;
  for (const auto& [person, own] : sums_in(answer_set, cells)) {
    ExactSum one, against;
    bool saw_one = false;
    bool saw_against = false;
    for (const auto& [cell, sums] : own) {
      saw_one = saw_one || sums.one.count > 0;
      saw_against = saw_against || sums.against.count > 0;
      if (sums.one.count == 0 || sums.against.count == 0) continue;
      one.add(sums.one.mean());
      against.add(sums.against.mean());
    }
    if (one.count == 0) {
      result.unmatched += saw_one && saw_against ? 1 : 0;
      continue;
    }
    result.matched += one.count;
    means.push_back(one.mean().value());
    means_against.push_back(against.mean().value());
    differences.push_back((one.mean() - against.mean()).value());
  }
  result.mean = exact_mean(means);
  result.mean_against = exact_mean(means_against);
  result.within = within_participants(differences);
  return result;
}

void correct_overall(std::vector<OverallComparison>& all, ComparisonFamily family,
                     TestCorrection correction) {
  std::vector<double> paired;
  std::vector<double> ranks;
  std::vector<OverallComparison*> members;
  for (OverallComparison& c : all) {
    if (c.family != family) continue;
    c.paired_adjusted = c.within.t.p;
    c.wilcoxon_adjusted = c.within.wilcoxon.p;
    if (c.emotion.empty()) continue;
    members.push_back(&c);
    paired.push_back(c.within.t.p);
    ranks.push_back(c.within.wilcoxon.p);
  }
  const std::vector<double> paired_after = corrected(paired, correction);
  const std::vector<double> ranks_after = corrected(ranks, correction);
  for (std::size_t i = 0; i < members.size(); ++i) {
    members[i]->paired_adjusted = paired_after[i];
    members[i]->wilcoxon_adjusted = ranks_after[i];
  }
}

}  // namespace

std::vector<OverallComparison> compare_overall(const AnswerSet& answer_set) {
  // By family and emotion; that of all comes first, its name being empty.
  std::map<std::pair<ComparisonFamily, std::string>, Cells> cells;
  for (std::size_t one = 0; one < answer_set.stimuli.size(); ++one) {
    for (std::size_t other = 0; other < answer_set.stimuli.size(); ++other) {
      const auto family = family_of(answer_set.stimuli[one], answer_set.stimuli[other]);
      if (!family || one == other) continue;
      for (std::size_t scale = 0; scale < answer_set.scales.size(); ++scale) {
        const ReportedStimulus& stimulus = answer_set.stimuli[one];
        const int end = end_sign(answer_set.scales[scale], stimulus.emotion);
        if (end == 0) continue;
        for (const std::string& of : {std::string(), stimulus.emotion}) {
          CellSides& sides = cells[{*family, of}][{stimulus.setting, stimulus.emotion, scale}];
          sides.end = end;
          sides.one.insert(one);
          sides.against.insert(other);
        }
      }
    }
  }
  std::vector<OverallComparison> all;
  for (const auto& [of, own] : cells) {
    OverallComparison comparison = overall_of(answer_set, of.first, of.second, own);
    if (comparison.within.people >= 2) all.push_back(std::move(comparison));
  }
  for (const auto& [word, family] : family_words)
    correct_overall(all, family, answer_set.correction);
  return all;
}

}  // namespace mien::pipeline

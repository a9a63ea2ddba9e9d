#include <cstddef>
#include <map>
#include <set>
#include <utility>

#include "pipeline/results/comparisons.h"

namespace mien::pipeline {

namespace {

/// What is compared on one scale, and which of its ends is meant.
struct OrientedPart {
  std::size_t stimulus = 0;
  std::size_t scale = 0;
  int end = 0;

  auto operator<=>(const OrientedPart&) const = default;
};

/// Both sides of a comparison; what belongs to several pairs counts once.
struct OverallSides {
  std::set<OrientedPart> one;
  std::set<OrientedPart> against;
};

using MeansOfPeople = std::map<std::size_t, double>;

MeansOfPeople means_of(const Gathered& gathered, const std::set<OrientedPart>& parts) {
  std::map<std::pair<std::size_t, std::size_t>, std::vector<int>> ends;
  for (const OrientedPart& part : parts) ends[{part.stimulus, part.scale}].push_back(part.end);
  std::map<std::size_t, std::pair<double, int>> sums;
  for (const CountedRating& rating : gathered.ratings) {
    const auto found = ends.find({rating.stimulus, rating.scale});
    if (found == ends.end()) continue;
    const Scale& scale = gathered.scales[rating.scale];
    const double from_middle = rating.value - 0.5 * (scale.least + scale.most);
    for (const int end : found->second) {
      sums[rating.person].first += end * from_middle;
      ++sums[rating.person].second;
    }
  }
  MeansOfPeople means;
  for (const auto& [person, sum] : sums) means[person] = sum.first / sum.second;
  return means;
}

OverallComparison overall_of(const Gathered& gathered, ComparisonFamily family,
                             const std::string& emotion, const OverallSides& sides) {
  OverallComparison result;
  result.family = family;
  result.emotion = emotion;
  const MeansOfPeople one = means_of(gathered, sides.one);
  const MeansOfPeople against = means_of(gathered, sides.against);
  std::vector<double> differences;
  for (const auto& [person, mean] : one) {
    const auto found = against.find(person);
    if (found == against.end()) continue;
    differences.push_back(mean - found->second);
    result.mean += mean;
    result.mean_against += found->second;
  }
  result.mean /= static_cast<double>(differences.size());
  result.mean_against /= static_cast<double>(differences.size());
  result.within = within_persons(differences);
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

std::vector<OverallComparison> compare_overall(const Gathered& gathered) {
  // By family and emotion; that of all comes first, its name being empty.
  std::map<std::pair<ComparisonFamily, std::string>, OverallSides> sides;
  for (std::size_t one = 0; one < gathered.stimuli.size(); ++one) {
    for (std::size_t other = 0; other < gathered.stimuli.size(); ++other) {
      const auto family = family_of(gathered.stimuli[one], gathered.stimuli[other]);
      if (!family || one == other) continue;
      for (std::size_t scale = 0; scale < gathered.scales.size(); ++scale) {
        const std::string& emotion = gathered.stimuli[one].emotion;
        const int end = end_of(gathered.scales[scale], emotion);
        if (end == 0) continue;
        for (const std::string& of : {std::string(), emotion}) {
          sides[{*family, of}].one.insert({one, scale, end});
          sides[{*family, of}].against.insert({other, scale, end});
        }
      }
    }
  }
  std::vector<OverallComparison> all;
  for (const auto& [of, both] : sides) {
    OverallComparison comparison = overall_of(gathered, of.first, of.second, both);
    if (comparison.within.people >= 2) all.push_back(std::move(comparison));
  }
  for (const auto& [word, family] : family_words) correct_overall(all, family, gathered.correction);
  return all;
}

}  // namespace mien::pipeline

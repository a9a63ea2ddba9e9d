#include "pipeline/study/results/comparisons.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <string_view>
#include <utility>

#include "pipeline/base/statistics/exact_number.h"
#include "pipeline/base/statistics/p_correction.h"
#include "pipeline/study/results/summaries.h"

namespace mien::pipeline {

namespace {

/// By person.
using PersonSums = std::map<std::size_t, ExactSum>;

PersonSums sums_of(const std::vector<AnalysedRating>& ratings) {
  PersonSums sums;
  for (const AnalysedRating& rating : ratings)
    sums[rating.person].add(ExactNumber::of(rating.value));
  return sums;
}

std::vector<double> values_of(const std::vector<AnalysedRating>& ratings) {
  std::vector<double> values;
  for (const AnalysedRating& rating : ratings) values.push_back(rating.value);
  return values;
}

std::vector<double> differences_of(const PersonSums& one, const PersonSums& other) {
  std::vector<double> differences;
  for (const auto& [person, own] : one) {
    const auto found = other.find(person);
    if (found != other.end()) differences.push_back((own.mean() - found->second.mean()).value());
  }
  return differences;
}

/// Without variance, t and p are undefined.
TTest without_spread(TTest test) {
  test.standard_error = test.t = test.p = std::numeric_limits<double>::quiet_NaN();
  return test;
}

void set_tests(Comparison& result, const std::vector<double>& own,
               const std::vector<double>& against, const std::vector<double>& differences) {
  result.answers = static_cast<int>(own.size());
  result.answers_against = static_cast<int>(against.size());
  result.mean = exact_mean(own);
  result.mean_against = exact_mean(against);
  result.welch = welch_t_test(own, against);
  if (all_equal(own) && all_equal(against)) {
    result.welch = without_spread(result.welch);
    result.d = result.g = result.welch.t;
  } else {
    result.d = cohens_d(own, against);
    result.g = hedges_g(own, against);
  }
  result.within = within_participants(differences);
}

/// Makes the comparisons on one scale.
class ScaleComparisons {
 public:
  ScaleComparisons(const AnswerSet& answer_set, std::size_t scale)
      : answer_set_(answer_set), scale_(scale), ratings_(ratings_by_stimulus(answer_set, scale)) {}

  void add_best_seen(std::size_t stimulus, std::vector<Comparison>& all) const {
    std::vector<AnalysedRating> of_setting;
    std::vector<AnalysedRating> others;
    for (std::size_t i = 0; i < ratings_.size(); ++i) {
      if (answer_set_.stimuli[i].setting != answer_set_.stimuli[stimulus].setting) continue;
      of_setting.insert(of_setting.end(), ratings_[i].begin(), ratings_[i].end());
      if (i != stimulus) others.insert(others.end(), ratings_[i].begin(), ratings_[i].end());
    }
    if (others.empty()) return;
    add(begun(ComparisonFamily::best_seen, stimulus), of_setting, others, all);
  }

  void add_pair(ComparisonFamily family, std::size_t stimulus, std::size_t against,
                std::vector<Comparison>& all, const std::string& factor = "") const {
    Comparison comparison = begun(family, stimulus);
    comparison.against = against;
    comparison.factor = factor;
    add(comparison, ratings_[against], ratings_[against], all);
  }

  void add_best(std::size_t stimulus, std::vector<Comparison>& all) const {
    const ReportedStimulus& own = answer_set_.stimuli[stimulus];
    const int end = end_sign(answer_set_.scales[scale_], own.emotion);
    if (own.made != "modified" || end == 0) return;
    std::optional<std::size_t> best;
    double most = 0.0;
    for (std::size_t i = 0; i < ratings_.size(); ++i) {
      const ReportedStimulus& other = answer_set_.stimuli[i];
      if (other.made == "modified" || other.setting != own.setting || ratings_[i].size() < 2)
        continue;
      const double towards = end * exact_mean(values_of(ratings_[i]));
      if (best && towards <= most) continue;
      best = i;
      most = towards;
    }
    if (best) add_pair(ComparisonFamily::modified_best, stimulus, *best, all);
  }

 private:
  Comparison begun(ComparisonFamily family, std::size_t stimulus) const {
    Comparison comparison;
    comparison.family = family;
    comparison.stimulus = stimulus;
    comparison.scale = scale_;
    comparison.intended_end =
        end_sign(answer_set_.scales[scale_], answer_set_.stimuli[stimulus].emotion);
    return comparison;
  }

  void add(Comparison comparison, const std::vector<AnalysedRating>& against,
           const std::vector<AnalysedRating>& within, std::vector<Comparison>& all) const {
    const std::vector<AnalysedRating>& own = ratings_[comparison.stimulus];
    if (own.size() < 2 || against.size() < 2) return;
    const std::vector<double> differences = differences_of(sums_of(own), sums_of(within));
    set_tests(comparison, values_of(own), values_of(against), differences);
    all.push_back(comparison);
  }

  const AnswerSet& answer_set_;
  std::size_t scale_;
  std::vector<std::vector<AnalysedRating>> ratings_;
};

/// Whether a comparison tests a hypothesis: it is on the scale of the intended emotion.
bool is_hypothesis(const Comparison& comparison) {
  return comparison.family != ComparisonFamily::best_seen && comparison.intended_end != 0;
}

void correct_family(std::vector<Comparison>& all, ComparisonFamily family, bool of_hypothesis,
                    TestCorrection correction) {
  std::vector<Comparison*> members;
  for (Comparison& comparison : all)
    if (comparison.family == family && is_hypothesis(comparison) == of_hypothesis)
      members.push_back(&comparison);
  const auto correct = [&](auto get_p, auto set_p) {
    std::vector<double> p_values;
    for (const Comparison* member : members) p_values.push_back(get_p(*member));
    const std::vector<double> adjusted = corrected(p_values, correction);
    for (std::size_t i = 0; i < members.size(); ++i) set_p(*members[i], adjusted[i]);
  };
  correct([](const Comparison& c) { return c.welch.p; },
          [](Comparison& c, double p) { c.welch_adjusted = p; });
  correct([](const Comparison& c) { return c.within.t.p; },
          [](Comparison& c, double p) { c.paired_adjusted = p; });
  correct([](const Comparison& c) { return c.within.wilcoxon.p; },
          [](Comparison& c, double p) { c.wilcoxon_adjusted = p; });
}

}  // namespace

std::optional<std::string> differing_factor(const ReportedStimulus& one,
                                            const ReportedStimulus& other) {
  constexpr std::array<std::string_view, 2> of_files = {"example", "clip"};
  const auto levels = [&](const ReportedStimulus& of) {
    std::map<std::string, std::string> factors(of.factors.begin(), of.factors.end());
    for (const std::string_view name : of_files) factors.erase(std::string(name));
    return factors;
  };
  const std::map<std::string, std::string> first = levels(one);
  const std::map<std::string, std::string> second = levels(other);
  if (!std::ranges::equal(first, second, {}, &std::pair<const std::string, std::string>::first,
                          &std::pair<const std::string, std::string>::first))
    return std::nullopt;
  std::optional<std::string> differing;
  for (const auto& [factor, level] : first) {
    if (second.at(factor) == level) continue;
    if (differing || factor == "made" || factor == "emotion" || factor == "strength")
      return std::nullopt;
    differing = factor;
  }
  return differing;
}

std::optional<ComparisonFamily> family_of(const ReportedStimulus& one,
                                          const ReportedStimulus& other) {
  if (one.setting != other.setting || one.is_neutral()) return std::nullopt;
  if (other.is_neutral()) {
    if (one.made == "modified") return ComparisonFamily::modified_neutral;
    if (one.made == "acted") return ComparisonFamily::acted_neutral;
  }
  const bool same_emotion = !one.emotion.empty() && one.emotion == other.emotion;
  if (same_emotion && one.made == "modified" && other.made == "acted")
    return ComparisonFamily::modified_acted;
  return std::nullopt;
}

WithinParticipants within_participants(const std::vector<double>& differences) {
  WithinParticipants result;
  result.people = static_cast<int>(differences.size());
  result.t = paired_t_test(differences);
  result.all_equal = result.people > 1 && all_equal(differences);
  if (all_equal(differences)) {
    result.t = without_spread(result.t);
    result.dz = result.gz = result.t.t;
  } else {
    result.dz = cohens_dz(differences);
    result.gz = hedges_gz(differences);
  }
  result.wilcoxon = wilcoxon(differences);
  result.pratt = wilcoxon(differences, WilcoxonMode::exact, WilcoxonZeros::pratt);
  result.wilcoxon_normal = wilcoxon(differences, WilcoxonMode::published).p;
  result.wilcoxon_normal_corrected = wilcoxon(differences, WilcoxonMode::corrected).p;
  result.wilcoxon_zsplit = wilcoxon(differences, WilcoxonMode::published, WilcoxonZeros::zsplit).p;
  result.location = hodges_lehmann(differences);
  constexpr double attained = 0.95 - 1e-9;  // not with fewer than six differences
  if (result.location.confidence < attained)
    result.location.low = result.location.high = std::numeric_limits<double>::quiet_NaN();
  return result;
}

int end_sign(const Scale& scale, const std::string& emotion) {
  if (emotion.empty()) return 0;
  return emotion == scale.high ? 1 : emotion == scale.low ? -1 : 0;
}

std::vector<double> corrected(const std::vector<double>& p_values, TestCorrection correction) {
  if (correction == TestCorrection::none) return p_values;
  return correction == TestCorrection::holm ? holm(p_values) : benjamini_hochberg(p_values);
}

std::string name_of(TestCorrection correction) {
  if (correction == TestCorrection::none) return "none";
  return correction == TestCorrection::holm ? "Holm" : "Benjamini–Hochberg";
}

std::vector<Comparison> compare(const AnswerSet& answer_set) {
  std::vector<Comparison> all;
  for (std::size_t scale = 0; scale < answer_set.scales.size(); ++scale) {
    const ScaleComparisons comparisons(answer_set, scale);
    for (std::size_t one = 0; one < answer_set.stimuli.size(); ++one) {
      comparisons.add_best_seen(one, all);
      comparisons.add_best(one, all);
      for (std::size_t other = 0; other < answer_set.stimuli.size(); ++other) {
        const auto family = family_of(answer_set.stimuli[one], answer_set.stimuli[other]);
        if (family && one != other) comparisons.add_pair(*family, one, other, all);
        if (one >= other) continue;
        if (const auto factor =
                differing_factor(answer_set.stimuli[one], answer_set.stimuli[other]))
          comparisons.add_pair(ComparisonFamily::between_levels, one, other, all, *factor);
      }
    }
  }
  for (const auto& [word, family] : family_words)
    for (const bool of_hypothesis : {true, false})
      correct_family(all, family, of_hypothesis, answer_set.correction);
  std::ranges::stable_sort(all, {}, [](const Comparison& c) {
    return std::pair(static_cast<int>(c.family), c.stimulus);
  });
  return all;
}

std::vector<BestSeen> best_seen(const AnswerSet& answer_set,
                                const std::vector<Comparison>& comparisons) {
  std::vector<std::string> settings;
  for (const ReportedStimulus& stimulus : answer_set.stimuli)
    if (std::ranges::find(settings, stimulus.setting) == settings.end())
      settings.push_back(stimulus.setting);
  std::vector<BestSeen> all;
  for (const std::string& setting : settings) {
    for (std::size_t scale = 0; scale < answer_set.scales.size(); ++scale) {
      for (const bool high : {false, true}) {
        const double sign = high ? 1.0 : -1.0;
        const Comparison* best = nullptr;
        for (const Comparison& c : comparisons) {
          const bool is_online = c.family == ComparisonFamily::best_seen && c.scale == scale &&
                                 answer_set.stimuli[c.stimulus].setting == setting &&
                                 c.within.people >= 2;
          // The first of equal ones; rounding must not decide.
          if (is_online &&
              (best == nullptr || sign * (c.within.t.mean - best->within.t.mean) > 1e-12))
            best = &c;
        }
        if (best == nullptr) continue;
        const Scale& of = answer_set.scales[scale];
        all.push_back(
            {setting, high ? of.high : of.low, high, *best,
             sign * best->within.t.mean > 0.0 && best->paired_adjusted < answer_set.alpha});
      }
    }
  }
  return all;
}

}  // namespace mien::pipeline

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <string>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "motion/text/excerpt.h"
#include "motion/text/nearest_word.h"
#include "pipeline/base/documents/fault_list.h"
#include "pipeline/manifest/checks/part_checks.h"
#include "pipeline/manifest/questionnaire_content.h"

namespace mien::pipeline {

namespace {

const std::string analysis_path = "questionnaire.analysis";

/// Checks factors, groups and contrasts of an analysis against the stimuli and questions.
class FactorialCheck {
 public:
  explicit FactorialCheck(const Manifest& manifest)
      : manifest_(manifest),
        asked_(*manifest.questionnaire),
        plan_(asked_.analysis.factorial),
        list_(manifest.places),
        table_(design_table(manifest)) {}

  std::vector<Fault> faults() {
    if (plan_.empty()) return {};
    check_trials();
    check_factors();
    check_between();
    std::set<std::string> names;
    for (std::size_t i = 0; i < plan_.contrasts.size(); ++i) {
      const std::string path = element_path(member_path(analysis_path, "contrasts"), i);
      if (!names.insert(plan_.contrasts[i].name).second)
        list_.add(member_path(path, "name"),
                  motion::in_quotes(plan_.contrasts[i].name) + " is the name of another contrast",
                  "give each a different one");
      check_contrast(path, plan_.contrasts[i]);
    }
    return list_.take();
  }

 private:
  void check_trials() {
    const bool has_words = asked_.answer.words;
    if (asked_.trials->is_on_scale && !has_words) return;
    const bool are_pairs = asked_.trials == &pair_form;
    for (const char* key : {"factors", "between", "contrasts", "random_slopes"}) {
      const std::string path = member_path(analysis_path, key);
      const bool is_of_pairs = key == std::string("factors") || key == std::string("contrasts");
      if ((are_pairs && is_of_pairs) || !list_.was_given(path)) continue;
      list_.add_at_key(path,
                       "is computed from ratings of single stimuli, which this questionnaire "
                       "does not ask for",
                       "omit it");
    }
    if (are_pairs) check_levels_of_pairs();
  }

  /// Reports compared stimuli without a level of a factor, which would be in no condition.
  void check_levels_of_pairs() {
    for (std::size_t i = 0; i < plan_.factors.size(); ++i) {
      const std::vector<std::string> known = factors_of(manifest_);
      if (std::ranges::find(known, plan_.factors[i]) == known.end()) continue;
      for (const auto& pair : questionnaire_subjects(manifest_)) {
        const auto without = std::ranges::find_if(pair, [&](const std::string& id) {
          return level_of(manifest_, id, plan_.factors[i]).empty();
        });
        if (without == pair.end()) continue;
        list_.add(element_path(member_path(analysis_path, "factors"), i),
                  fmt::format("{} is compared, but has no level of {}", motion::in_quotes(*without),
                              motion::in_quotes(plan_.factors[i])),
                  "add it to its factors: {…}, or omit the factor here");
        break;
      }
    }
  }

  void check_factors() {
    const std::string path = member_path(analysis_path, "factors");
    std::set<std::string> taken;
    for (std::size_t i = 0; i < plan_.factors.size(); ++i) {
      const std::string place = element_path(path, i);
      const std::string& factor = plan_.factors[i];
      if (!taken.insert(factor).second)
        list_.add(place, motion::in_quotes(factor) + " appears twice", "name it once");
      const std::vector<std::string> known = factors_of(manifest_);
      if (std::ranges::find(known, factor) == known.end()) {
        list_.add(place, "unknown factor " + motion::in_quotes(factor),
                  known.empty() ? "add factors: {…} to the stimuli"
                                : motion::did_you_mean(factor, known));
      } else if (table_.levels_of(i).size() < 2) {
        list_.add(place, "the rated stimuli do not differ in " + motion::in_quotes(factor),
                  "omit it, or have stimuli of several levels rated");
      }
    }
  }

  void check_between() {
    if (plan_.between.empty()) return;
    std::vector<std::string> choices, others;
    const auto sort_in = [&](const auto& questions) {
      for (const auto& question : questions)
        (question.answer.choices.words.size() > 1 ? choices : others).push_back(question.id);
    };
    sort_in(asked_.screening.questions);
    sort_in(asked_.demographics);
    const std::string path = member_path(analysis_path, "between");
    if (std::ranges::find(choices, plan_.between) != choices.end()) return;
    if (std::ranges::find(others, plan_.between) != others.end())
      return list_.add(path, "the question has no choices that could form groups",
                       "give it answer: [one, other]");
    list_.add(path, "there is no question " + motion::in_quotes(plan_.between),
              choices.empty() ? "ask it: demographics: [{id: …, ask: …, answer: [one, other]}]"
                              : motion::did_you_mean(plan_.between, choices));
  }

  /// The levels of a factor of the analysis; reports an unknown one and returns none.
  std::vector<std::string> known_levels(const std::string& place, const std::string& factor) {
    const auto found = std::ranges::find(table_.factors, factor);
    if (found != table_.factors.end())
      return table_.levels_of(static_cast<std::size_t>(found - table_.factors.begin()));
    const std::vector<std::string> all = factors_of(manifest_);
    const bool is_factor = std::ranges::find(all, factor) != all.end();
    list_.add_at_key(place,
                     is_factor ? motion::in_quotes(factor) + " is no factor of the analysis"
                               : "unknown factor " + motion::in_quotes(factor),
                     is_factor && !plan_.factors.empty() ? "add it to analysis: factors"
                     : is_factor                         ? "the rated stimuli do not differ in it"
                     : table_.factors.empty()            ? "add factors: {…} to the stimuli"
                                              : motion::did_you_mean(factor, table_.factors));
    return {};
  }

  bool check_level(const std::string& place, const std::string& level,
                   const std::vector<std::string>& known) {
    if (std::ranges::find(known, level) != known.end()) return true;
    list_.add_at_key(place, "no rated stimulus has the level " + motion::in_quotes(level),
                     motion::did_you_mean(level, known));
    return false;
  }

  bool check_weights(const std::string& place, const std::string& factor,
                     const LevelWeights& weights) {
    const std::vector<std::string> known = known_levels(place, factor);
    if (known.empty()) return false;
    bool are_known = true;
    double sum = 0.0, size = 0.0;
    for (const auto& [level, weight] : weights) {
      are_known = check_level(member_path(place, level), level, known) && are_known;
      sum += weight;
      size += std::abs(weight);
    }
    if (std::abs(sum) > 1e-6 * size || size == 0.0) {
      list_.add(place,
                size == 0.0 ? std::string("all weights are 0")
                            : fmt::format("the weights have a sum of {:.6g}", sum),
                "use weights with a sum of 0, such as {" +
                    (known.size() > 1 ? known[0] + ": 1, " + known[1] + ": -1}" : "a: 1, b: -1}"));
      return false;
    }
    return are_known;
  }

  void check_contrast(const std::string& path, const PlannedContrast& contrast) {
    bool is_known = !contrast.weights.empty();
    for (const auto& [factor, weights] : contrast.weights)
      is_known =
          check_weights(member_path(member_path(path, "weights"), factor), factor, weights) &&
          is_known;
    for (const auto& [factor, level] : contrast.at) {
      const std::string place = member_path(member_path(path, "at"), factor);
      const bool is_weighted = std::ranges::any_of(
          contrast.weights,
          [&name = factor](const auto& weighted) { return weighted.first == name; });
      if (is_weighted) {
        list_.add_at_key(place, "is one of the factors that are compared", "omit it here");
        is_known = false;
        continue;
      }
      const std::vector<std::string> known = known_levels(place, factor);
      is_known = !known.empty() && check_level(place, level, known) && is_known;
    }
    check_scales(path, contrast);
    if (is_known && matched_settings(table_, contrast.weights, contrast.at).empty())
      list_.add(member_path(path, "weights"),
                "there is no combination of levels of the other factors in which all these levels "
                "are rated",
                "compare levels that occur together, or name the factors to consider under "
                "analysis: factors");
  }

  void check_scales(const std::string& path, const PlannedContrast& contrast) {
    std::vector<std::string> asked;
    for (const Scale& scale : questionnaire_scales(manifest_).scales) asked.push_back(scale.id);
    for (std::size_t i = 0; i < contrast.scales.size(); ++i)
      list_.check_known_name(element_path(member_path(path, "scales"), i), contrast.scales[i],
                             "scale", asked);
  }

  const Manifest& manifest_;
  const Questionnaire& asked_;
  const FactorialPlan& plan_;
  FaultList list_;
  FactorTable table_;
};

}  // namespace

std::vector<Fault> check_factorial(const Manifest& manifest) {
  if (!manifest.questionnaire) return {};
  return FactorialCheck(manifest).faults();
}

}  // namespace mien::pipeline

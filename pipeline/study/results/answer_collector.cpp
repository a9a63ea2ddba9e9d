#include "pipeline/study/results/answer_collector.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <tuple>

#include <fmt/format.h>

#include "motion/text/as_number.h"
#include "motion/text/excerpt.h"
#include "motion/text/nearest_word.h"
#include "pipeline/manifest/questionnaire_content.h"
#include "pipeline/manifest/questionnaire_pairs.h"
#include "pipeline/manifest/ratings/answers/best_worst_item.h"
#include "pipeline/manifest/ratings/answers/counted_answers.h"
#include "pipeline/manifest/ratings/answers/trace.h"
#include "pipeline/manifest/ratings/answers/trace_table.h"
#include "pipeline/manifest/ratings/answers/trial_form.h"
#include "pipeline/study/results/best_worst_scores.h"

namespace mien::pipeline {

namespace {

/// Validates rows and collects their faults.
class AnswerCollector {
 public:
  AnswerCollector(const Manifest& manifest, const std::vector<AnswerRow>& rows, AnswerSet& result)
      : questionnaire_(questionnaire_of(manifest)), rows_(rows), result_(result) {
    for (std::size_t i = 0; i < result.stimuli.size(); ++i) {
      stimuli_.emplace(result.stimuli[i].id, i);
      stimulus_ids_.push_back(result.stimuli[i].id);
    }
    for (std::size_t i = 0; i < result.scales.size(); ++i) {
      scales_.emplace(result.scales[i].id, i);
      items_.push_back(result.scales[i].id);
    }
    for (std::size_t i = 0; i < result.people.size(); ++i) people_.emplace(result.people[i], i);
    for (const std::string& id : signal_stimuli(manifest)) signal_.insert(id);
  }

  void check_and_add_all() {
    for (const AnswerRow& row : rows_) check_and_add(row);
    add_sets();
  }

  std::vector<Fault> faults;

 private:
  void check_and_add(const AnswerRow& row) {
    if (row.kind == attention_kind) return;
    const auto stimulus = known_stimulus(row, row.stimulus);
    if (!stimulus || !is_of_trial_kind(row)) return;
    if (find_trial_form(row.kind)->is_continuous) {
      add_trace(row, *stimulus);
    } else if (is_on_scale(row)) {
      add_rating(row, *stimulus);
    } else if (find_trial_form(row.kind)->is_set) {
      add_best_or_worst(row);
    } else if (find_trial_form(row.kind)->is_detection && result_.thresholds) {
      add_level(row, *stimulus);
    } else if (find_trial_form(row.kind)->is_detection) {
      add_detection(row, *stimulus);
    } else if (row.item == find_trial_form(row.kind)->item) {
      add_choice(row, *stimulus);
    } else {
      add_preference(row, *stimulus);
    }
    if (!row.comment.empty() && !row.is_practice)
      result_.remarks.push_back({row.participant, row.stimulus, "", row.comment});
  }

  void fault(const AnswerRow& row, std::string wrong, std::string remedy) {
    faults.push_back({row.place, "", std::move(wrong), std::move(remedy)});
  }

  std::optional<std::size_t> known_stimulus(const AnswerRow& row, const std::string& id) {
    const auto found = stimuli_.find(id);
    if (found != stimuli_.end()) return found->second;
    if (told_.insert(id).second)
      fault(row, fmt::format("the study has no stimulus {}", motion::in_quotes(id)),
            motion::did_you_mean(id, stimulus_ids_));
    return std::nullopt;
  }

  bool is_of_trial_kind(const AnswerRow& row) {
    const TrialForm& asked = *questionnaire_.trials;
    // A study of pairs may ask to rate by how much, too.
    if (row.kind == asked.name || (asked.stimuli > 1 && row.kind == rating_form.name)) return true;
    if (told_.insert("kind " + row.kind).second)
      fault(row,
            fmt::format("an answer of kind {}, but the questionnaire has trials of kind {}",
                        row.kind, asked.name),
            "give the manifest that these answers belong to");
    return false;
  }

  bool counts(const AnswerRow& row) const {
    return row.counts() && people_.contains(row.participant) &&
           !result_.quality.leaves_out(static_cast<std::size_t>(&row - rows_.data()));
  }

  std::optional<std::size_t> known_scale(const AnswerRow& row) {
    const auto item = questionnaire_.trials->is_set ? best_worst_item(row.item) : std::nullopt;
    const auto found = scales_.find(item ? item->scale : row.item);
    if (found != scales_.end()) return found->second;
    if (told_.insert("item " + row.item).second)
      fault(row, fmt::format("the questionnaire does not ask {}", motion::in_quotes(row.item)),
            motion::did_you_mean(row.item, items_));
    return std::nullopt;
  }

  /// A trace, and its mean as a rating.
  void add_trace(const AnswerRow& row, std::size_t stimulus) {
    const auto scale = known_scale(row);
    if (!scale || row.value_raw.empty()) return;
    auto trace = trace_of(row);
    if (!trace) {
      fault(row, fmt::format("{} is no trace", motion::in_quotes(motion::excerpt(row.value_raw))),
            "traces are numbers from 0 to 100, separated by spaces");
      return;
    }
    const auto written = motion::as_finite_number(row.value);
    const auto unmoved = mean_of_trace(*trace, result_.trace_lead_s);
    const auto mean = mean_of_trace(*trace, result_.trace_lead_s, result_.trace_lag_s);
    if (unmoved.has_value() != written.has_value() ||
        (written && std::abs(*written - *unmoved) > 1e-5)) {
      fault(row,
            fmt::format("the mean of the trace after {:g} s is {}, not {}", result_.trace_lead_s,
                        unmoved ? fmt::format("{:g}", *unmoved) : "none", row.value),
            "use the file as written by the questionnaire, and its manifest");
      return;
    }
    if (!mean) {
      fault(row, "the film is over before the lead and the lag of the analysis",
            "use a smaller analysis: {lag: …}");
      return;
    }
    if (!counts(row)) return;
    const std::size_t person = people_.at(row.participant);
    result_.ratings.push_back({person, stimulus, *scale, *mean});
    result_.traces.push_back({person, stimulus, *scale, std::move(*trace)});
  }

  void add_rating(const AnswerRow& row, std::size_t stimulus) {
    if (questionnaire_.answer.words) {
      if (counts(row))
        result_.words.push_back({row.participant, row.stimulus, row.item, row.value});
      return;
    }
    const auto scale = known_scale(row);
    if (!scale || row.value.empty() || row.value == "NA") return;
    const auto value = motion::as_finite_number(row.value);
    const Scale& of = result_.scales[*scale];
    if (!value || *value < of.least || *value > of.most) {
      fault(row,
            fmt::format("{} is not a valid answer on {}", motion::in_quotes(row.value),
                        motion::in_quotes(of.id)),
            fmt::format("answers go from {} to {}", of.least, of.most));
      return;
    }
    check_orientation(row, of, *value);
    if (counts(row))
      result_.ratings.push_back({people_.at(row.participant), stimulus, *scale, *value});
  }

  /// Checks that the raw answer and the side of the poles give the value.
  void check_orientation(const AnswerRow& row, const Scale& scale, double value) {
    const auto raw = motion::as_finite_number(row.value_raw);
    if (!raw || row.pole_left.empty()) return;
    const double share = result_.is_slider
                             ? *raw / 100.0
                             : (*raw - 1.0) / std::max(1.0, questionnaire_.answer.points - 1.0);
    const double from_low = row.pole_left == "low" ? share : 1.0 - share;
    const double expected = scale.least + from_low * (scale.most - scale.least);
    if (std::abs(expected - value) <= 1e-6 * (scale.most - scale.least)) return;
    fault(row,
          fmt::format("the raw answer {} with the {} pole on the left corresponds to {:g}, not {}",
                      row.value_raw, row.pole_left, expected, row.value),
          "use the file as written by the questionnaire, and its manifest");
  }

  void add_choice(const AnswerRow& row, std::size_t stimulus) {
    if (row.value.empty() || row.value == "NA") return;
    const bool is_offered = std::ranges::any_of(
        result_.choices, [&](const auto& choice) { return choice.first == row.value; });
    if (!is_offered) {
      fault(row, fmt::format("{} was not among the choices", motion::in_quotes(row.value)),
            "give the manifest that these answers belong to");
      return;
    }
    if (counts(row)) result_.chosen.push_back({people_.at(row.participant), stimulus, row.value});
  }

  void add_preference(const AnswerRow& row, std::size_t stimulus) {
    const auto against = known_stimulus(row, row.against);
    if (!against || row.value.empty() || row.value == "NA") return;
    const bool is_tie = row.value == tie_value && row.value_raw == tie_value;
    if (!is_tie && row.value != row.stimulus && row.value != row.against) {
      fault(row, fmt::format("{} is not one of the pair", motion::in_quotes(row.value)),
            fmt::format("they are {} and {}", row.stimulus, row.against));
      return;
    }
    if (!counts(row)) return;
    const bool is_first = is_tie || row.value == row.stimulus;
    result_.preferences.push_back({people_.at(row.participant), is_first ? stimulus : *against,
                                   is_first ? *against : stimulus, row.item, is_first, is_tie});
  }

  void add_detection(const AnswerRow& row, std::size_t stimulus) {
    const TrialForm& form = *questionnaire_.trials;
    if (row.value.empty() || row.value == "NA") return;
    std::optional<std::size_t> other;
    if (form.stimuli > 1) {
      other = known_stimulus(row, row.against);
      if (!other) return;
    }
    const bool is_interval = &form == &two_interval_form;
    const char* positive = &form == &yes_no_form ? yes_answer : different_answer;
    const char* negative = &form == &yes_no_form ? "no" : "same";
    const bool is_known = is_interval ? row.value == row.stimulus || row.value == row.against
                                      : row.value == positive || row.value == negative;
    if (!is_known) {
      refuse_detection(row, is_interval
                                ? fmt::format("answers are {} and {}", row.stimulus, row.against)
                                : fmt::format("answers are {} and {}", positive, negative));
      return;
    }
    if (!counts(row)) return;
    const bool is_signal =
        &form == &same_different_form ? stimulus != *other : signal_.contains(row.stimulus);
    if (other == stimulus) other.reset();
    if (other && *other < stimulus) std::swap(stimulus, *other);
    result_.detections.push_back({people_.at(row.participant), stimulus, other, is_signal,
                                  row.value == (is_interval ? row.stimulus : positive)});
  }

  void refuse_detection(const AnswerRow& row, std::string answers) {
    fault(row, fmt::format("{} is no answer to this trial", motion::in_quotes(row.value)),
          std::move(answers));
  }

  /// Whether the answer to an adaptive trial is right, "yes" or "different"; nullopt if it is none.
  std::optional<bool> is_positive(const AnswerRow& row) const {
    const TrialForm& form = *questionnaire_.trials;
    if (&form == &two_interval_form) {
      if (row.value != row.stimulus && row.value != row.against) return std::nullopt;
      return signal_.contains(row.value);
    }
    const bool is_yes_no = &form == &yes_no_form;
    if (row.value == (is_yes_no ? yes_answer : different_answer)) return true;
    if (row.value == (is_yes_no ? "no" : "same")) return false;
    return std::nullopt;
  }

  /// The level of an adaptive trial, which is that of the shown stimulus with the signal or, of a
  /// trial without it, of the one shown.
  std::optional<double> shown_level(const AnswerRow& row, std::size_t stimulus) {
    const bool is_first = signal_.contains(row.stimulus) || row.against.empty() || !row.track;
    const auto other = is_first ? stimulus : known_stimulus(row, row.against);
    if (!other) return std::nullopt;
    const auto level = motion::as_finite_number(row.level);
    const std::string stated = level_in(result_.stimuli[*other].factors);
    if (level && level == motion::as_finite_number(stated)) return level;
    fault(row,
          fmt::format("the level {} is not that of {}, which is {}", motion::in_quotes(row.level),
                      result_.stimuli[*other].id, motion::in_quotes(stated)),
          "use the file as written by the questionnaire, and its manifest");
    return std::nullopt;
  }

  std::string level_in(const Factors& factors) const {
    for (const auto& [name, level] : factors)
      if (name == result_.thresholds->factor) return level;
    return "";
  }

  void add_level(const AnswerRow& row, std::size_t stimulus) {
    const std::string& factor = result_.thresholds->factor;
    if (row.value.empty() || row.value == "NA" || row.is_practice) return;
    const auto positive = is_positive(row);
    if (!positive) return refuse_detection(row, "use the file as written by the questionnaire");
    const auto level = shown_level(row, stimulus);
    if (!level || !people_.contains(row.participant)) return;
    const std::vector<std::string>& grid = result_.thresholds->procedure.levels;
    const auto place = std::ranges::find_if(
        grid, [&](const std::string& one) { return motion::as_finite_number(one) == level; });
    if (row.track && place == grid.end())
      return fault(row, fmt::format("{} is no level of {}", row.level, factor),
                   "give the manifest that these answers belong to");
    result_.levels.push_back({people_.at(row.participant), row.trial, row.track.value_or(0), *level,
                              static_cast<std::size_t>(place - grid.begin()), *positive,
                              counts(row)});
  }

  /// Part of the answer about a set. Both parts make a set.
  void add_best_or_worst(const AnswerRow& row) {
    const auto item = best_worst_item(row.item);
    const auto scale = known_scale(row);
    const auto stimuli = known_set(row);
    if (!scale || !stimuli || row.value.empty() || row.value == "NA") return;
    const auto place = std::ranges::find_if(
        *stimuli, [&](std::size_t one) { return result_.stimuli[one].id == row.value; });
    if (!item || place == stimuli->end()) {
      const std::string& wrong = item ? row.value : row.item;
      fault(row, fmt::format("{} is not one of the set", motion::in_quotes(wrong)),
            fmt::format("they are {} {}", row.stimulus, row.against));
      return;
    }
    const auto chosen = static_cast<std::size_t>(place - stimuli->begin());
    PartialSet& set = sets_[{row.participant, row.trial, item->scale}];
    set.stimuli = *stimuli;
    (item->is_best ? set.best : set.worst) = chosen;
    if (set.best && set.best == set.worst)
      fault(row, fmt::format("{} is best and worst", motion::in_quotes(row.value)),
            "use the file as written by the questionnaire");
    set.counts = set.counts && counts(row);
  }

  std::optional<std::vector<std::size_t>> known_set(const AnswerRow& row) {
    std::vector<std::size_t> stimuli;
    std::istringstream ids(row.stimulus + " " + row.against);
    for (std::string id; ids >> id;) {
      const auto known = known_stimulus(row, id);
      if (!known) return std::nullopt;
      stimuli.push_back(*known);
    }
    return stimuli;
  }

  void add_sets() {
    for (const auto& [key, set] : sets_) {
      if (!set.counts || !set.best || !set.worst) continue;
      const auto& [participant, trial, scale] = key;
      result_.sets.push_back({people_.at(participant), set.stimuli, scale, *set.best, *set.worst});
      for (const AnalysedPreference& one : implied_preferences(result_.sets.back()))
        result_.preferences.push_back(one);
    }
  }

  /// What is known so far about an answer to a set.
  struct PartialSet {
    std::vector<std::size_t> stimuli;
    std::optional<std::size_t> best = std::nullopt;
    std::optional<std::size_t> worst = std::nullopt;
    bool counts = true;
  };

  const Questionnaire& questionnaire_;
  std::map<std::tuple<std::string, int, std::string>, PartialSet> sets_;
  std::set<std::string> signal_;  ///< stimuli with the signal
  const std::vector<AnswerRow>& rows_;
  AnswerSet& result_;
  std::map<std::string, std::size_t> stimuli_, scales_, people_;
  std::vector<std::string> stimulus_ids_, items_;
  std::set<std::string> told_;
};

}  // namespace

std::vector<Fault> check_and_collect(const Manifest& manifest, const std::vector<AnswerRow>& rows,
                                     AnswerSet& result) {
  AnswerCollector collector(manifest, rows, result);
  collector.check_and_add_all();
  return collector.faults;
}

}  // namespace mien::pipeline

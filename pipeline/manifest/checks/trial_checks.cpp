#include <algorithm>
#include <set>
#include <string>

#include <fmt/format.h>

#include "motion/text/excerpt.h"
#include "pipeline/base/documents/fault_list.h"
#include "pipeline/manifest/checks/part_checks.h"
#include "pipeline/manifest/questionnaire_content.h"
#include "pipeline/manifest/questionnaire_pairs.h"

namespace mien::pipeline {

namespace {

std::string path_of(const char* key) { return member_path("questionnaire", key); }

/// Checks the form of a questionnaire's trials against its other keys.
class TrialFormCheck {
 public:
  explicit TrialFormCheck(const Manifest& manifest)
      : manifest_(manifest),
        asked_(*manifest.questionnaire),
        form_(*asked_.trials),
        list_(manifest.places) {}

  std::vector<Fault> faults() {
    check_keys();
    check_preference();
    check_asked();
    if (&form_ == &same_different_form) check_same_different();
    if (form_.has_key("signal")) check_signal();
    if (form_.is_set) check_sets();
    return list_.take();
  }

 private:
  bool was_given(const char* key) const { return list_.was_given(path_of(key)); }

  /// Refuses keys of other forms.
  void check_keys() {
    for (const char* key : {"choices", "pairs", "preference", "same_different", "signal",
                            "best_worst", "grid", "continuous"}) {
      if (!was_given(key) || form_.has_key(key)) continue;
      std::vector<std::string_view> names;
      for (const auto& [name, form] : trial_form_words)
        if (form->has_key(key)) names.emplace_back(name);
      list_.add_at_key(path_of(key),
                       fmt::format("only {} trials have {}", fmt::join(names, " or "), key),
                       fmt::format("add trials: {}", names.front()));
    }
  }

  void check_preference() {
    for (const char* key : {"ties", "strength"}) {
      const std::string path = member_path(path_of("preference"), key);
      if (form_.is_detection && list_.was_given(path))
        list_.add_at_key(path, fmt::format("{} trials ask for no preference", form_.name),
                         "omit it, or use trials: pair");
    }
    const std::string alike = member_path(path_of("preference"), "alike");
    if (form_.is_detection && list_.was_given(alike))
      list_.add_at_key(alike, fmt::format("does not apply to {} trials", form_.name),
                       "omit it, or use same_different: {differ_in: …}");
    const bool has_tie = std::ranges::any_of(
        manifest_.stimuli, [](const Stimulus& stimulus) { return stimulus.id == tie_value; });
    if (asked_.preference.ties && has_tie)
      list_.add(member_path(path_of("preference"), "ties"),
                "a stimulus has the id \"tie\", which answers without a preference have",
                "rename the stimulus");
  }

  /// What is asked in a trial.
  void check_asked() {
    if (form_.offers_choices && asked_.choices.empty() &&
        questionnaire_choices(manifest_).size() < 2) {
      list_.add(path_of("trials"), "there are fewer than two emotions to choose from",
                "add choices: [sad, happy], or the factor emotion to the stimuli");
    }
    if (form_.stimuli > 1 && !asked_.reference.empty())
      list_.add(path_of("reference"),
                form_.is_grid  ? "each set of a grid has a reference of its own"
                : form_.is_set ? "the stimuli of a set are already compared"
                               : "the two stimuli of a pair are already compared",
                form_.is_grid ? "name the references in grid: {reference: …}" : "omit it");
    if (!form_.is_on_scale && asked_.answer.words)
      list_.add(member_path(path_of("answer"), "words"),
                form_.is_detection || form_.is_set ? "these trials are not answered in words"
                                                   : "choices between two stimuli have no words",
                "omit it");
    if (form_.is_detection && was_given("scales"))
      list_.add_at_key(path_of("scales"), fmt::format("{} trials ask no scales", form_.name),
                       "omit it");
  }

  void check_same_different() {
    const std::string& factor = asked_.same_different.differ_in;
    const std::string path = member_path(path_of("same_different"), "differ_in");
    if (factor.empty()) return;
    if (!asked_.pairs.empty())
      return list_.add_at_key(path, "cannot be combined with pairs", "keep one of them");
    const std::vector<std::string> known = studied_factors(manifest_);
    if (std::ranges::find(known, factor) == known.end()) {
      if (known.empty())
        return list_.add(path, "the stimuli have no factors",
                         "add factors: {actor: …} to the stimuli");
      return list_.check_known_name(path, factor, "factor", known);
    }
    if (different_pairs(manifest_).empty())
      list_.add(path, fmt::format("no two stimuli differ in {} only", motion::in_quotes(factor)),
                "list the pairs to show: pairs: [[a, b], …]");
  }

  void check_sets() {
    const auto count = static_cast<int>(questionnaire_stimuli(manifest_).size());
    const BestWorstSettings& sets = asked_.best_worst;
    const std::string path = path_of("best_worst");
    if (count > 0 && sets.size > count)
      list_.add(member_path(path, "size"),
                fmt::format("there are {} stimuli for sets of {}", count, sets.size),
                "use smaller sets, or show more stimuli");
    else if (count > 0 && sets.sets > 0 && sets.sets * sets.size < count)
      list_.add(
          member_path(path, "sets"),
          fmt::format("{} sets of {} cannot have all {} stimuli", sets.sets, sets.size, count),
          fmt::format("use at least {}", (count + sets.size - 1) / sets.size));
    // Each set is one practice trial; the same stimulus twice in a set cannot be compared.
    const auto each = static_cast<std::size_t>(sets.size);
    for (std::size_t i = 0; i < asked_.practice.size(); ++i)
      for (std::size_t k = i - i % each; k < i; ++k)
        if (asked_.practice[k] == asked_.practice[i])
          list_.add(element_path(path_of("practice"), i),
                    motion::in_quotes(asked_.practice[i]) + " appears twice in a set",
                    "name it once");
  }

  void check_signal() {
    const std::string path = path_of("signal");
    if (asked_.question.empty())
      list_.add("questionnaire", fmt::format("{} trials have no question of their own", form_.name),
                "add question: Is this walk sad?");
    if (!was_given("signal") && !asked_.adaptive.empty()) return;  // adaptive_levels.h
    if (!was_given("signal"))
      return list_.add(
          "questionnaire",
          fmt::format("{} trials need stimuli with and without the signal", form_.name),
          "add signal: [a, b], or a factor and its levels: signal: {emotion: [sad]}");
    check_signal_of_stimuli(path);
    const std::vector<std::string> signal = signal_stimuli(manifest_);
    for (std::size_t i = 0; form_.stimuli > 1 && i < asked_.pairs.size(); ++i) {
      const auto with = std::ranges::count_if(asked_.pairs[i], [&](const std::string& id) {
        return std::ranges::find(signal, id) != signal.end();
      });
      if (with != 1)
        list_.add(element_path(path_of("pairs"), i),
                  with == 0 ? "neither stimulus has the signal" : "both stimuli have the signal",
                  "name one stimulus with the signal and one without");
    }
  }

  /// Whether the stimuli and levels of the signal exist; others are reported elsewhere.
  bool are_signal_names_known() const {
    const auto is_of_any = [&](auto is_it) {
      return std::ranges::any_of(manifest_.stimuli, is_it);
    };
    for (const std::string& id : asked_.signal.ids)
      if (!is_of_any([&](const Stimulus& one) { return one.id == id; })) return false;
    for (const auto& [factor, levels] : asked_.signal.levels)
      for (const std::string& level : levels)
        if (!is_of_any(
                [&, &name = factor](const Stimulus& one) { return level_of(one, name) == level; }))
          return false;
    return true;
  }

  void check_signal_of_stimuli(const std::string& path) {
    if (!asked_.pairs.empty() || manifest_.stimuli.empty() || !are_signal_names_known()) return;
    const std::vector<std::string> signal = signal_stimuli(manifest_);
    const std::vector<std::string> rated = questionnaire_stimuli(manifest_);
    const auto with = std::ranges::count_if(rated, [&](const std::string& id) {
      return std::ranges::find(signal, id) != signal.end();
    });
    if (with == 0)
      list_.add(path, "none of the stimuli has the signal", "name stimuli that are rated");
    if (with == std::ssize(rated) && with > 0)
      list_.add(path, "all of the stimuli have the signal", "show stimuli without the signal, too");
  }

  const Manifest& manifest_;
  const Questionnaire& asked_;
  const TrialForm& form_;
  FaultList list_;
};

}  // namespace

std::vector<Fault> check_trial_form(const Manifest& manifest) {
  if (!manifest.questionnaire) return {};
  return TrialFormCheck(manifest).faults();
}

}  // namespace mien::pipeline

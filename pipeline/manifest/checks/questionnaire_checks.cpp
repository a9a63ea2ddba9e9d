#include <algorithm>
#include <map>
#include <set>
#include <string>

#include <fmt/format.h>

#include "motion/text/excerpt.h"
#include "motion/text/nearest_word.h"
#include "pipeline/base/documents/fault_list.h"
#include "pipeline/manifest/checks/part_checks.h"
#include "pipeline/manifest/person_figure.h"
#include "pipeline/manifest/questionnaire_content.h"

namespace mien::pipeline {

namespace {

using Names = std::vector<std::string>;

std::string at(const char* key) { return member_path("questionnaire", key); }

bool can_people_be_turned(const Stimulus& stimulus) {
  return std::ranges::all_of(stimulus.people, [&](const Person& person) {
    return can_be_turned(figure_of(person, stimulus.look));
  });
}

/// Holds a questionnaire against the manifest around it.
class QuestionnaireCheck {
 public:
  explicit QuestionnaireCheck(const Manifest& manifest)
      : manifest_(manifest),
        questionnaire_(*manifest.questionnaire),
        form_(*questionnaire_.trials),
        list_(manifest.places) {
    for (const Stimulus& stimulus : manifest.stimuli) ids_.push_back(stimulus.id);
    factors_ = factors_of(manifest);
  }

  std::vector<Fault> faults() {
    check_stimuli();
    check_scales();
    check_answers();
    check_trials();
    check_order();
    check_numbers();
    check_question_ids();
    check_view();
    check_display();
    return list_.take();
  }

 private:
  void check_ids(const std::string& path, const Names& names, const char* what,
                 const Names& known) {
    std::set<std::string> taken;
    for (std::size_t i = 0; i < names.size(); ++i) {
      list_.check_known_name(element_path(path, i), names[i], what, known);
      if (!taken.insert(names[i]).second)
        list_.add(element_path(path, i), motion::in_quotes(names[i]) + " appears twice",
                  "name it once");
    }
  }

  void check_factor(const std::string& path, const std::string& factor) {
    if (factors_.empty())
      return list_.add(path, "the stimuli have no factors",
                       "add factors: {actor: …} to the stimuli");
    list_.check_known_name(path, factor, "factor", factors_);
  }

  Names levels_of_factor(const std::string& factor) const {
    Names levels;
    for (const Stimulus& stimulus : manifest_.stimuli) {
      const std::string level = level_of(stimulus, factor);
      if (!level.empty() && std::ranges::find(levels, level) == levels.end())
        levels.push_back(level);
    }
    return levels;
  }

  bool are_levels_known() const {
    return std::ranges::all_of(questionnaire_.stimuli.levels, [&](const auto& wanted) {
      const Names known = levels_of_factor(wanted.first);
      return std::ranges::all_of(wanted.second, [&](const std::string& level) {
        return std::ranges::find(known, level) != known.end();
      });
    });
  }

  void check_choice(const std::string& path, const StimulusChoice& choice) {
    check_ids(path, choice.ids, "stimulus", ids_);
    for (const auto& [factor, levels] : choice.levels) {
      const std::string place = member_path(path, factor);
      if (std::ranges::find(factors_, factor) == factors_.end()) {
        list_.add_at_key(place, "unknown factor", motion::did_you_mean(factor, factors_));
      } else {
        check_ids(place, levels, "level", levels_of_factor(factor));
      }
    }
  }

  /// The same stimulus may be shown twice in practice only where it is in the main part, too.
  void check_practice() {
    if (&form_ != &same_different_form && !form_.is_set)
      return check_ids(at("practice"), questionnaire_.practice, "stimulus", ids_);
    for (std::size_t i = 0; i < questionnaire_.practice.size(); ++i)
      list_.check_known_name(element_path(at("practice"), i), questionnaire_.practice[i],
                             "stimulus", ids_);
  }

  void check_stimuli() {
    const std::string path = at("stimuli");
    check_choice(path, questionnaire_.stimuli);
    check_practice();
    if (!questionnaire_.reference.empty())
      list_.check_known_name(at("reference"), questionnaire_.reference, "stimulus", ids_);
    if (!ids_.empty() && are_levels_known() && questionnaire_stimuli(manifest_).empty())
      list_.add(path, "no stimulus has these levels", "name levels that occur together");
  }

  void check_scales() {
    const ScaleChoice& choice = questionnaire_.scales;
    const bool is_asked = choice.all || choice.emotions || !choice.ids.empty();
    if (!is_asked && form_.item.empty() && !list_.was_given(at("scales"))) {
      list_.add("questionnaire", "has no scales",
                "add scales: all, scales: emotions or scales: [sad-happy]");
    }
    Names known;
    for (const Scale& scale : scales_to_choose(manifest_).scales) known.push_back(scale.id);
    const std::string path = choice.file.empty() ? at("scales") : member_path(at("scales"), "ask");
    check_ids(path, choice.ids, "scale", known);
  }

  void check_answers() {
    const AnswerSettings& answer = questionnaire_.answer;
    const std::string path = at("answer");
    const auto one_of = [&](bool chosen, const char* key, const char* other) {
      if (chosen && list_.was_given(member_path(path, key)))
        list_.add_at_key(member_path(path, key), std::string("cannot be combined with ") + other,
                         "keep one of them");
    };
    one_of(answer.slider, "points", "slider");
    one_of(answer.words, "points", "free words");
    if (answer.slider) one_of(answer.words, "words", "slider");
    if (!answer.suggest.empty() && !answer.words)
      list_.add_at_key(member_path(path, "suggest"), "only answers in free words have suggestions",
                       "add words: true, or omit it");
    if (answer.starts_at != StartsAt::middle) return;
    const std::string start = member_path(path, "default");
    if (answer.words) list_.add(start, "free-text answers have no middle", "use none");
    if (!answer.words && !answer.slider && answer.points % 2 == 0) {
      list_.add(start, fmt::format("{} points have no middle", answer.points),
                "use an odd number of points, or none");
    }
  }

  void check_trials() {
    if (const std::size_t each = stimuli_per_trial(questionnaire_);
        each > 0 && questionnaire_.practice.size() % each != 0)
      list_.add(at("practice"),
                each == 2 ? "practice with pairs needs an even number of stimuli"
                          : fmt::format("practice needs {} stimuli for each trial", each),
                each == 2 ? "name an even number" : "name as many for each practice trial");
    for (std::size_t i = 0; i < questionnaire_.pairs.size(); ++i)
      check_ids(element_path(at("pairs"), i), questionnaire_.pairs[i], "stimulus", ids_);
    check_choice(at("signal"), questionnaire_.signal);
    check_choice(member_path(at("grid"), "reference"), questionnaire_.grid.reference);
    check_choice(member_path(at("grid"), "anchor"), questionnaire_.grid.anchor);
    check_alike();
  }

  void check_alike() {
    const std::vector<std::string>& alike = questionnaire_.preference.alike;
    const std::string path = member_path(at("preference"), "alike");
    if (alike.empty() || form_.stimuli == 1) return;
    for (std::size_t i = 0; i < alike.size(); ++i) check_factor(element_path(path, i), alike[i]);
    for (std::size_t i = 0; i < questionnaire_.pairs.size(); ++i)
      for (const std::string& factor : alike)
        check_pair_alike(element_path(at("pairs"), i), questionnaire_.pairs[i], factor);
  }

  void check_pair_alike(const std::string& path, const Names& pair, const std::string& factor) {
    if (pair.size() != 2) return;
    const std::string first = level_of(manifest_, pair[0], factor);
    const std::string second = level_of(manifest_, pair[1], factor);
    if (first != second)
      list_.add(path,
                fmt::format("the stimuli have different levels of {}, which is among "
                            "preference.alike: {} and {}",
                            factor, motion::in_quotes(first), motion::in_quotes(second)),
                "list pairs that are alike, or omit the factor there");
  }

  void check_order() {
    for (std::size_t i = 0; i < questionnaire_.no_repeats.size(); ++i)
      check_factor(element_path(at("no_repeats"), i), questionnaire_.no_repeats[i]);
    const TrialOrder& order = questionnaire_.order;
    if (order.kind == TrialOrder::Kind::blocked) {
      check_factor(member_path(at("order"), "blocked"), order.factor);
      for (std::size_t i = 0; i < questionnaire_.no_repeats.size(); ++i) {
        if (questionnaire_.no_repeats[i] == order.factor)
          list_.add(element_path(at("no_repeats"), i),
                    "blocks contain only one level of this factor",
                    "omit it, or do not block by it");
      }
    }
    const bool is_given =
        order.kind == TrialOrder::Kind::fixed || order.kind == TrialOrder::Kind::latin;
    if (!questionnaire_.no_repeats.empty() && is_given) {
      list_.add_at_key(at("no_repeats"), "this order already determines the sequence",
                       "omit it, or use order: full");
    }
  }

  /// Reports too many pairs: no participant would rate them all, and they would not fit in memory.
  bool are_too_many_pairs() {
    constexpr std::size_t most_pairs = 5000;
    if (form_.stimuli == 1 || form_.has_places() || !questionnaire_.pairs.empty()) return false;
    const Names ids = questionnaire_stimuli(manifest_);
    std::map<Names, std::size_t> counts;
    for (const std::string& id : ids) {
      Names levels;
      for (const std::string& factor : questionnaire_.preference.alike)
        levels.push_back(level_of(manifest_, id, factor));
      ++counts[levels];
    }
    std::size_t pairs = 0;
    for (const auto& [levels, count] : counts) pairs += count * (count - 1) / 2;
    if (pairs <= most_pairs) return false;
    list_.add(at("trials"),
              fmt::format("the number of pairs of {} stimuli exceeds {}", ids.size(), most_pairs),
              "list the pairs to show: pairs: [[a, b], …]");
    return true;
  }

  void check_numbers() {
    if (are_too_many_pairs()) return;
    const std::size_t trials = questionnaire_subject_count(manifest_);
    if (trials == 0 && !ids_.empty() && !questionnaire_.preference.alike.empty())
      list_.add(member_path(at("preference"), "alike"),
                "no two stimuli have equal levels of these factors",
                "name factors whose levels several stimuli share");
    if (trials == 0 || ids_.empty()) return;
    const int all = static_cast<int>(trials);
    const int own =
        questionnaire_.per_participant == 0 ? all : std::min(questionnaire_.per_participant, all);
    const auto at_most = [&](const std::string& path, int number, int most) {
      if (number > most)
        list_.add(path, fmt::format("there are {} to choose from", most),
                  fmt::format("use at most {}", most));
    };
    at_most(at("per_participant"), questionnaire_.per_participant, all);
    at_most(at("warm_up"), questionnaire_.warm_up, all);
    at_most(member_path(at("retest"), "repeat"), questionnaire_.repeated, own);
  }

  /// Ids of questions about the participant: columns of one table.
  void check_question_ids() {
    std::set<std::string> taken;
    const auto check_all = [&](const std::string& list_path, const auto& questions) {
      for (std::size_t i = 0; i < questions.size(); ++i) {
        const std::string path = element_path(list_path, i);
        check_question_id(member_path(path, "id"), questions[i].id, taken, list_);
        check_answer_choices(member_path(path, "answer"), questions[i].answer.choices.words);
      }
    };
    if (!questionnaire_.consent_version.empty() && questionnaire_.consent.empty())
      list_.add_at_key(at("consent_version"), "there is no consent text",
                       "add consent: …, or remove it");
    check_all(member_path(at("screening"), "questions"), questionnaire_.screening.questions);
    check_all(at("demographics"), questionnaire_.demographics);
  }

  void check_answer_choices(const std::string& path, const Names& choices) {
    std::set<std::string> taken;
    for (std::size_t i = 0; i < choices.size(); ++i)
      if (!taken.insert(choices[i]).second)
        list_.add(element_path(path, i), motion::in_quotes(choices[i]) + " appears twice",
                  "name it once");
  }

  void check_display() {
    const DisplaySize::Kind size = questionnaire_.display.size.kind;
    for (const char* key : {"distance_cm", "blind_spot"}) {
      const std::string path = member_path(at("display"), key);
      if (list_.was_given(path) &&
          (size == DisplaySize::Kind::window || size == DisplaySize::Kind::native))
        list_.add_at_key(path, "is not needed for this size",
                         "add size: {degrees: 12}, or remove it");
    }
    const std::string measure = member_path(at("display"), "size");
    if (list_.was_given(member_path(measure, "cm")) &&
        list_.was_given(member_path(measure, "degrees")))
      list_.add_at_key(member_path(measure, "cm"), "cannot be combined with degrees",
                       "keep one of them");
    if (questionnaire_.view == ShownAs::turn && size != DisplaySize::Kind::window)
      list_.add(measure, "figures that can be turned have no fixed size",
                "remove it, or use view: video");
  }

  void check_view() {
    if (questionnaire_.view != ShownAs::turn || form_.is_continuous) return;
    for (const std::string& id : questionnaire_stimuli(manifest_)) {
      const auto found = std::ranges::find(manifest_.stimuli, id, &Stimulus::id);
      if (found == manifest_.stimuli.end()) continue;
      if (!can_people_be_turned(*found))
        return list_.add(at("view"),
                         "the figures of the people of " + motion::in_quotes(id) +
                             " cannot be turned in the browser",
                         "use view: video, or stick figures, mannequins or characters");
      if (!found->people.empty() || std::ranges::count(found->output.clips, "glb") > 0) continue;
      return list_.add(at("view"),
                       "the motion of " + motion::in_quotes(id) + " is not written in 3-D",
                       "add output: {clips: [bvh, glb]}");
    }
  }

  const Manifest& manifest_;
  const Questionnaire& questionnaire_;
  const TrialForm& form_;
  FaultList list_;
  Names ids_;
  Names factors_;
};

}  // namespace

std::vector<Fault> check_questionnaire(const Manifest& manifest) {
  if (!manifest.questionnaire) return {};
  std::vector<Fault> faults = QuestionnaireCheck(manifest).faults();
  append(faults, check_trial_form(manifest));
  append(faults, check_grid(manifest));
  append(faults, check_continuous(manifest));
  append(faults, check_adaptive_trials(manifest));
  append(faults, check_shown_videos(manifest));
  append(faults, check_heard_sounds(manifest));
  append(faults, check_recruitment(manifest));
  append(faults, check_screening(manifest));
  append(faults, check_factorial(manifest));
  append(faults, check_quality(manifest));
  return faults;
}

}  // namespace mien::pipeline

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "motion/text/excerpt.h"
#include "pipeline/base/documents/fault_list.h"
#include "pipeline/manifest/checks/part_checks.h"
#include "pipeline/manifest/questionnaire_content.h"
#include "pipeline/manifest/questionnaire_grid.h"

namespace mien::pipeline {

namespace {

/// Checks the sets of stimuli of grid trials, and keys of the questionnaire that do not suit them.
class GridCheck {
 public:
  explicit GridCheck(const Manifest& manifest)
      : manifest_(manifest), asked_(*manifest.questionnaire), list_(manifest.places) {}

  std::vector<Fault> faults() {
    check_scale();
    check_answer();
    if (has_sets() && are_names_known()) {
      const std::vector<GridSet> sets = grid_sets(manifest_);
      for (std::size_t i = 0; i < sets.size(); ++i) check_set(path_of_set(i), sets[i]);
      for (const GridSet& set : practice_grid_sets(manifest_))
        check_set("questionnaire.practice", set);
      check_anchors(sets);
    }
    return list_.take();
  }

 private:
  static std::string at(const char* key) { return member_path("questionnaire.grid", key); }

  std::string path_of_set(std::size_t index) const {
    return asked_.grid.sets.empty() ? at("alike") : element_path(at("sets"), index);
  }

  void check_scale() {
    const std::size_t count = questionnaire_scales(manifest_).scales.size();
    if (count > 1)
      list_.add("questionnaire.scales",
                fmt::format("grid trials ask one scale, and these are {}", count),
                "keep one of them; for several scales, make a study of each");
  }

  void check_answer() {
    for (const char* key : {"points", "words", "suggest", "anchors", "default", "side"}) {
      const std::string path = member_path("questionnaire.answer", key);
      if (list_.was_given(path))
        list_.add_at_key(path, "grid trials are answered on sliders from 0 to 100", "omit it");
    }
    if (asked_.replays.most)
      list_.add_at_key("questionnaire.replays", "the videos of a grid are played at will",
                       "omit it");
    if (asked_.view == ShownAs::turn)
      list_.add("questionnaire.view", "grid trials show videos", "omit it");
  }

  /// Whether it is known which stimuli are sets; reports why not.
  bool has_sets() {
    const bool are_listed = list_.was_given(at("sets"));
    if (are_listed && list_.was_given(at("alike"))) {
      list_.add_at_key(at("alike"), "the sets are listed", "omit it, or omit sets");
      return false;
    }
    if (!are_listed && asked_.grid.alike.empty()) {
      list_.add("questionnaire", "grid trials need sets of stimuli",
                "add grid: {alike: [content]}, or list them: grid: {sets: [[a, b], [c, d]]}");
      return false;
    }
    if (are_listed && list_.was_given("questionnaire.stimuli")) {
      list_.add_at_key("questionnaire.stimuli", "the sets of the grid are listed", "omit it");
      return false;
    }
    return true;
  }

  /// Unknown names are reported; nothing else then, as a consequence.
  bool are_names_known() {
    std::vector<std::string> ids;
    for (const Stimulus& stimulus : manifest_.stimuli) ids.push_back(stimulus.id);
    const std::vector<std::string> factors = factors_of(manifest_);
    bool has_unknown = false;
    const auto check = [&](const std::string& path, const std::string& name, const char* what,
                           const std::vector<std::string>& known) {
      has_unknown |= std::ranges::find(known, name) == known.end();
      list_.check_known_name(path, name, what, known);
    };
    for (std::size_t i = 0; i < asked_.grid.alike.size(); ++i) {
      if (factors.empty()) {
        list_.add(at("alike"), "the stimuli have no factors",
                  "add factors: {content: …} to the stimuli");
        return false;
      }
      check(element_path(at("alike"), i), asked_.grid.alike[i], "factor", factors);
    }
    std::set<std::string> taken;
    for (std::size_t i = 0; i < asked_.grid.sets.size(); ++i) {
      for (std::size_t k = 0; k < asked_.grid.sets[i].size(); ++k) {
        const std::string& id = asked_.grid.sets[i][k];
        const std::string path = element_path(path_of_set(i), k);
        check(path, id, "stimulus", ids);
        if (!taken.insert(id).second)
          list_.add(path, motion::in_quotes(id) + " appears twice in the sets", "name it once");
      }
    }
    return !has_unknown;
  }

  void check_set(const std::string& path, const GridSet& set) {
    const std::size_t count = set.stimuli.size();
    if (count < least_grid_stimuli || count > most_grid_stimuli)
      list_.add(path,
                count < least_grid_stimuli
                    ? fmt::format("the set of {} has no other stimulus",
                                  motion::in_quotes(set.stimuli.front()))
                    : fmt::format("the set of {} has {} stimuli",
                                  motion::in_quotes(set.stimuli.front()), count),
                fmt::format("a set has {} to {}", least_grid_stimuli, most_grid_stimuli));
    check_role(path, set, "reference", asked_.grid.reference, 1);
    check_role(path, set, "anchor", asked_.grid.anchor, 0);
    if (!set.reference.empty() && set.reference == set.anchor)
      list_.add(at("anchor"), motion::in_quotes(set.anchor) + " is the reference, too",
                "name another stimulus");
  }

  /// Whether the stimuli and levels exist; others are reported elsewhere.
  bool is_known(const StimulusChoice& choice) const {
    const auto is_of_any = [&](auto is_it) {
      return std::ranges::any_of(manifest_.stimuli, is_it);
    };
    const bool are_ids_known = std::ranges::all_of(choice.ids, [&](const std::string& id) {
      return is_of_any([&](const Stimulus& one) { return one.id == id; });
    });
    return are_ids_known && std::ranges::all_of(choice.levels, [&](const auto& wanted) {
             return std::ranges::all_of(wanted.second, [&](const std::string& level) {
               return is_of_any(
                   [&](const Stimulus& one) { return level_of(one, wanted.first) == level; });
             });
           });
  }

  /// A set has one reference, and at most one anchor.
  void check_role(const std::string& path, const GridSet& set, const char* role,
                  const StimulusChoice& choice, std::size_t least) {
    if (!is_stated(choice) || !is_known(choice)) return;
    const std::size_t count = chosen_among(manifest_, set.stimuli, choice).size();
    if (count >= least && count <= 1) return;
    list_.add(path,
              count == 0 ? fmt::format("the set of {} has no {}",
                                       motion::in_quotes(set.stimuli.front()), role)
                         : fmt::format("the set of {} has {} {}s",
                                       motion::in_quotes(set.stimuli.front()), count, role),
              fmt::format("name one of each set in grid.{}", role));
  }

  void check_anchors(const std::vector<GridSet>& sets) {
    const auto has_anchor = [](const GridSet& set) { return !set.anchor.empty(); };
    if (is_stated(asked_.grid.anchor) && is_known(asked_.grid.anchor) &&
        std::ranges::none_of(sets, has_anchor))
      list_.add(at("anchor"), "no set has an anchor", "name stimuli of the sets, or omit it");
  }

  const Manifest& manifest_;
  const Questionnaire& asked_;
  FaultList list_;
};

}  // namespace

std::vector<Fault> check_grid(const Manifest& manifest) {
  if (!manifest.questionnaire || !manifest.questionnaire->trials->is_grid) return {};
  return GridCheck(manifest).faults();
}

}  // namespace mien::pipeline

#include <algorithm>
#include <set>
#include <string>
#include <variant>

#include "motion/text/excerpt.h"
#include "pipeline/base/documents/fault_list.h"
#include "pipeline/manifest/checks/part_checks.h"
#include "pipeline/manifest/people.h"
#include "scenes/figures/figure.h"
#include "scenes/figures/figure_colour.h"
#include "scenes/point_light/dot_joints.h"

namespace mien::pipeline {

namespace {

class PeopleChecker : public FaultList {
 public:
  using FaultList::FaultList;

  void check(const Stimulus& stimulus) {
    if (stimulus.people.empty()) {
      if (!stimulus.swap.empty())
        add_at_key(member_path(stimulus.path, "swap"), "there are no people to take motions",
                   "omit it, or give people");
      return;
    }
    check_own_keys(stimulus);
    check_names(stimulus);
    check_places(stimulus);
    check_figures(stimulus);
  }

 private:
  void check_own_keys(const Stimulus& stimulus) {
    for (const char* key : {"modify", "hold"}) {
      const std::string path = member_path(stimulus.path, key);
      if (was_given(path))
        add_at_key(path, "a stimulus with people has no motion of its own",
                   "give it to one of the people");
    }
  }

  void check_names(const Stimulus& stimulus) {
    std::set<std::string> names;
    for (const Person& person : stimulus.people) {
      if (names.insert(person.name).second) continue;
      add(member_path(person.motion.path, "name"),
          motion::in_quotes(person.name) + " is already the name of another person",
          "give each a different one");
    }
  }

  /// What a person's motion comes from has its own place, or needs one.
  void check_places(const Stimulus& stimulus) {
    const bool is_captured_space = keeps_captured_space(stimulus);
    for (const Person& person : stimulus.people) {
      if (person.place || person.motion.walk) continue;
      if (person.motion.clip && is_captured_space) continue;
      const std::string name = motion::in_quotes(person.name);
      if (person.motion.clip) {
        add(person.motion.path,
            name +
                " has no place, but another person from a file has one, so that it is open "
                "where the two are relative to each other",
            "give both a place: {x, z, turn}, or neither, which keeps where they were recorded");
      } else {
        add(person.motion.path, name + " has no place on the stage",
            "add place: {x: 0.6, turn: 0}, in metres from the stage's middle and degrees");
      }
    }
  }

  void check_figures(const Stimulus& stimulus) {
    const std::string own = member_path(stimulus.path, "look.figure");
    const std::string path = was_given(own) ? own : stimulus.path;
    const bool has_dots = scenes::kind_of(stimulus.look.figure).has_dots;
    if (std::holds_alternative<scenes::TrailOptions>(stimulus.look.figure))
      add(path, "a trail shows one motion only", "give the stimulus look: {figure: stick}");
    if (stimulus.look.set.in_place)
      add(path, "the ground of this set moves with one walker only",
          "choose another scene, such as studio, and output: {in_place: true}");
    const auto* dots = std::get_if<scenes::PointLightOptions>(&stimulus.look.figure);
    for (const Person& person : stimulus.people) {
      const std::string look = member_path(person.motion.path, "look");
      if (has_dots && person.figure)
        add(member_path(look, "figure"), "bodies and dots are not shown together",
            "omit it, or give the stimulus a figure with a surface");
      if (dots != nullptr && person.hands == scenes::Hands::hidden &&
          scenes::has_dots_on_fingers(*dots))
        add(member_path(look, "hands"), "hidden hands have no fingers for dots",
            "omit it, or the fingers of the dots");
    }
  }
};

}  // namespace

std::vector<Fault> check_people(const Manifest& manifest) {
  PeopleChecker checker(manifest.places);
  for (const Stimulus& stimulus : manifest.stimuli) checker.check(stimulus);
  return checker.take();
}

}  // namespace mien::pipeline

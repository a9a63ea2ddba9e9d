#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "motion/skeleton/recorded_hands.h"
#include "pipeline/base/reading/field_writer.h"
#include "pipeline/manifest/people.h"
#include "pipeline/production/methods/methods_parts.h"
#include "pipeline/production/methods/prose.h"
#include "pipeline/production/methods/stated_settings.h"

namespace mien::pipeline {

namespace {

const WritingOptions recipe_writing{.for_key = true};  // files by their names

/// What the steps with an emotion do at a strength of 1: its recipe, with what was set by hand.
void describe_recipes(const Names& emotions, MethodsText& out) {
  static const std::vector<FieldEntry> usual = entries_of(motion::Modification{}, recipe_writing);
  Names recipes;
  for (const std::string& emotion : emotions) {
    StatedSettings what;
    for (const Stimulus* source : motion_sources(out.manifest)) {
      const Stimulus& stimulus = *source;
      for (const ModificationStep& step : stimulus.modify) {
        if (step.emotion != emotion) continue;
        for (const FieldEntry& entry :
             differences(entries_of(step.modification, recipe_writing), usual)) {
          if (entry.path != "seed") what.add("modify." + entry.path, entry.value, emotion);
        }
        if (step.pose) what.add("modify.pose", written(*step.pose, recipe_writing), emotion);
      }
    }
    recipes.push_back("for " + emotion + ": " +
                      (what.empty() ? "no change" : what.text({emotion})));
  }
  if (!recipes.empty())
    out.say(fmt::format("Changes at a strength of 1 were, {}", fmt::join(recipes, "; ")));
}

std::string modification_sources(MethodsText& out) {
  return out.cite({"emotionthesis2010", "bruderlin1995"});
}

std::string recipe_book(MethodsText& out) {
  if (!out.manifest.recipes.file.empty()) return out.manifest.recipes.file.filename().string();
  if (out.manifest.recipes.name == "fig29")
    return "figure 29 of the emotion thesis, with mien's numbers";
  if (out.manifest.recipes.name == "builtin@0.2")
    return "those of mien 0.2, after the emotion thesis";
  return out.manifest.recipes.name == "builtin@0.3" ? "those of mien 0.3, fitted to acted motions"
                                                    : "mien's own, fitted to acted motions";
}

/// Whether a step changes how a motion is made, beyond parts that are frozen or placed and ends.
bool has_modification(const ModificationStep& step) {
  return !step.emotion.empty() || step.style || step.edit.pose || !step.edit.named.empty();
}

/// What was set by hand; fingers are scaled only where there are any.
OrderedJson settings_by_hand(const ModificationStep& step, const motion::Clip& made) {
  OrderedJson settings = EditForm::write(step.edit, recipe_writing);
  if (!motion::has_fingers(made)) settings.erase("hands");
  return settings;
}

void describe_steps(MethodsText& out) {
  std::size_t modified = 0, reduced = 0;
  double least_share = 1.0;
  Names emotions, styles, changed;
  StatedSettings by_hand;
  Range strengths;
  for (const Stimulus* source : motion_sources(out.manifest)) {
    const Stimulus& stimulus = *source;
    if (std::ranges::none_of(stimulus.modify, has_modification)) continue;
    ++modified;
    changed.push_back(stimulus.id);
    const double share = out.motions.of(stimulus.id).modified_share;
    reduced += share < 1.0 ? 1 : 0;
    least_share = std::min(least_share, share);
    for (const ModificationStep& step : stimulus.modify) {
      if (!step.emotion.empty()) {
        add_once(emotions, step.emotion);
        strengths.add(step.strength);
      }
      if (step.style) add_once(styles, source_of(step.style->method));
      by_hand.add("modify", settings_by_hand(step, out.motions.of(stimulus.id).motion.clip),
                  stimulus.id);
      if (step.style)
        by_hand.add("style", StyleForm::write(step.style, recipe_writing), stimulus.id);
    }
  }
  if (modified == 0) return;
  out.say(count_of(modified, "stimulus was", "stimuli were") + " modified" +
          modification_sources(out));
  if (!emotions.empty()) {
    out.say(fmt::format("The {} ({}) {} {}, at a strength of {}",
                        emotions.size() == 1 ? "recipe used" : "recipes used", recipe_book(out),
                        emotions.size() == 1 ? "was" : "were", listed(emotions),
                        range_text(strengths, 2, "")));
  }
  describe_recipes(emotions, out);
  if (!by_hand.empty()) out.say("Manual changes: " + by_hand.text(changed));
  if (!styles.empty()) {
    out.say("Style differences were transferred from pairs of examples by published methods" +
            out.cite(styles));
  }
  if (reduced > 0) {
    out.say(
        fmt::format("In {}, the modification was reduced until the motion was free of faults "
                    "(lowest: {:.0f} % of the requested strength)",
                    count_of(reduced, "stimulus", "stimuli"), 100.0 * least_share));
  }
}

/// "the legs, head and left arm"
std::string parts_text(const motion::Freezing& freeze) {
  Names parts;
  for (const motion::FrozenPart part : freeze.parts) {
    std::string name(word_of(frozen_words, part));
    std::ranges::replace(name, '-', ' ');
    parts.push_back(std::move(name));
  }
  return "the " + listed(parts);
}

/// What became of the ends of a motion.
std::string ends_text(const motion::MotionEnds& ends) {
  if (ends.loops)
    return "the motion was shown as a loop; if it did not loop, the difference between its last "
           "and "
           "first pose was distributed over it";
  Names held;
  if (ends.hold_before > 0.0)
    held.push_back(fmt::format("the first pose was held for {:g} s", ends.hold_before));
  if (ends.hold_after > 0.0)
    held.push_back(fmt::format("the last pose was held for {:g} s", ends.hold_after));
  return listed(held);
}

/// What holds for some stimuli, and their ids.
using Cases = std::vector<std::pair<std::string, Names>>;

void add_case(Cases& cases, const std::string& what, const std::string& id) {
  const auto known = std::ranges::find(cases, what, &Cases::value_type::first);
  if (known == cases.end())
    cases.push_back({what, {id}});
  else
    known->second.push_back(id);
}

/// "In one stimulus (wave), the last pose was held for 1 s"
void say_cases(const Cases& cases, MethodsText& out) {
  for (const auto& [what, ids] : cases)
    out.say(fmt::format("In {} ({}), {}", count_of(ids.size(), "stimulus", "stimuli"), listed(ids),
                        what));
}

void describe_animation(MethodsText& out) {
  std::size_t keyed = 0, constrained = 0;
  Cases frozen, ends;
  for (const Stimulus* source : motion_sources(out.manifest)) {
    const Stimulus& stimulus = *source;
    if (stimulus.modify.empty()) continue;
    const ModificationStep& last = stimulus.modify.back();
    if (!last.freeze.parts.empty())
      add_case(frozen,
               parts_text(last.freeze) + " did not move, in the pose of " +
                   (last.freeze.at ? "one moment" : "a typical moment"),
               stimulus.id);
    if (!last.ends.is_empty()) add_case(ends, ends_text(last.ends), stimulus.id);
    keyed += stimulus.modify.back().keys.empty() ? 0 : 1;
    constrained += stimulus.modify.back().constraints.empty() ? 0 : 1;
  }
  say_cases(frozen, out);
  if (keyed > 0) {
    out.say("In " + count_of(keyed, "stimulus", "stimuli") +
            ", hands, feet, pelvis or gaze were placed at certain moments, by smooth displacement "
            "of the motion" +
            out.cite({"witkin1995", "bruderlin1995"}));
  }
  if (constrained > 0) {
    out.say("In " + count_of(constrained, "stimulus", "stimuli") +
            ", parts of the body fulfilled conditions between two moments" +
            out.cite({"gleicher1998"}));
  }
  say_cases(ends, out);
}

void describe_foils(MethodsText& out) {
  std::size_t foils = 0;
  Names aspects;
  for (const Stimulus& stimulus : out.manifest.stimuli) {
    if (!stimulus.foil) continue;
    ++foils;
    add_once(aspects, std::string(name_of(stimulus.foil->differ)));
  }
  if (foils == 0) return;
  out.say(count_of(foils, "stimulus is a foil", "stimuli are foils") +
          ": modified like another stimulus except for its change of " + listed(aspects) +
          "; remaining differences were measured (metrics/foils.csv)");
}

}  // namespace

void describe_modifications(MethodsText& out) {
  describe_steps(out);
  describe_animation(out);
  describe_foils(out);
}

}  // namespace mien::pipeline

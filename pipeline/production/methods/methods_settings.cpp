#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "pipeline/base/reading/field_writer.h"
#include "pipeline/manifest/look/look_fields.h"
#include "pipeline/manifest/look/point_form.h"
#include "pipeline/manifest/look/set_fields.h"
#include "pipeline/manifest/people.h"
#include "pipeline/manifest/quality_rules.h"
#include "pipeline/manifest/reported_analyses.h"
#include "pipeline/production/film/film_dots.h"
#include "pipeline/production/film/film_shot.h"
#include "pipeline/production/methods/methods_parts.h"
#include "pipeline/production/methods/prose.h"
#include "pipeline/production/methods/stated_settings.h"
#include "pipeline/production/methods/study_facts.h"

namespace mien::pipeline {

namespace {

const WritingOptions by_names{.for_key = true};  // files by their names

/// What other sentences say of all films.
bool is_stated_for_all(const FieldEntry& entry) {
  constexpr std::array<std::string_view, 9> paths = {"look.scene",
                                                     "look.figure",
                                                     "look.camera",
                                                     "output.size",
                                                     "output.fps",
                                                     "output.video",
                                                     "interpolation.method",
                                                     "interpolation.rotations",
                                                     "interpolation.time_warp"};
  return !entry.value.is_object() && std::ranges::count(paths, std::string_view(entry.path)) > 0;
}

/// The same within a map: which set it is, from where it is seen, and a figure without options.
OrderedJson without_stated(OrderedJson value) {
  if (!value.is_object()) return value;
  OrderedJson rest = OrderedJson::object();
  for (const auto& [key, one] : value.items()) {
    const bool is_bare = one.is_null() || (one.is_object() && one.empty());
    if (key != "set" && key != "view" && !is_bare) rest[key] = one;
  }
  return rest;
}

template <class Value>
void add_differences(const std::string& prefix, const Value& value, const std::string& of,
                     StatedSettings& settings) {
  static const std::vector<FieldEntry> usual = entries_of(Value{}, by_names);
  for (FieldEntry entry : differences(entries_of(value, by_names), usual)) {
    entry.path = prefix + entry.path;
    if (!is_stated_for_all(entry)) settings.add(entry.path, without_stated(entry.value), of);
  }
}

void add_set(const Stimulus& stimulus, StatedSettings& settings) {
  static const std::vector<FieldEntry> usual = entries_of(scenes::SetPlan{}, by_names);
  if (stimulus.look.scene_file.empty()) return;
  for (const FieldEntry& entry : differences(entries_of(stimulus.look.set, by_names), usual)) {
    if (entry.concerns != concerns::nothing)
      settings.add("look.set." + entry.path, entry.value, stimulus.id);
  }
}

/// What one of several people has instead of the stimulus's figure, face and hands.
void add_person(const Stimulus& stimulus, const Person& person, StatedSettings& settings) {
  Look own;
  if (person.figure) own.figure = *person.figure;
  if (person.face) own.face = *person.face;
  own.hands = person.hands.value_or(own.hands);
  add_differences("look.", own, person.motion.id, settings);
  const scenes::Figure shown = look_of_person(stimulus, person).figure;
  if (person.face && person.face->is_neutral() && scenes::file_of(shown) != nullptr)
    settings.add("look.face", "neutral", person.motion.id);
  if (person.hands == scenes::Hands::automatic && stimulus.look.hands != scenes::Hands::automatic)
    settings.add("look.hands", "auto", person.motion.id);
}

std::string size_of(const scenes::PointLightOptions& dots) {
  return dots.size_m ? fmt::format("{:g} m", *dots.size_m)
                     : fmt::format("{:g} pixels", dots.size_px);
}

/// "13 dots of 8 pixels": those of noise and masks are stated separately.
std::string dots_of(const Stimulus& stimulus, Motions& motions, std::uint64_t seed) {
  const auto& options = std::get<scenes::PointLightOptions>(stimulus.look.figure);
  const std::size_t all = shot_of(stimulus, motions, seed).actors.front().dots.size();
  const std::size_t others =
      static_cast<std::size_t>(options.noise) + static_cast<std::size_t>(options.mask);
  const std::size_t own = all > others ? all - others : all;
  return fmt::format("{} of {}", count_of(own, "dot", "dots"), size_of(options));
}

/// "39 of 41 markers, dark in 2.1 % of their frames, as dots of 8 pixels joined by sticks"
std::string markers_of(const Stimulus& stimulus, Motions& motions) {
  const auto& options = std::get<scenes::MarkersOptions>(stimulus.look.figure);
  const bool has_sticks = !options.pairs.empty() && options.dots.lifetime == 0;
  return fmt::format("{}, as dots of {}{}", marker_facts(stimulus, motions), size_of(options.dots),
                     has_sticks ? " joined by sticks" : "");
}

void describe_dots(MethodsText& out) {
  Names dots, markers;
  for (const Stimulus& stimulus : out.manifest.stimuli) {
    if (std::holds_alternative<scenes::PointLightOptions>(stimulus.look.figure))
      add_once(dots, dots_of(stimulus, out.motions, out.manifest.seed));
    if (std::holds_alternative<scenes::MarkersOptions>(stimulus.look.figure))
      add_once(markers, markers_of(stimulus, out.motions));
  }
  if (!dots.empty())
    out.say("Point-light figures have " + fmt::format("{}", fmt::join(dots, " or ")));
  if (!markers.empty())
    out.say("Figures of markers show " + fmt::format("{}", fmt::join(markers, "; or ")));
}

}  // namespace

void describe_settings(MethodsText& out) {
  describe_dots(out);
  StatedSettings settings;
  Names everybody;
  const auto add_settings_of = [&](const Stimulus& film) {
    everybody.push_back(film.id);
    add_differences("look.", film.look, film.id, settings);
    add_set(film, settings);
    add_differences("output.", film.output, film.id, settings);
  };
  for (Stimulus stimulus : out.manifest.stimuli) {
    // Motions that do not loop are not repeated.
    const auto loops = [&](const Stimulus* motion) {
      return out.motions.of(motion->id).motion.clip.loops;
    };
    if (std::ranges::none_of(motions_in(stimulus), loops)) stimulus.output.cycles = Output{}.cycles;
    add_settings_of(stimulus);
    for (const Person& person : stimulus.people) add_person(stimulus, person, settings);
  }
  for (const Overlay& overlay : out.manifest.overlays) {
    Stimulus film = overlay.film;
    film.look.colours = Colours::neutral;  // which it does not go by
    add_settings_of(film);
  }
  for (const Stimulus* motion : motion_sources(out.manifest)) {
    if (is_blend(*motion))
      add_differences("interpolation.", motion->interpolation, motion->id, settings);
  }
  if (!settings.empty())
    out.say("Settings that differ from the defaults: " + settings.text(everybody));
}

void describe_example_settings(MethodsText& out) {
  if (!out.manifest.examples.builtin.empty()) return;
  StatedSettings settings;
  add_differences("examples.", out.manifest.examples, "", settings);
  if (!settings.empty())
    out.say("The examples were extracted with these settings: " + settings.text({""}));
}

void describe_matching_settings(MethodsText& out) {
  if (!out.manifest.matching) return;
  const Matching& matching = *out.manifest.matching;
  if (matching.order == MatchingOrder::guesses_first)
    out.say(
        "In the matching experiment, participants first made an initial guess at each target with "
        "every interface, without feedback, and then matched the target with every interface, "
        "each time starting from the guess made with that interface");
  if (matching.shows_examples)
    out.say(
        "The examples were played beside the matching task, one after another, with their names");
}

void describe_factorial_plan(MethodsText& out) {
  if (!out.manifest.questionnaire) return;
  const std::string sentence = factorial_sentence(out.manifest.questionnaire->analysis.factorial,
                                                  analysed_answers(out.manifest));
  if (!sentence.empty()) out.say(sentence);
  for (const std::string& also : reported_analyses(out.manifest, ReportTense::past)) out.say(also);
}

void describe_quality_rules(MethodsText& out) {
  if (!out.manifest.questionnaire) return;
  const Questionnaire& asked = *out.manifest.questionnaire;
  for (const std::string& sentence :
       {quality_sentence(asked.analysis.quality), post_screening_sentence(asked)})
    if (!sentence.empty()) out.say(sentence);
}

}  // namespace mien::pipeline

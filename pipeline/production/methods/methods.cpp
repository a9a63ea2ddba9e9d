#include "pipeline/production/methods/methods.h"

#include <fmt/format.h>

#include "pipeline/manifest/people.h"
#include "pipeline/production/methods/methods_parts.h"
#include "pipeline/production/methods/prose.h"
#include "pipeline/production/methods/references.h"
#include "pipeline/production/methods/study_facts.h"
#include "pipeline/tasks/code_identity.h"

namespace mien::pipeline {

namespace {

void describe_program(MethodsText& out) {
  if (out.manifest.stimuli.empty())
    return out.say(fmt::format("Motions were made with mien {} [@mien] (random seed {})",
                               program_version(), out.manifest.seed));
  out.say(fmt::format("The {} made with mien {} [@mien] (random seed {})",
                      count_of(out.manifest.stimuli.size(), "stimulus was", "stimuli were"),
                      program_version(), out.manifest.seed));
}

/// "speed (fast, slow)"; empty unless there are two levels.
std::string factor_text(const Manifest& manifest, const std::string& factor) {
  Names levels;
  for (const Stimulus& stimulus : manifest.stimuli) {
    const std::string level = level_of(stimulus, factor);
    if (!level.empty()) add_once(levels, level);
  }
  if (levels.size() < 2) return "";
  return levels.size() > 12 ? fmt::format("{} ({} levels)", factor, levels.size())
                            : fmt::format("{} ({})", factor, fmt::join(levels, ", "));
}

/// The factors of the design: what describes a single motion, such as its example, is none.
void describe_design(MethodsText& out) {
  Names factors;
  for (const std::string& factor : studied_factors(out.manifest))
    if (const std::string text = factor_text(out.manifest, factor); !text.empty())
      factors.push_back(text);
  if (!factors.empty()) {
    out.say(fmt::format("{} {}", factors.size() == 1 ? "The factor was" : "The factors were",
                        listed(factors)));
  }
}

/// What the participants of a questionnaire see and do.
void describe_questionnaire(MethodsText& out) {
  out.begin_section("Participants");
  describe_participants(out);
  out.begin_section("Procedure");
  describe_trials(out);
  out.begin_section("Analysis");
  describe_tests(out);
  describe_factorial_plan(out);
  describe_quality_rules(out);
  describe_stated_plan(out);
}

void describe_files(MethodsText& out) {
  const auto files = stimuli_from(out.manifest, "clip");
  if (files.empty()) return;
  out.say(count_of(files.size(), "stimulus shows", "stimuli show") + " recorded motion");
}

/// Stimuli with several people. Where a motion is that of a person, the other sentences count it as
/// a stimulus.
void describe_people(MethodsText& out) {
  std::size_t films = 0, people = 0, swapped = 0, recorded = 0;
  for (const Stimulus& stimulus : out.manifest.stimuli) {
    if (stimulus.people.empty()) continue;
    ++films;
    recorded += keeps_captured_space(stimulus) ? 1 : 0;
    for (const Person& person : stimulus.people) {
      ++people;
      swapped += person.stated ? 1 : 0;
    }
  }
  if (films == 0) return;
  out.say(
      fmt::format("{} several people ({} in all; each of their motions counts as a "
                  "stimulus in the following)",
                  count_of(films, "stimulus shows", "stimuli show"), people));
  if (recorded > 0)
    out.say("In " + count_of(recorded, "of these", "of these") +
            ", recorded people kept their positions relative to each other");
  if (swapped > 0)
    out.say(count_of(swapped, "person had", "people had") + " the motion of another stimulus");
}

}  // namespace

Methods procedure_of(const Manifest& manifest) {
  Motions motions(manifest);
  MethodsText out(manifest, motions);
  describe_questionnaire(out);
  const std::string text = out.text();
  return {text.substr(text.find("# Participants")) + "\n", bibtex_of(out.cited())};
}

Methods methods_of(const Manifest& manifest, Motions& motions) {
  MethodsText out(manifest, motions);
  describe_program(out);
  describe_design(out);
  if (uses_examples(manifest) || manifest.adaptive) describe_examples(out);
  describe_blends(out);
  describe_files(out);
  describe_people(out);
  describe_paths(out);
  describe_recordings(out);
  describe_modifications(out);
  describe_matching_settings(out);
  describe_adaptive(out);
  out.end_paragraph();
  if (!manifest.stimuli.empty()) describe_pictures(out);
  out.end_paragraph();
  if (manifest.questionnaire) describe_questionnaire(out);
  out.end_paragraph();
  std::string text = out.text();
  text.pop_back();  // one line end is enough
  return {text, bibtex_of(out.cited())};
}

}  // namespace mien::pipeline

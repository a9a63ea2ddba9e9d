#include "pipeline/production/methods/methods.h"

#include <fmt/format.h>

#include "pipeline/production/methods/methods_parts.h"
#include "pipeline/production/methods/prose.h"
#include "pipeline/production/methods/references.h"
#include "pipeline/production/methods/study_facts.h"
#include "pipeline/tasks/code_identity.h"

namespace mien::pipeline {

namespace {

void describe_program(MethodsText& out) {
  out.say(fmt::format("The {} made with mien {} [@mien] (random seed {})",
                      count_of(out.manifest.stimuli.size(), "stimulus was", "stimuli were"),
                      program_version(), out.manifest.seed));
}

void describe_design(MethodsText& out) {
  Names factors;
  for (const std::string& factor : factors_of(out.manifest)) {
    Names levels;
    for (const Stimulus& stimulus : out.manifest.stimuli) {
      const std::string level = level_of(stimulus, factor);
      if (!level.empty()) add_once(levels, level);
    }
    factors.push_back(levels.size() > 12 ? fmt::format("{} ({} levels)", factor, levels.size())
                                         : fmt::format("{} ({})", factor, fmt::join(levels, ", ")));
  }
  if (!factors.empty()) {
    out.say(fmt::format("{} {}", factors.size() == 1 ? "The factor was" : "The factors were",
                        listed(factors)));
  }
}

void describe_files(MethodsText& out) {
  const auto files = stimuli_from(out.manifest, "clip");
  if (files.empty()) return;
  out.say(count_of(files.size(), "stimulus shows", "stimuli show") + " recorded motion");
}

void describe_paths(MethodsText& out) {
  const auto paths = stimuli_from(out.manifest, "path");
  if (paths.empty()) return;
  out.say(count_of(paths.size(), "stimulus was", "stimuli were") +
          " synthesized along a path by a parametric walker that plans each step, without recorded "
          "motion");
}

}  // namespace

Methods methods_of(const Manifest& manifest, Motions& motions) {
  MethodsText out(manifest, motions);
  describe_program(out);
  describe_design(out);
  if (uses_examples(manifest)) describe_examples(out);
  describe_blends(out);
  describe_files(out);
  describe_paths(out);
  describe_recordings(out);
  describe_modifications(out);
  describe_matching_settings(out);
  out.end_paragraph();
  describe_pictures(out);
  out.end_paragraph();
  describe_factorial_plan(out);
  describe_quality_rules(out);
  out.end_paragraph();
  std::string text = out.text();
  text.pop_back();  // one line end is enough
  return {text, bibtex_of(out.cited())};
}

}  // namespace mien::pipeline

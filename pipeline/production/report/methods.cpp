#include "pipeline/production/report/methods.h"

#include <fmt/format.h>

#include "pipeline/production/report/methods_blends.h"
#include "pipeline/production/report/methods_examples.h"
#include "pipeline/production/report/methods_modifications.h"
#include "pipeline/production/report/methods_pictures.h"
#include "pipeline/production/report/methods_settings.h"
#include "pipeline/production/report/prose.h"
#include "pipeline/production/report/references.h"
#include "pipeline/production/report/study_facts.h"
#include "pipeline/tasks/code_identity.h"

namespace mien::pipeline {

namespace {

void tell_program(const Manifest& manifest, MethodsText& out) {
  out.say(fmt::format("The {} made with mien {} [@mien] (random seed {})",
                      count_of(manifest.stimuli.size(), "stimulus was", "stimuli were"),
                      program_version(), manifest.seed));
}

void tell_design(const Manifest& manifest, MethodsText& out) {
  Names factors;
  for (const std::string& factor : factors_of(manifest)) {
    Names levels;
    for (const Stimulus& stimulus : manifest.stimuli) {
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

void tell_files(const Manifest& manifest, MethodsText& out) {
  const auto files = stimuli_from(manifest, "clip");
  if (files.empty()) return;
  out.say(count_of(files.size(), "stimulus shows", "stimuli show") + " recorded motion");
}

void tell_paths(const Manifest& manifest, MethodsText& out) {
  const auto paths = stimuli_from(manifest, "path");
  if (paths.empty()) return;
  out.say(count_of(paths.size(), "stimulus was", "stimuli were") +
          " walked along a path by a parametric walker that plans each step as it goes, and is no "
          "recorded motion");
}

}  // namespace

Methods methods_of(const Manifest& manifest, Motions& motions) {
  MethodsText out;
  tell_program(manifest, out);
  tell_design(manifest, out);
  if (uses_examples(manifest)) tell_examples(manifest, motions, out);
  tell_blends(manifest, motions, out);
  tell_files(manifest, out);
  tell_paths(manifest, out);
  tell_modifications(manifest, motions, out);
  tell_matching_settings(manifest, out);
  out.end_paragraph();
  tell_pictures(manifest, motions, out);
  out.end_paragraph();
  std::string text = out.text();
  text.pop_back();  // one line end is enough
  return {text, bibtex_of(out.cited())};
}

}  // namespace mien::pipeline

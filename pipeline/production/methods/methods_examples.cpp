#include <algorithm>
#include <set>
#include <string>

#include <fmt/format.h>

#include "motion/text/excerpt.h"
#include "pipeline/production/methods/methods_parts.h"
#include "pipeline/production/methods/prose.h"
#include "pipeline/production/methods/study_facts.h"

namespace mien::pipeline {

namespace {

/// Number of examples that stimuli with given weights use; 0 if others depend on all examples.
std::size_t used_examples(const MethodsText& out) {
  if (!stimuli_from(out.manifest, "adjectives").empty() ||
      !stimuli_from(out.manifest, "features").empty())
    return 0;
  std::set<std::string> used;
  for (const Stimulus* stimulus : stimuli_from(out.manifest, "weights"))
    for (const auto& [name, weight] : stimulus->weights)
      if (weight > 0.0) used.insert(name);
  return used.size();
}

void describe_repertoire(MethodsText& out) {
  const Repertoire& repertoire = out.motions.repertoire();
  const std::size_t count = repertoire.names.size();
  if (repertoire.origins.empty()) {
    out.say(fmt::format("The examples were {} synthetic motions (mien's built-in example set {})",
                        count, out.manifest.examples.builtin));
  } else {
    out.say(fmt::format("The examples were {}",
                        count_of(count, "recorded motion", "recorded motions")));
  }
  if (const std::size_t used = used_examples(out); used > 0 && used < count)
    out.say(fmt::format("Of these, {} used", count_of(used, "was", "were")));
  Range seconds;
  int loops = 0;
  for (const motion::Example& example : repertoire.examples.examples) {
    seconds.add(example.clip.duration_seconds());
    loops += example.clip.loops ? 1 : 0;
  }
  if (loops == seconds.count && !repertoire.origins.empty()) {
    out.say(
        "From each, the steadiest straight gait cycle was extracted using heel strikes and "
        "toe-offs" +
        out.cite({"zeni2008"}) + ", and closed into a loop");
  }
  const auto mirrored = std::ranges::count_if(
      repertoire.origins, [](const motion::ExampleOrigin& origin) { return origin.is_mirrored; });
  if (mirrored > 0) {
    out.say(fmt::format(
        "{} too short for a full cycle, so that one step and its mirror image were used instead",
        count_of(static_cast<std::size_t>(mirrored), "recording was", "recordings were")));
  }
  out.say((loops == seconds.count ? "Each example was a single gait cycle; they lasted "
                                  : "The examples lasted ") +
          with_mean(seconds, 2, " s"));
  describe_example_settings(out);
}

/// Where the ratings come from, if a file has them.
std::string ratings_source(MethodsText& out) {
  if (out.manifest.ratings.source != Ratings::Source::file) return "";
  return " (" + motion::printable(out.manifest.ratings.file.filename().string()) + ")";
}

/// Number of participants who answered; 0 if only means are given.
std::size_t raters_of(const Answers& answers) {
  std::set<std::string> raters;
  for (const Answer& answer : answers.answers) {
    if (!answer.participant.empty()) raters.insert(answer.participant);
  }
  return raters.size();
}

void describe_ratings(MethodsText& out) {
  const Repertoire& repertoire = out.motions.repertoire();
  if (!repertoire.impressions || stimuli_from(out.manifest, "adjectives").empty()) return;
  const Impressions& impressions = *repertoire.impressions;
  const std::string scales =
      count_of(impressions.scales.size(), "scale", "scales") +
      (out.manifest.scales.file.empty() ? " of published adjective pairs" + out.cite({"adjectives"})
                                        : "");
  const std::size_t raters = raters_of(repertoire.answers);
  Range answers;
  answers.add(impressions.count.minCoeff());
  answers.add(impressions.count.maxCoeff());
  const std::string each = range_text(answers, 0, " answers") + " per scale and example";
  if (raters == 0) {  // a table of means
    out.say(fmt::format(
        "{}{}",
        impressions.simulated
            ? "No participants rated the examples; mean ratings were simulated on " + scales
            : "Participants rated the examples; means were available on " + scales,
        ratings_source(out)));
  } else if (impressions.simulated) {
    out.say(fmt::format("No participants rated the examples; {} answered on {}, {}{}",
                        count_of(raters, "simulated rater", "simulated raters"), scales, each,
                        ratings_source(out)));
  } else {
    out.say(fmt::format("{} rated the examples on {}, {}{}",
                        count_of(raters, "participant", "participants"), scales, each,
                        ratings_source(out)));
  }
  if (out.manifest.ratings.source == Ratings::Source::file && out.manifest.ratings.ignore_unknown)
    out.say("Answers about other motions and on other scales were excluded");
  out.say(
      std::string(
          "An example's position on a scale is its mean rating, from 0 (low end) to 1 (high end)") +
      (scales_of(out.manifest.scales).groups.empty()
           ? ""
           : "; its position on a group of scales is the mean over these scales"));
  std::size_t held = 0, certain = 0;
  const auto checks = expectation_checks(out.manifest, repertoire);
  for (const ExpectationCheck& check : checks) {
    held += check.holds() ? 1 : 0;
    certain += check.holds() && check.is_certain() ? 1 : 0;
  }
  if (!checks.empty())
    out.say(
        fmt::format("Of {} of the examples, {} were found in the ratings, {} of them significantly",
                    count_of(checks.size(), "expected order", "expected orders"), held, certain));
}

}  // namespace

void describe_examples(MethodsText& out) {
  describe_repertoire(out);
  describe_ratings(out);
}

}  // namespace mien::pipeline

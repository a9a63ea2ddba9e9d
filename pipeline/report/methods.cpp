#include "pipeline/report/methods.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "pipeline/report/method_sources.h"
#include "pipeline/report/methods_pictures.h"
#include "pipeline/report/prose.h"
#include "pipeline/report/references.h"
#include "pipeline/report/study_facts.h"
#include "pipeline/tasks/code_identity.h"

namespace mien::pipeline {

namespace {

class MethodsWriter {
 public:
  MethodsWriter(const Manifest& manifest, Motions& motions)
      : manifest_(manifest), motions_(motions) {}

  Methods write() {
    tell_program();
    tell_design();
    if (uses_examples(manifest_)) {
      tell_examples();
      tell_ratings();
    }
    tell_blends();
    tell_files();
    tell_modifications();
    tell_foils();
    out_.end_paragraph();
    tell_pictures(manifest_, motions_, out_);
    out_.end_paragraph();
    std::string text = out_.text();
    text.pop_back();  // one line end is enough
    return {text, bibtex_of(out_.cited())};
  }

 private:
  void say(const std::string& sentence) { out_.say(sentence); }
  std::string cite(const Names& keys) { return out_.cite(keys); }

  std::vector<const Stimulus*> stimuli_of(const std::string& source) const {
    std::vector<const Stimulus*> found;
    for (const Stimulus& stimulus : manifest_.stimuli) {
      if (pipeline::source_of(stimulus) == source) found.push_back(&stimulus);
    }
    return found;
  }

  void tell_program() {
    say(fmt::format("The {} made with mien {}{} (random seed {})",
                    count_of(manifest_.stimuli.size(), "stimulus was", "stimuli were"),
                    program_version(), own_citation(), manifest_.seed));
  }

  static std::string own_citation() { return " [@mien]"; }

  void tell_design() {
    Names factors;
    for (const std::string& factor : factors_of(manifest_)) {
      Names levels;
      for (const Stimulus& stimulus : manifest_.stimuli) {
        const std::string level = level_of(stimulus, factor);
        if (!level.empty()) add_once(levels, level);
      }
      factors.push_back(levels.size() > 12
                            ? fmt::format("{} ({} levels)", factor, levels.size())
                            : fmt::format("{} ({})", factor, fmt::join(levels, ", ")));
    }
    if (!factors.empty()) {
      say(fmt::format("{} {}", factors.size() == 1 ? "The factor was" : "The factors were",
                      listed(factors)));
    }
  }

  void tell_examples() {
    const Repertoire& repertoire = motions_.repertoire();
    const std::size_t count = repertoire.names.size();
    if (repertoire.origins.empty()) {
      say(fmt::format("The examples were {} synthetic motions (mien's built-in set {})", count,
                      manifest_.examples.builtin));
    } else {
      say(fmt::format("The examples were {}",
                      count_of(count, "recorded motion", "recorded motions")));
    }
    Range seconds;
    int loops = 0;
    for (const motion::Example& example : repertoire.examples.examples) {
      seconds.add(example.clip.duration_seconds());
      loops += example.clip.loops ? 1 : 0;
    }
    if (loops == seconds.count && !repertoire.origins.empty()) {
      say("Of each the steadiest straight gait cycle was cut, by heel strikes and toe offs" +
          cite({"zeni2008"}) + ", and closed to a loop");
    }
    const auto mirrored = std::ranges::count_if(
        repertoire.origins, [](const motion::ExampleOrigin& origin) { return origin.is_mirrored; });
    if (mirrored > 0) {
      say(fmt::format(
          "{} too short for one: a step and its mirror image stand for the cycle",
          count_of(static_cast<std::size_t>(mirrored), "recording was", "recordings were")));
    }
    say("They last " + with_mean(seconds, 2, " s"));
  }

  void tell_ratings() {
    const Repertoire& repertoire = motions_.repertoire();
    if (!repertoire.impressions || stimuli_of("adjectives").empty()) return;
    const Impressions& impressions = *repertoire.impressions;
    const std::string scales =
        count_of(impressions.scales.size(), "scale", "scales") +
        (manifest_.scales.file.empty() ? " (the pairs of adjectives of" + cite({"adjectives"}) + ")"
                                       : "");
    if (impressions.simulated) {
      say(fmt::format("No person rated them: {} simulated raters answered on {}",
                      manifest_.ratings.raters, scales));
    } else {
      Range answers;
      answers.add(impressions.count.minCoeff());
      answers.add(impressions.count.maxCoeff());
      say(fmt::format("People rated them on {}, {} a scale and example", scales,
                      told(answers, 0, " answers")));
    }
    say(std::string("An example's place on a scale is its mean answer, from 0 (the low end) to 1 "
                    "(the high end)") +
        (scales_of(manifest_.scales).groups.empty()
             ? ""
             : "; that on a group of scales is the mean of these"));
    std::size_t held = 0, certain = 0;
    const auto checks = expectation_checks(manifest_, repertoire);
    for (const ExpectationCheck& check : checks) {
      held += check.holds() ? 1 : 0;
      certain += check.holds() && check.is_certain() ? 1 : 0;
    }
    if (!checks.empty())
      say(
          fmt::format("Of {} expected of the ratings, {} came out as expected, {} of them by more "
                      "than the noise of the answers",
                      count_of(checks.size(), "order", "orders"), held, certain));
  }

  void tell_blends() {
    if (!blends_examples(manifest_)) return;
    if (!stimuli_of("adjectives").empty() || !stimuli_of("features").empty()) {
      tell_interpolation();
      tell_reached();
      tell_held();
    }
    if (const auto weighted = stimuli_of("weights"); !weighted.empty()) {
      say(count_of(weighted.size(), "stimulus was blended", "stimuli were blended") +
          " from examples in given shares");
    }
    if (!manifest_.examples.blendable) return;
    Names rotations, warps;
    bool locks = false;
    for (const Stimulus& stimulus : manifest_.stimuli) {
      if (stimulus.clip) continue;
      add_once(rotations, mean_of(stimulus.interpolation.rotations));
      add_once(warps, warp_of(stimulus.interpolation.time_warp));
      locks = locks || stimulus.interpolation.foot_lock;
    }
    say("Corresponding moments of the examples were brought together by " + listed(warps) +
        " time warps, and rotations blended as " + listed(rotations));
    if (locks) {
      say("Planted feet were held where they stand by inverse kinematics" + cite({"kovar2002"}));
    }
  }

  std::string mean_of(motion::RotationBlend blend) {
    switch (blend) {
      case motion::RotationBlend::direction_vectors:
        return "sums of direction vectors";
      case motion::RotationBlend::markley_mean:
        return "Markley means" + cite({"markley2007"});
      case motion::RotationBlend::karcher_mean:
        break;
    }
    return "Karcher means";
  }

  std::string warp_of(motion::WarpShape shape) {
    return shape == motion::WarpShape::linear ? "piecewise linear"
                                              : "monotone cubic" + cite({"fritsch1980"});
  }

  void tell_interpolation() {
    for (const char* source : {"adjectives", "features"}) {
      const auto stimuli = stimuli_of(source);
      if (stimuli.empty()) continue;
      Names methods;
      for (const Stimulus* stimulus : stimuli)
        add_once(methods, method_words(stimulus->interpolation.weights.method));
      say(fmt::format(
          "{} asked for by {}: the shares of the examples were found by {}",
          count_of(stimuli.size(), "stimulus was", "stimuli were"),
          source == std::string("features") ? "measured features of motion" : "adjectives",
          listed(methods)));
    }
  }

  std::string method_words(motion::InterpolationMethod method) {
    const MethodWords found = words_of(method);
    return found.words + cite(found.sources);
  }

  void tell_reached() {
    Range missed;
    for (const Stimulus& stimulus : manifest_.stimuli) {
      if (!stimulus.modify.empty()) continue;  // known of the blend before alone
      const Synthesis& made = motions_.of(stimulus.id);
      const std::size_t count = std::min(made.asked.size(), made.reached.size());
      for (std::size_t i = 0; i < count; ++i)
        missed.add(std::abs(made.reached[i].second - made.asked[i].second));
    }
    if (missed.count == 0) return;
    say(
        fmt::format("Of {} asked for, from 0 to 1, the motions miss {:.3f} on average and {:.3f} "
                    "at most",
                    count_of(static_cast<std::size_t>(missed.count), "value", "values"),
                    missed.mean(), missed.most));
  }

  void tell_held() {
    const auto holds = [](const Stimulus& stimulus) { return stimulus.hold.anything(); };
    const auto held = std::ranges::count_if(manifest_.stimuli, holds);
    if (held == 0) return;
    say(
        fmt::format("In {} parameters that were not asked for were held where they are in {}, as "
                    "near as the examples allow",
                    count_of(static_cast<std::size_t>(held), "stimulus", "stimuli"), held_where()));
  }

  std::string held_where() const {
    Names places;
    for (const Stimulus& stimulus : manifest_.stimuli) {
      const Hold& hold = stimulus.hold;
      if (!hold.values.empty()) add_once(places, "the manifest");
      if (!hold.others && hold.names.empty()) continue;
      add_once(places,
               hold.reference ? "the stimulus " + hold.reference->id : "the mean of the examples");
    }
    return listed(places);
  }

  void tell_foils() {
    std::size_t foils = 0;
    Names aspects;
    for (const Stimulus& stimulus : manifest_.stimuli) {
      if (!stimulus.foil) continue;
      ++foils;
      add_once(aspects, std::string(name_of(stimulus.foil->differ)));
    }
    if (foils == 0) return;
    say(count_of(foils, "stimulus is a foil", "stimuli are foils") +
        ": modified as another stimulus is, but for its change of " + listed(aspects) +
        "; what else differs was measured of both (metrics/foils.csv)");
  }

  void tell_files() {
    const auto files = stimuli_of("clip");
    if (files.empty()) return;
    say(count_of(files.size(), "stimulus shows", "stimuli show") + " recorded motion");
  }

  void tell_modifications() {
    std::size_t modified = 0, reduced = 0;
    double least_share = 1.0;
    Names emotions, styles, parts;
    Range strengths;
    for (const Stimulus& stimulus : manifest_.stimuli) {
      if (stimulus.modify.empty()) continue;
      ++modified;
      const double share = motions_.of(stimulus.id).modified_share;
      reduced += share < 1.0 ? 1 : 0;
      least_share = std::min(least_share, share);
      for (const ModificationStep& step : stimulus.modify) {
        if (!step.emotion.empty()) {
          add_once(emotions, step.emotion);
          strengths.add(step.strength);
        }
        if (step.style) add_once(styles, source_of(step.style->method));
        for (const std::string& part : step.edit.named) add_once(parts, part);
      }
    }
    if (modified == 0) return;
    say(count_of(modified, "stimulus was", "stimuli were") + " modified afterwards" +
        modification_sources());
    if (!emotions.empty()) {
      say(fmt::format("The {} ({}) {} {}, at a strength of {}",
                      emotions.size() == 1 ? "recipe used" : "recipes used", recipe_book(),
                      emotions.size() == 1 ? "was" : "were", listed(emotions),
                      told(strengths, 2, "")));
    }
    if (!parts.empty()) say("Set by hand: " + listed(parts));
    if (!styles.empty()) {
      say("Differences of style were taken over from pairs of examples by published methods" +
          cite(styles));
    }
    if (reduced > 0) {
      say(
          fmt::format("In {} the modification was reduced as far as the motion needed to stay free "
                      "of faults, to {:.0f} % at the least",
                      reduced, 100.0 * least_share));
    }
  }

  std::string modification_sources() { return cite({"emotionthesis2010", "bruderlin1995"}); }

  std::string recipe_book() const {
    if (!manifest_.recipes.file.empty()) return manifest_.recipes.file.filename().string();
    return manifest_.recipes.name == "fig29" ? "figure 29 of the thesis, with mien's numbers"
                                             : "mien's own, after the thesis";
  }

  const Manifest& manifest_;
  Motions& motions_;
  MethodsText out_;
};

}  // namespace

Methods methods_of(const Manifest& manifest, Motions& motions) {
  return MethodsWriter(manifest, motions).write();
}

}  // namespace mien::pipeline

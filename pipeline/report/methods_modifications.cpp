#include "pipeline/report/methods_modifications.h"

#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "pipeline/report/method_sources.h"
#include "pipeline/report/prose.h"

namespace mien::pipeline {

namespace {

class ModificationsWriter {
 public:
  ModificationsWriter(const Manifest& manifest, Motions& motions, MethodsText& out)
      : manifest_(manifest), motions_(motions), out_(out) {}

  void write() {
    tell_modifications();
    tell_foils();
  }

 private:
  void say(const std::string& sentence) { out_.say(sentence); }
  std::string cite(const Names& keys) { return out_.cite(keys); }

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

  const Manifest& manifest_;
  Motions& motions_;
  MethodsText& out_;
};

}  // namespace

void tell_modifications(const Manifest& manifest, Motions& motions, MethodsText& text) {
  ModificationsWriter(manifest, motions, text).write();
}

}  // namespace mien::pipeline

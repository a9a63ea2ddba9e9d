#include "pipeline/production/report/methods_blends.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "pipeline/production/report/method_sources.h"
#include "pipeline/production/report/prose.h"
#include "pipeline/production/report/study_facts.h"

namespace mien::pipeline {

namespace {

class BlendsWriter {
 public:
  BlendsWriter(const Manifest& manifest, Motions& motions, MethodsText& out)
      : manifest_(manifest), motions_(motions), out_(out) {}

  void write() { tell_blends(); }

 private:
  void say(const std::string& sentence) { out_.say(sentence); }
  std::string cite(const Names& keys) { return out_.cite(keys); }

  void tell_blends() {
    if (!blends_examples(manifest_)) return;
    if (!stimuli_from(manifest_, "adjectives").empty() ||
        !stimuli_from(manifest_, "features").empty()) {
      tell_interpolation();
      tell_reached();
      tell_held();
    }
    if (const auto weighted = stimuli_from(manifest_, "weights"); !weighted.empty()) {
      say(count_of(weighted.size(), "stimulus was blended", "stimuli were blended") +
          " from examples in given shares");
    }
    if (!manifest_.examples.blendable) return;
    Names rotations, warps;
    bool locks = false;
    for (const Stimulus& stimulus : manifest_.stimuli) {
      if (!is_blend(stimulus)) continue;
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
      const auto stimuli = stimuli_from(manifest_, source);
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
    Range missed;
    for (const Stimulus& stimulus : manifest_.stimuli) {
      if (!holds(stimulus)) continue;
      const Synthesis& made = motions_.of(stimulus.id);
      for (std::size_t i = 0; i < made.held.size(); ++i)
        missed.add(std::abs(made.held_reached[i].second - made.held[i].second));
    }
    if (missed.count == 0) return;
    say(fmt::format("Of {} held, the blends miss {:.3f} on average and {:.3f} at most",
                    count_of(static_cast<std::size_t>(missed.count), "value", "values"),
                    missed.mean(), missed.most));
  }

  std::string held_where() const {
    Names places;
    for (const Stimulus& stimulus : manifest_.stimuli) {
      const Hold& hold = stimulus.hold;
      if (!hold.values.empty()) add_once(places, "the manifest");
      if (!hold.others && hold.names.empty()) continue;
      add_once(places, hold.reference.empty() ? "the mean of the examples"
                                              : "the stimulus " + hold.reference[0].id);
    }
    return listed(places);
  }

  const Manifest& manifest_;
  Motions& motions_;
  MethodsText& out_;
};

}  // namespace

void tell_blends(const Manifest& manifest, Motions& motions, MethodsText& text) {
  BlendsWriter(manifest, motions, text).write();
}

}  // namespace mien::pipeline

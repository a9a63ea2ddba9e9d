#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "pipeline/manifest/people.h"
#include "pipeline/production/methods/methods_parts.h"
#include "pipeline/production/methods/prose.h"
#include "pipeline/production/methods/study_facts.h"

namespace mien::pipeline {

namespace {

std::string mean_of(motion::RotationBlend blend, MethodsText& out) {
  switch (blend) {
    case motion::RotationBlend::direction_vectors:
      return "sums of direction vectors";
    case motion::RotationBlend::markley_mean:
      return "Markley means" + out.cite({"markley2007"});
    case motion::RotationBlend::karcher_mean:
      break;
  }
  return "Karcher means";
}

std::string warp_of(motion::WarpShape shape, MethodsText& out) {
  return shape == motion::WarpShape::linear
             ? "piecewise linear time warps"
             : "monotone cubic time warps" + out.cite({"fritsch1980"});
}

std::string method_words(motion::InterpolationMethod method, MethodsText& out) {
  const MethodWords found = words_of(method);
  return found.words + out.cite(found.sources);
}

/// Whether the given weights are those of one example alone, so that nothing is blended.
bool is_one_example(const Stimulus& stimulus) {
  return std::ranges::count_if(stimulus.weights,
                               [](const auto& part) { return part.second > 0.0; }) == 1;
}

void describe_interpolation(MethodsText& out) {
  for (const char* source : {"adjectives", "features"}) {
    const auto stimuli = stimuli_from(out.manifest, source);
    if (stimuli.empty()) continue;
    Names methods;
    for (const Stimulus* stimulus : stimuli)
      add_once(methods, method_words(stimulus->interpolation.weights.method, out));
    out.say(
        fmt::format("{} specified by {}; blend weights were computed by {}",
                    count_of(stimuli.size(), "stimulus was", "stimuli were"),
                    source == std::string("features") ? "measured motion features" : "adjectives",
                    listed(methods)));
  }
}

/// "by 0.012 on average and by at most 0.040", or "by less than 0.0005" where three decimals are 0.
std::string deviation_text(const Range& missed) {
  constexpr double visible = 0.0005;
  if (missed.most < visible) return "by less than 0.0005";
  return (missed.mean() < visible ? "by less than 0.0005"
                                  : fmt::format("by {:.3f}", missed.mean())) +
         fmt::format(" on average and by at most {:.3f}", missed.most);
}

void describe_deviations(MethodsText& out) {
  Range missed;
  bool has_modified = false;
  for (const Stimulus* source : motion_sources(out.manifest)) {
    const Stimulus& stimulus = *source;
    const Synthesis& made = out.motions.of(stimulus.id);
    if (!stimulus.modify.empty()) {  // known of the blend before alone
      has_modified = has_modified || !made.requested.empty();
      continue;
    }
    const std::size_t count = std::min(made.requested.size(), made.reached.size());
    for (std::size_t i = 0; i < count; ++i)
      missed.add(std::abs(made.reached[i].second - made.requested[i].second));
  }
  if (missed.count == 0) return;
  out.say(fmt::format(
      "The values reached deviated from the {}{} (on scales from 0 to 1) {}",
      missed.count == 1 ? "requested value" : fmt::format("{} requested values", missed.count),
      has_modified ? " of unmodified stimuli" : "", deviation_text(missed)));
}

std::string held_at_text(MethodsText& out) {
  Names places;
  for (const Stimulus* source : motion_sources(out.manifest)) {
    const Stimulus& stimulus = *source;
    const Hold& hold = stimulus.hold;
    if (!hold.values.empty()) add_once(places, "the manifest");
    if (!hold.others && hold.names.empty()) continue;
    add_once(places, hold.reference.empty() ? "the mean of the examples"
                                            : "the stimulus " + hold.reference[0].id);
  }
  return listed(places);
}

void describe_holds(MethodsText& out) {
  const auto holds = [](const Stimulus* motion) { return motion->hold.anything(); };
  const auto held = std::ranges::count_if(motion_sources(out.manifest), holds);
  if (held == 0) return;
  out.say(fmt::format(
      "In {}, parameters that were not requested were held at their values in {}, as closely as "
      "the examples allow",
      count_of(static_cast<std::size_t>(held), "stimulus", "stimuli"), held_at_text(out)));
  Range missed;
  for (const Stimulus* source : motion_sources(out.manifest)) {
    const Stimulus& stimulus = *source;
    if (!holds(source)) continue;
    const Synthesis& made = out.motions.of(stimulus.id);
    for (std::size_t i = 0; i < made.held.size(); ++i)
      missed.add(std::abs(made.held_reached[i].second - made.held[i].second));
  }
  if (missed.count == 0) return;
  out.say(
      fmt::format("The values reached deviated from the {} {}",
                  missed.count == 1 ? "held value" : fmt::format("{} held values", missed.count),
                  deviation_text(missed)));
}

}  // namespace

void describe_blends(MethodsText& out) {
  if (!blends_examples(out.manifest)) return;
  if (!stimuli_from(out.manifest, "adjectives").empty() ||
      !stimuli_from(out.manifest, "features").empty()) {
    describe_interpolation(out);
    describe_deviations(out);
    describe_holds(out);
  }
  const auto weighted = stimuli_from(out.manifest, "weights");
  const auto single = static_cast<std::size_t>(std::ranges::count_if(
      weighted, [](const Stimulus* stimulus) { return is_one_example(*stimulus); }));
  if (weighted.size() > single) {
    out.say(count_of(weighted.size() - single, "stimulus was blended", "stimuli were blended") +
            " from examples with given weights");
  }
  if (single > 0)
    out.say(count_of(single, "stimulus was a single example", "stimuli were single examples"));
  if (!out.manifest.examples.blendable) return;
  Names rotations, warps;
  bool locks = false;
  for (const Stimulus* source : motion_sources(out.manifest)) {
    const Stimulus& stimulus = *source;
    if (!is_blend(stimulus)) continue;
    locks = locks || stimulus.interpolation.foot_lock;
    if (is_one_example(stimulus)) continue;
    add_once(rotations, mean_of(stimulus.interpolation.rotations, out));
    add_once(warps, warp_of(stimulus.interpolation.time_warp, out));
  }
  if (!warps.empty()) {
    out.say("Corresponding moments of the examples were aligned by " + listed(warps) +
            ", and rotations were averaged as " + listed(rotations));
  }
  if (locks) {
    out.say("Planted feet were locked to the floor by inverse kinematics" +
            out.cite({"kovar2002"}));
  }
}

}  // namespace mien::pipeline

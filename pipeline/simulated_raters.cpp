#include "pipeline/simulated_raters.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "motion/error.h"
#include "pipeline/named_random.h"

namespace mien::pipeline {

namespace {

constexpr std::array<std::string_view, motion::style_impression_count> impression_names = {
    "quickness", "clearness", "activeness", "largeness",
    "valence",   "arousal",   "tension",    "stability"};

struct PairLoadings {
  std::string_view pair;
  motion::StyleProfile loadings;
};

// Ours: what the words mean, leaning to the cluster of the adjective paper that they belong to.
// Columns: quickness, clearness, activeness, largeness, valence, arousal, tension, stability.
constexpr std::array<PairLoadings, 41> pair_loadings = {{
    {"slow-fast", {1.0, 0, 0, 0, 0, 0, 0, 0}},
    {"mild-violent", {0, 0, 0.5, 0.3, 0, 0.3, 0.2, 0}},
    {"hard-soft", {0, 0, 0, 0, 0.2, 0, -0.7, 0}},
    {"dull-quick", {0.9, 0.1, 0, 0, 0, 0, 0, 0}},
    {"quiet-noisy", {0, 0, 0.6, 0.3, 0, 0.2, 0, 0}},
    {"angular-circular", {0, 0, 0, 0, 0.2, 0, -0.6, 0}},
    {"blunt-sharp", {0.7, 0.1, 0, 0.2, 0, 0, 0, 0}},
    {"dormant-brisk", {0.2, 0, 0.9, 0, 0, 0, 0, 0}},
    {"edgy-round", {0, 0, 0, 0.2, 0, 0, -0.6, 0}},
    {"weak-strong", {0, 0.7, 0, 0.3, 0, 0, 0, 0.2}},
    {"unpleasant-pleasant", {0, 0, 0.5, 0, 0.6, 0, 0, 0}},
    {"inelastic-elastic", {0, 0, 0.3, 0, 0.1, 0, -0.4, 0}},
    {"dirty-clean", {0, 0.8, 0, 0, 0.1, 0, 0, 0}},
    {"sad-happy", {0, 0, 0.6, 0, 0.6, 0, 0, 0}},
    {"bumpy-smooth", {0, 0.5, 0, 0, 0, -0.2, 0, 0.6}},
    {"uncool-cool", {0, 0.9, 0, 0, 0, 0, 0, 0}},
    {"dark-bright", {0, 0, 0.7, 0, 0.5, 0, 0, 0}},
    {"thin-thick", {-0.3, 0, 0, 0.3, 0, 0, 0, 0}},
    {"ugly-cute", {0, 0.6, 0, 0, 0.3, 0, 0, 0}},
    {"simple-gaudy", {0, 0, 0.7, 0.3, 0, 0, 0, 0}},
    {"coarse-fine", {0, 0.3, 0, 0, 0, -0.2, 0, 0}},
    {"old-young", {0.2, 0.6, 0.4, 0, 0, 0, 0, 0}},
    {"heavy-light", {0.3, 0, 0.7, 0, 0.1, 0, 0, 0}},
    {"strained-relaxed", {0, 0, 0, 0, 0.2, 0, -0.9, 0}},
    {"unstable-stable", {0, 0.7, 0, 0, 0, 0, 0, 0.4}},
    {"small-large", {0, 0, 0, 1.0, 0, 0, 0, 0}},
    {"unafraid-afraid", {0, -0.1, 0, -0.4, 0, 0, 0.5, -0.3}},
    {"artificial-natural", {0, 0.8, 0, 0, 0, 0, -0.2, 0}},
    {"closed-open", {0, 0, 0.3, 0.8, 0, 0, 0, 0}},
    {"adult-childish", {0, 0, 0.3, 0.3, 0, 0.1, 0, -0.4}},
    {"vague-distinct", {0, 0.8, 0, 0.2, 0, 0, 0, 0}},
    {"narrow-broad", {0, 0, 0, 0.9, 0, 0, 0, 0}},
    {"ugly-beautiful", {0, 0.9, 0, 0, 0, 0, 0, 0}},
    {"poor-rich", {0, 0.7, 0.4, 0, 0, 0, 0, 0}},
    {"tight-free", {0, 0, 0.1, 0.7, 0, 0, -0.2, 0}},
    {"dim-sharp", {0, 0.4, 0.6, 0, 0, 0, 0, 0}},
    {"drab-clear", {0, 0.9, 0, 0, 0.1, 0, 0, 0}},
    {"gloomy-cheerful", {0, 0, 0.5, 0.5, 0.3, 0, 0, 0}},
    {"lonely-bustling", {0, 0, 0.8, 0.2, 0, 0, 0, 0}},
    {"calm-excited", {0, 0, 0.7, 0.2, 0, 0.4, 0, 0}},
    {"narrow-wide", {0, 0, 0, 0.9, 0, 0, 0, 0}},
}};

std::optional<motion::StyleProfile> builtin_loadings(std::string_view id) {
  for (const PairLoadings& pair : pair_loadings) {
    if (pair.pair == id) return pair.loadings;
  }
  return std::nullopt;
}

double answer_of(const Scale& scale, double share_of_half_range) {
  const double middle = 0.5 * (scale.least + scale.most);
  const double half = 0.5 * (scale.most - scale.least);
  const double value = std::clamp(middle + half * share_of_half_range, scale.least, scale.most);
  const bool whole_ends =
      scale.least == std::round(scale.least) && scale.most == std::round(scale.most);
  return whole_ends ? std::round(value) : value;
}

}  // namespace

const std::array<std::string_view, motion::style_impression_count>& style_impression_names() {
  return impression_names;
}

motion::StyleProfile loadings_of(const Scale& scale) {
  if (!scale.loadings.empty()) {
    motion::StyleProfile loadings{};
    for (const auto& [impression, value] : scale.loadings) {
      const auto found = std::find(impression_names.begin(), impression_names.end(), impression);
      loadings[static_cast<size_t>(found - impression_names.begin())] = value;
    }
    return loadings;
  }
  if (const auto loadings = builtin_loadings(scale.id)) return *loadings;
  throw Error(fmt::format("simulated raters do not know what \"{}\" means", scale.id),
              "give the scale `loadings:` in the scales file, for instance {activeness: 0.6}");
}

Answers simulate_answers(const std::vector<StyledStimulus>& stimuli, const ScaleSet& scales,
                         const SimulatedRaters& raters) {
  Answers result;
  result.simulated = true;
  for (int r = 0; r < raters.count; ++r) {
    const std::string rater = fmt::format("simulated-{:02}", r + 1);
    for (const StyledStimulus& stimulus : stimuli) {
      for (const Scale& scale : scales.scales) {
        const motion::StyleProfile loadings = loadings_of(scale);
        double impression = 0.0;
        for (size_t a = 0; a < loadings.size(); ++a)
          impression += loadings[a] * stimulus.profile[a];
        const double gain =
            1.0 +
            raters.gain_spread * normal(raters.seed, fmt::format("gain/{}/{}", rater, scale.id));
        const double offset = raters.offset_spread *
                              normal(raters.seed, fmt::format("offset/{}/{}", rater, scale.id));
        const double noise =
            raters.noise *
            normal(raters.seed, fmt::format("noise/{}/{}/{}", rater, stimulus.name, scale.id));
        const double share = std::tanh(1.2 * gain * impression) + offset + noise;
        result.answers.push_back({rater, stimulus.name, scale.id, answer_of(scale, share)});
      }
    }
  }
  return result;
}

}  // namespace mien::pipeline

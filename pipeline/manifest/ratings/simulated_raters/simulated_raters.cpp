#include "pipeline/manifest/ratings/simulated_raters/simulated_raters.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <Eigen/Core>
#include <fmt/format.h>

#include "motion/error.h"
#include "motion/measures/features/motion_measures.h"
#include "pipeline/base/statistics/named_random.h"

namespace mien::pipeline {

namespace {

using motion::motion_measure_count;

constexpr std::array<std::string_view, style_impression_count> impression_names = {
    "quickness", "clearness", "activeness", "largeness",
    "valence",   "arousal",   "tension",    "stability"};

/// What a pair means to simulated raters.
struct PairMeaning {
  std::string_view pair;
  StyleProfile loadings;
  double
      answer_sd;  ///< standard deviation of an answer; replaces SimulatedRaters::noise when larger
};

constexpr double sure = 0.0;
constexpr double ambiguous_sd = 0.7;

// Ours. The 29 pairs of Table 3 of the adjective paper mean above all the impression of their
// cluster, each with a shade of its own. Of the pairs that its raters could not use, those about
// texture and shape say little of a walk and stay near the middle, and those about what a walker
// feels or could do are read by each rater in his own way.
// Columns: quickness, clearness, activeness, largeness, valence, arousal, tension, stability.
constexpr std::array<PairMeaning, 41> pair_meanings = {{
    {"slow-fast", {0.9, 0, 0, 0, 0, 0, 0, 0}, sure},
    {"mild-violent", {0, 0, 0, 0.9, 0, 0, 0.15, 0}, sure},
    {"hard-soft", {0, 0, 0, 0, 0, 0, -0.27, 0}, sure},
    {"dull-quick", {0.9, 0, 0, 0, 0, 0.15, 0, 0}, sure},
    {"quiet-noisy", {0, 0, 0, 0.9, 0, 0.15, 0, 0}, sure},
    {"angular-circular", {0, 0, 0, 0, 0, 0, -0.27, 0}, sure},
    {"blunt-sharp", {0.15, 0, 0, 0.9, 0, 0, 0, 0}, sure},
    {"dormant-brisk", {0.15, 0, 0.9, 0, 0, 0, 0, 0}, sure},
    {"edgy-round", {0, 0, 0, 0.9, 0, 0, -0.15, 0}, sure},
    {"weak-strong", {0, 0, 0, 0.5, 0, 0, 0, 0}, ambiguous_sd},
    {"unpleasant-pleasant", {0, 0, 0.9, 0, 0.2, 0, 0, 0}, sure},
    {"inelastic-elastic", {0, 0, 0.4, 0, 0, 0, 0, 0}, ambiguous_sd},
    {"dirty-clean", {0, 0.27, 0, 0, 0, 0, 0, 0}, sure},
    {"sad-happy", {0, 0, 0.9, 0, 0.2, 0, 0, 0}, sure},
    {"bumpy-smooth", {0, 0.9, 0, 0, 0, 0, 0, 0.15}, sure},
    {"uncool-cool", {0, 0.9, 0, 0, 0, 0, 0, 0}, sure},
    {"dark-bright", {0, 0, 0.9, 0, 0.15, 0, 0, 0}, sure},
    {"thin-thick", {0, 0, 0, 0.27, 0, 0, 0, 0}, sure},
    {"ugly-cute", {0, 0.9, 0, 0, 0.15, 0, 0, 0}, sure},
    {"simple-gaudy", {0, 0, 0.9, 0.15, 0, 0, 0, 0}, sure},
    {"coarse-fine", {0, 0.27, 0, 0, 0, 0, 0, 0}, sure},
    {"old-young", {0.1, 0, 0.9, 0, 0, 0, 0, 0}, sure},
    {"heavy-light", {0.1, 0, 0.9, 0, 0, 0, 0, 0}, sure},
    {"strained-relaxed", {0, 0, 0, 0, 0, 0, -0.5, 0}, ambiguous_sd},
    {"unstable-stable", {0, 0.9, 0, 0, 0, 0, 0, 0.2}, sure},
    {"small-large", {0, 0, 0, 0.9, 0, 0, 0, 0}, sure},
    {"unafraid-afraid", {0, 0, 0, 0, 0, 0, 0.5, 0}, ambiguous_sd},
    {"artificial-natural", {0, 0.9, 0, 0, 0, 0, -0.15, 0}, sure},
    {"closed-open", {0, 0, 0.9, 0.15, 0, 0, 0, 0}, sure},
    {"adult-childish", {0, 0, 0, 0.9, 0.1, 0, 0, -0.1}, sure},
    {"vague-distinct", {0, 0.27, 0, 0, 0, 0, 0, 0}, sure},
    {"narrow-broad", {0, 0, 0, 0.27, 0, 0, 0, 0}, sure},
    {"ugly-beautiful", {0, 0.9, 0, 0, 0.1, 0, 0, 0}, sure},
    {"poor-rich", {0, 0, 0.9, 0.1, 0, 0, 0, 0}, sure},
    {"tight-free", {0, 0, 0, 0.5, 0, 0, 0, 0}, ambiguous_sd},
    {"dim-sharp", {0.1, 0, 0.9, 0, 0, 0, 0, 0}, sure},
    {"drab-clear", {0, 0.9, 0.1, 0, 0, 0, 0, 0}, sure},
    {"gloomy-cheerful", {0, 0, 0.9, 0, 0.2, 0, 0, 0}, sure},
    {"lonely-bustling", {0, 0, 0.9, 0.1, 0, 0, 0, 0}, sure},
    {"calm-excited", {0, 0, 0, 0.9, 0, 0.2, 0, 0}, sure},
    {"narrow-wide", {0, 0, 0, 0.9, 0, 0, 0, 0}, sure},
}};

const PairMeaning* builtin_meaning(std::string_view id) {
  const auto found = std::ranges::find(pair_meanings, id, &PairMeaning::pair);
  return found == pair_meanings.end() ? nullptr : &*found;
}

/// Standard deviation of one answer, as a share of half the range.
double noise_of(const Scale& scale, const SimulatedRaters& raters) {
  const PairMeaning* meaning = scale.loadings.empty() ? builtin_meaning(scale.id) : nullptr;
  return meaning != nullptr ? std::max(raters.noise, meaning->answer_sd) : raters.noise;
}

double answer_of(const Scale& scale, double share_of_half_range) {
  const double middle = 0.5 * (scale.least + scale.most);
  const double half = 0.5 * (scale.most - scale.least);
  const double value = std::clamp(middle + half * share_of_half_range, scale.least, scale.most);
  const bool whole_ends =
      scale.least == std::round(scale.least) && scale.most == std::round(scale.most);
  return whole_ends ? std::round(value) : value;
}

// Ours, after what is known of how walks look (Montepare et al. 1987; Michalak et al. 2009; Roether
// et al. 2009). The four primary impressions rest on different things: quickness on speed and
// cadence; clearness on limbs that are not held bent, an upright trunk and head and equal steps;
// activeness on how much of the pelvis's movement is up and down rather than from side to side,
// head up and shoulders turning; largeness on the length of the steps and the way of the hands.
// A row an impression; columns speed, tempo, travel, hand range, hand speed, hand spread, elbow
// flexion, trunk lean, head pitch, trunk turn, least knee flexion, bounce, sway, lift, asymmetry.
constexpr double loadings[style_impression_count][motion_measure_count] = {
    /* quickness  */ {0.45, 0.75, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0},
    /* clearness  */ {0, 0, 0, 0, 0, 0, -0.6, -0.3, -0.3, 0, -0.3, 0, 0, 0, -0.3},
    /* activeness */ {0, 0, 0, 0, 0, 0, 0, 0, -0.2, 0.2, 0, 0, -0.2, 0.8, 0},
    /* largeness  */ {0, 0, 0.55, 0.45, 0, 0.25, 0, 0, 0, 0, 0, 0, 0, 0, 0},
    /* valence    */ {0, 0, 0, 0, 0, 0, 0, -0.3, -0.6, 0, 0, 0, 0, 0.3, -0.2},
    /* arousal    */ {0.5, 0.3, 0, 0, 0.4, 0, 0.2, 0, 0, 0, 0, 0, 0, 0, 0},
    /* tension    */ {0, 0, 0, 0, 0, -0.4, 0.6, 0, 0, 0, 0.3, 0, 0, 0, 0},
    /* stability  */ {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, -0.7, 0, -0.5},
};

// Just noticeable differences: spreads below them count as if they were equal to them, so that
// nothing is made of differences that cannot be seen.
constexpr double visible[motion_measure_count] = {0.05, 0.03, 0.05, 0.03,  0.05,  0.03, 0.05, 0.02,
                                                  0.03, 0.03, 0.03, 0.004, 0.004, 0.03, 0.02};

Eigen::MatrixXd standardised(Eigen::MatrixXd values) {
  for (Eigen::Index c = 0; c < values.cols(); ++c) {
    values.col(c).array() -= values.col(c).mean();
    const double deviation =
        std::sqrt(values.col(c).squaredNorm() / static_cast<double>(values.rows()));
    values.col(c) /= std::max(deviation, visible[c]);
  }
  return values;
}

}  // namespace

bool has_loadings(const Scale& scale) {
  return !scale.loadings.empty() || builtin_meaning(scale.id) != nullptr;
}

StyleProfile loadings_of(const Scale& scale) {
  if (!scale.loadings.empty()) {
    StyleProfile loadings{};
    for (const auto& [impression, value] : scale.loadings) {
      const auto found = std::find(impression_names.begin(), impression_names.end(), impression);
      loadings[static_cast<size_t>(found - impression_names.begin())] = value;
    }
    return loadings;
  }
  if (const PairMeaning* meaning = builtin_meaning(scale.id)) return meaning->loadings;
  throw Error(fmt::format("simulated raters have no model of \"{}\"", scale.id),
              "add `loadings:` to the scale in the scales file, for example {activeness: 0.6}");
}

namespace {

/// What each stimulus makes of each scale, a row a scale and a column a stimulus.
Eigen::MatrixXd impressions_on(const std::vector<StyledStimulus>& stimuli, const ScaleSet& scales) {
  Eigen::MatrixXd impressions(scales.scales.size(), stimuli.size());
  for (Eigen::Index s = 0; s < impressions.rows(); ++s) {
    const StyleProfile weights = loadings_of(scales.scales[static_cast<std::size_t>(s)]);
    for (Eigen::Index i = 0; i < impressions.cols(); ++i) {
      const StyleProfile& profile = stimuli[static_cast<std::size_t>(i)].profile;
      impressions(s, i) = std::inner_product(weights.begin(), weights.end(), profile.begin(), 0.0);
    }
  }
  return impressions;
}

/// A rater's response style on a scale.
struct ResponseStyle {
  double gain;
  double offset;
  double noise;  ///< standard deviation
};

std::vector<ResponseStyle> response_styles_of(const std::string& rater, const ScaleSet& scales,
                                              const SimulatedRaters& raters) {
  std::vector<ResponseStyle> response_styles;
  for (const Scale& scale : scales.scales) {
    const auto draw = [&](const char* what) {
      return normal(raters.seed, fmt::format("{}/{}/{}", what, rater, scale.id));
    };
    response_styles.push_back({1.0 + raters.gain_spread * draw("gain"),
                               raters.offset_spread * draw("offset"), noise_of(scale, raters)});
  }
  return response_styles;
}

}  // namespace

Answers simulate_answers(const std::vector<StyledStimulus>& stimuli, const ScaleSet& scales,
                         const SimulatedRaters& raters) {
  Answers result;
  result.simulated = true;
  const Eigen::MatrixXd impressions = impressions_on(stimuli, scales);
  for (int r = 0; r < raters.count; ++r) {
    const std::string rater = fmt::format("simulated-{:02}", r + 1);
    const std::vector<ResponseStyle> response_styles = response_styles_of(rater, scales, raters);
    for (std::size_t i = 0; i < stimuli.size(); ++i) {
      const std::string& name = stimuli[i].name;
      for (std::size_t s = 0; s < scales.scales.size(); ++s) {
        const Scale& scale = scales.scales[s];
        const ResponseStyle& response_style = response_styles[s];
        const double noise =
            response_style.noise *
            normal(raters.seed, fmt::format("noise/{}/{}/{}", rater, name, scale.id));
        const double impression =
            impressions(static_cast<Eigen::Index>(s), static_cast<Eigen::Index>(i));
        const double share =
            std::tanh(1.2 * response_style.gain * impression) + response_style.offset + noise;
        result.answers.push_back({rater, name, scale.id, answer_of(scale, share)});
      }
    }
  }
  return result;
}

std::vector<StyledStimulus> measured_profiles(const motion::ExampleSet& set) {
  Eigen::MatrixXd values(static_cast<Eigen::Index>(set.examples.size()), motion_measure_count);
  for (size_t i = 0; i < set.examples.size(); ++i) {
    const auto measures = motion::values_of(motion::measure(set.examples[i]));
    for (size_t m = 0; m < measures.size(); ++m) {
      values(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(m)) = measures[m];
    }
  }
  values = standardised(std::move(values));

  std::vector<StyledStimulus> stimuli;
  for (size_t i = 0; i < set.examples.size(); ++i) {
    StyledStimulus stimulus{set.examples[i].name, {}};
    for (size_t a = 0; a < style_impression_count; ++a) {
      double sum = 0.0;
      for (size_t m = 0; m < motion_measure_count; ++m) {
        sum += loadings[a][m] * values(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(m));
      }
      stimulus.profile[a] = std::tanh(0.6 * sum);
    }
    stimuli.push_back(std::move(stimulus));
  }
  return stimuli;
}

}  // namespace mien::pipeline

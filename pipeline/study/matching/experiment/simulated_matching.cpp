#include <cmath>

#include <fmt/format.h>

#include "motion/live/live_core.h"
#include "pipeline/manifest/questionnaire_content.h"
#include "pipeline/study/matching/experiment/matching_study.h"
#include "pipeline/study/matching/simulated_trial.h"

namespace mien::pipeline {

namespace {

constexpr double first_view_seconds = 20.0;
constexpr double view_seconds = 3.0;

/// A simulated matching trial.
class SimulatedMatch {
 public:
  SimulatedMatch(const Manifest& manifest, Motions& motions, const MatchingStudy& study,
                 motion::LiveCore& core, const Trial& trial)
      : manifest_(manifest), motions_(motions), core_(core), target_(trial.stimuli.front()) {
    const std::string& interface = trial.items.front().item;
    interface_.kind = meaning_of(motion::interface_kinds, interface).value();
    interface_.sliders = study.experiment.at("matching").at("sliders").at(interface).at("shown");
  }

  MatchingRecord run(const std::string& participant) {
    const Matching& matching = *manifest_.matching;
    SimulatedUser user{.seed = manifest_.seed, .threshold = matching.threshold_m};
    user.name = fmt::format("{}/{}/{}", participant, target_, name_of(interface_.kind));
    user.max_views = 1 + static_cast<int>(std::floor(matching.limit_s / view_seconds));
    const SimulatedTrial trial =
        simulate_trial(ideal(), user, [this](const auto& settings) { return look(settings); });
    record_.first = setting(trial.first_guess);
    record_.first_guess_d = trial.first_distance;
    record_.guess_s = first_view_seconds;
    record_.d = trial.distance;
    record_.success = trial.matched;
    // A user who stops without a match waits for the time limit.
    record_.time_s = trial.matched ? view_seconds * (trial.views - 1) : matching.limit_s;
    record_.changes.push_back({.seconds = first_view_seconds + record_.time_s,
                               .step = "adjust",
                               .action = trial.matched ? "match" : "limit",
                               .d = record_.d});
    return record_;
  }

 private:
  Eigen::RowVectorXd ideal() {
    const Synthesis& target = motions_.of(target_);
    if (target.weights.size() == 0)
      return Eigen::RowVectorXd::Constant(static_cast<Eigen::Index>(interface_.sliders.size()),
                                          0.5);
    return ideal_settings(interface_, target.motion, target.weights, motions_.repertoire());
  }

  SliderSetting setting(const Eigen::RowVectorXd& settings) const {
    return {interface_.sliders, {settings.begin(), settings.end()}};
  }

  /// Successive views differ in one slider; a rejected move is undone first.
  double look(const Eigen::RowVectorXd& settings) {
    const SliderSetting now = setting(settings);
    const double d =
        core_
            .distance(target_,
                      {.kind = interface_.kind, .sliders = now.sliders, .values = now.values})
            .mean;
    const double seconds = first_view_seconds + view_seconds * views_;
    if (views_++ == 0) {
      record_.changes.push_back({.seconds = seconds, .step = "guess", .action = "guess", .d = d});
    } else {
      for (std::size_t i = 0; i < now.values.size(); ++i)
        if (now.values[i] != record_.last.values[i])
          record_.changes.push_back({.seconds = seconds,
                                     .step = "adjust",
                                     .action = "move",
                                     .slider = now.sliders[i],
                                     .value = now.values[i],
                                     .d = d});
    }
    record_.last = now;
    return d;
  }

  const Manifest& manifest_;
  Motions& motions_;
  motion::LiveCore& core_;
  const std::string target_;
  SliderInterface interface_;
  MatchingRecord record_;
  int views_ = 0;
};

}  // namespace

std::vector<MatchedTrial> simulated_matching(const Manifest& manifest, Motions& motions,
                                             const MatchingStudy& study) {
  motion::LiveCore core(study.bundle);
  std::vector<MatchedTrial> trials;
  for (const SessionPlan& plan : study.plans) {
    for (const Trial& trial : plan.trials) {
      if (trial.practice) continue;
      SimulatedMatch match(manifest, motions, study, core, trial);
      trials.push_back({.participant = plan.participant,
                        .design = study.experiment.at("design"),
                        .trial = trial,
                        .match = match.run(plan.participant),
                        .limit_s = manifest.matching->limit_s,
                        .threshold_m = manifest.matching->threshold_m,
                        .simulated = true});
    }
  }
  return trials;
}

}  // namespace mien::pipeline

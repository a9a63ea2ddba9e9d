#include "pipeline/study/questionnaire/power.h"

#include <algorithm>
#include <cmath>

#include <boost/math/distributions/students_t.hpp>
#include <fmt/format.h>

#include "motion/math/random_number.h"
#include "motion/text/excerpt.h"
#include "motion/text/nearest_word.h"
#include "pipeline/base/statistics/named_random.h"
#include "pipeline/base/statistics/proportion.h"
#include "pipeline/manifest/questionnaire_content.h"
#include "pipeline/study/questionnaire/orders.h"
#include "pipeline/study/questionnaire/trial_subjects.h"

namespace mien::pipeline {

namespace {

double critical_t(std::size_t pairs, double alpha) {
  return quantile(complement(boost::math::students_t(static_cast<double>(pairs - 1)), alpha / 2.0));
}

/// Running sums over the differences of a study's participants.
struct RunningTest {
  std::size_t count = 0;
  double sum = 0.0;
  double squares = 0.0;

  void add(double difference) {
    ++count;
    sum += difference;
    squares += difference * difference;
  }

  /// Whether the t test finds the mean different from −shift.
  bool is_found(double shift, const std::vector<double>& critical) const {
    if (count < 2) return false;
    const auto n = static_cast<double>(count);
    const double variance = std::max(0.0, (squares - sum * sum / n) / (n - 1.0));
    return std::abs(sum / n + shift) > critical[count] * std::sqrt(variance / n);
  }
};

/// Simulates studies with up to a number of participants; each of their first n participants are a
/// study too.
class PowerSimulation {
 public:
  PowerSimulation(const Manifest& manifest, const PowerOptions& options, int participants)
      : question_(options),
        rated_(rated_stimuli(manifest, trial_subjects(manifest),
                             static_cast<std::size_t>(participants))),
        critical_{0.0, 0.0} {
    const auto count = static_cast<std::size_t>(participants);
    for (std::size_t pairs = 2; pairs <= count; ++pairs)
      critical_.push_back(critical_t(pairs, options.alpha));
    found.assign(count + 1, 0);
    alarms.assign(count + 1, 0);
    usable.assign(count + 1, 0.0);
    side_.assign(rated_.ids.size(), 0);
    if (!options.factor.empty()) take_levels(manifest);
  }

  void run() {
    for (int study = 0; study < question_.studies; ++study) run_study(study);
  }

  // Counts over the simulated studies, by number of participants.
  std::vector<int> found;
  std::vector<int> alarms;
  std::vector<double> usable;  ///< participants who saw both, summed over the studies

 private:
  void take_levels(const Manifest& manifest) {
    for (std::size_t i = 0; i < rated_.ids.size(); ++i) {
      const std::string level = level_of(manifest, rated_.ids[i], question_.factor);
      side_[i] = level == question_.level ? 1 : level == question_.other_level ? -1 : 0;
    }
  }

  void run_study(int study) {
    stream_ = motion::random_bits(hashed_seed(question_.seed, "power"),
                                  static_cast<std::uint64_t>(study));
    if (question_.factor.empty()) choose_two();
    RunningTest test;
    for (std::size_t person = 0; person < rated_.shares.size(); ++person) {
      add_person(person, test);
      found[person + 1] += test.is_found(question_.difference, critical_);
      alarms[person + 1] += test.is_found(0.0, critical_);
      usable[person + 1] += static_cast<double>(test.count);
    }
  }

  void choose_two() {
    std::ranges::fill(side_, 0);
    const std::size_t one = random_choice(side_.size(), stream_, "one");
    const std::size_t other = random_choice(side_.size() - 1, stream_, "other");
    side_[one] = 1;
    side_[other + (other >= one)] = -1;
  }

  /// The participant's difference under the null hypothesis; nullopt unless the participant saw
  /// both. The participant effect cancels out.
  void add_person(std::size_t person, RunningTest& test) const {
    double sums[2] = {0.0, 0.0};
    int counts[2] = {0, 0};
    for (const std::size_t stimulus : rated_.shares[person]) {
      if (side_[stimulus] == 0) continue;
      const int which = side_[stimulus] > 0;
      sums[which] +=
          question_.spread.residual * normal_number(stream_, number_of(person, stimulus));
      if (!question_.factor.empty())
        sums[which] += question_.spread.stimulus * normal_number(~stream_, stimulus);
      ++counts[which];
    }
    if (counts[0] > 0 && counts[1] > 0) test.add(sums[1] / counts[1] - sums[0] / counts[0]);
  }

  std::uint64_t number_of(std::size_t person, std::size_t stimulus) const {
    return static_cast<std::uint64_t>(person) * rated_.ids.size() + stimulus;
  }

  const PowerOptions& question_;
  RatedStimuli rated_;
  std::vector<double> critical_;  ///< t by number of differences
  std::vector<int> side_;         ///< of each stimulus: 1, −1, or 0 when it is not compared
  std::uint64_t stream_ = 0;
};

/// The least number of participants with which `is_enough`; 0 for none.
int least_number(const std::vector<int>& found, int studies, auto&& is_enough) {
  for (std::size_t n = 2; n < found.size(); ++n)
    if (is_enough(simulated_share(found[n], studies))) return static_cast<int>(n);
  return 0;
}

void check_level(const std::vector<std::string>& levels, const PowerOptions& options,
                 const std::string& level) {
  if (std::ranges::find(levels, level) != levels.end()) return;
  throw Error(fmt::format("no stimulus of the questionnaire has {}: {}", options.factor, level),
              motion::did_you_mean(level, levels));
}

void check(const Manifest& manifest, const PowerOptions& options) {
  const TrialForm& form = *questionnaire_of(manifest).trials;
  if ((form.stimuli > 1 && !form.is_grid) || form.is_detection)
    throw Error(fmt::format("power is estimated for ratings only, but this questionnaire {}",
                            !questionnaire_of(manifest).adaptive.empty() ? "measures thresholds"
                            : form.is_detection                          ? "measures d′"
                            : form.is_set                                ? "compares sets"
                                                                         : "compares pairs"),
                "leave --power out");
  const RatedStimuli rated = rated_stimuli(manifest, trial_subjects(manifest), 1);
  if (rated.shares[0].size() < 2)
    throw Error("no participant sees two stimuli, as a paired test requires",
                "show each participant more stimuli");
  if (options.factor.empty()) return;
  const std::vector<std::string> factors = factors_of(manifest);
  if (std::ranges::find(factors, options.factor) == factors.end())
    throw Error(fmt::format("the stimuli have no factor {}", motion::in_quotes(options.factor)),
                factors.empty() ? "add factors: {…} to the stimuli"
                                : motion::did_you_mean(options.factor, factors));
  std::vector<std::string> levels;
  for (const std::string& stimulus : rated.ids)
    levels.push_back(level_of(manifest, stimulus, options.factor));
  std::erase(levels, "");
  check_level(levels, options, options.level);
  check_level(levels, options, options.other_level);
}

/// "1 point", "0.5 points"
std::string points_text(double points) {
  return fmt::format("{:g} point{}", points, points == 1.0 ? "" : "s");
}

std::string number_or_more(int number, int most) {
  return number == 0 ? fmt::format("more than {}", most) : std::to_string(number);
}

}  // namespace

SimulatedShare simulated_share(int successes, int trials) {
  const ShareInterval interval = wilson(successes, trials);
  return {static_cast<double>(successes) / trials, interval.low, interval.high};
}

PowerEstimate estimate_power(const Manifest& manifest, const PowerOptions& options) {
  check(manifest, options);
  const int planned = questionnaire_of(manifest).participants;
  const auto is_wanted = [&](const SimulatedShare& share) {
    return share.low >= options.wanted_power;
  };
  for (int horizon = std::max(64, planned);; horizon *= 2) {
    const int most = std::max(planned, std::min(horizon, options.max_participants));
    PowerSimulation simulation(manifest, options, most);
    simulation.run();
    const auto least = [&](auto&& is_enough) {
      return least_number(simulation.found, options.studies, is_enough);
    };
    const int high = least(is_wanted);
    if (high == 0 && most < options.max_participants) continue;
    const auto at = static_cast<std::size_t>(planned);
    return {
        .participants = planned,
        .power = simulated_share(simulation.found[at], options.studies),
        .false_positives = simulated_share(simulation.alarms[at], options.studies),
        .usable = simulation.usable[at] / options.studies,
        .needed = least([&](const auto& share) { return share.share >= options.wanted_power; }),
        .needed_low = least([&](const auto& share) { return share.high >= options.wanted_power; }),
        .needed_high = high};
  }
}

bool is_false_positive_rate_inflated(const PowerOptions& options, const PowerEstimate& estimate) {
  return !options.factor.empty() && options.spread.stimulus > 0.0 &&
         estimate.false_positives.low > options.alpha;
}

std::vector<std::string> power_sentences(const PowerOptions& options,
                                         const PowerEstimate& estimate) {
  const RatingSpread& spread = options.spread;
  const std::string compared =
      options.factor.empty()
          ? "two stimuli"
          : fmt::format("{} {} and {}", options.factor, options.level, options.other_level);
  const auto percent = [](const SimulatedShare& share) {
    return fmt::format("{:.1f} % ({:.1f} to {:.1f} %)", 100.0 * share.share, 100.0 * share.low,
                       100.0 * share.high);
  };
  return {
      fmt::format("Standard deviations: participants {:.2f}, stimuli {:.2f}, residual SD {:.2f}.",
                  spread.participant, spread.stimulus, spread.residual),
      fmt::format("Power to detect a difference of {} between {} (paired t test, α = {:g}): {} of "
                  "{} simulated studies, with {} planned participants, of whom {:.1f} see both.",
                  points_text(options.difference), compared, options.alpha, percent(estimate.power),
                  options.studies, estimate.participants, estimate.usable),
      fmt::format("False-positive rate without a true difference: {}.",
                  percent(estimate.false_positives)),
      is_false_positive_rate_inflated(options, estimate)
          ? fmt::format(
                "No sample size reported: a test over participants mistakes differences between "
                "these particular stimuli for a difference between the levels, and does so more "
                "often the more participants there are. Use more stimuli per level, fit a model "
                "with stimuli as a random effect (analysis/lme4.R of the report), or estimate "
                "power for these particular stimuli: --spread {:g},0,{:g}.",
                spread.participant, spread.residual)
          : fmt::format(
                "Sample size for {:g} % power: {} participants (simulation interval {} to {}).",
                100.0 * options.wanted_power,
                number_or_more(estimate.needed, options.max_participants),
                number_or_more(estimate.needed_low, options.max_participants),
                number_or_more(estimate.needed_high, options.max_participants))};
}

}  // namespace mien::pipeline

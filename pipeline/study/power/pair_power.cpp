#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "motion/error.h"
#include "motion/math/random_number.h"
#include "pipeline/base/statistics/named_random.h"
#include "pipeline/manifest/questionnaire_content.h"
#include "pipeline/study/power/assumed_effects.h"
#include "pipeline/study/power/one_size_power.h"
#include "pipeline/study/questionnaire/orders.h"
#include "pipeline/study/questionnaire/trial_subjects.h"
#include "pipeline/study/results/pair_worth.h"

namespace mien::pipeline {

namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

/// A planned contrast of worths on a scale, and its counts over studies by number of participants.
struct WorthTest {
  std::size_t scale = 0;
  std::string name;
  double assumed = no_number;
  struct Count {
    int possible = 0;
    int found = 0;
    int alarms = 0;
  };
  std::vector<Count> counts;
};

/// Assumed means of stimuli on each scale, and the tests whose power they give.
struct AssumedMeans {
  std::vector<std::vector<double>> means;
  std::vector<std::size_t> tests;
};

/// A pair that a participant compares.
struct ComparedPair {
  std::size_t person = 0;
  std::size_t left = 0;
  std::size_t right = 0;
};

/// The studies with one number of stimuli per cell. Stimuli are those of the manifest.
class PairPower {
 public:
  PairPower(const Manifest& manifest, const PlannedPowerOptions& options)
      : manifest_(manifest),
        options_(options),
        plan_(questionnaire_of(manifest).analysis),
        scales_(questionnaire_scales(manifest).scales),
        responses_(response_scales_by_item(manifest)) {
    begin_answers();
    take_pairs();
    make_tests();
  }

  void run(const std::function<void(double)>& progress) {
    for (int study = 0; study < options_.studies; ++study) {
      progress(static_cast<double>(study) / options_.studies);
      stream_ = motion::random_bits(hashed_seed(options_.seed, "planned power"),
                                    static_cast<std::uint64_t>(study));
      count_tests(no_means(),
                  [](WorthTest::Count& count, const WorthContrast& contrast, double alpha) {
                    count.possible += !std::isnan(contrast.p);
                    count.alarms += contrast.p < alpha;
                  });
      for (const AssumedMeans& assumption : assumptions_)
        count_tests(assumption, [](WorthTest::Count& count, const WorthContrast& contrast,
                                   double alpha) { count.found += contrast.adjusted < alpha; });
    }
  }

  std::vector<PlannedTestPower> rows(int per_cell) const {
    std::vector<PlannedTestPower> rows;
    for (const WorthTest& test : tests_) {
      for (std::size_t size = 0; size < options_.participants.size(); ++size) {
        const int people = options_.participants[size];
        PlannedTestPower row{.is_contrast = true,
                             .name = test.name,
                             .scale = scales_[test.scale].id,
                             .by = TestedBy::participants,
                             .participants = people,
                             .stimuli_per_cell = per_cell,
                             .people = static_cast<double>(people),
                             .assumed = test.assumed};
        const WorthTest::Count& count = test.counts[size];
        set_power(row, count.found, count.alarms, count.possible);
        rows.push_back(std::move(row));
      }
    }
    return rows;
  }

 private:
  void begin_answers() {
    answers_.form = questionnaire_of(manifest_).trials;
    for (const Stimulus& stimulus : manifest_.stimuli)
      answers_.stimuli.push_back({.id = stimulus.id, .factors = levels_of(stimulus)});
    answers_.factors = design_table(manifest_);
    answers_.factorial = plan_.factorial;
    answers_.scales = scales_;
    answers_.correction = plan_.correction;
    answers_.alpha = plan_.alpha;
    conditions_ = compared_conditions(answers_);
  }

  std::size_t stimulus_number(const std::string& id) const {
    return static_cast<std::size_t>(std::ranges::find(manifest_.stimuli, id, &Stimulus::id) -
                                    manifest_.stimuli.begin());
  }

  /// The pairs of all participants, each with the sides drawn.
  void take_pairs() {
    const TrialSubjects subjects = trial_subjects(manifest_);
    const auto shares = participant_subjects(
        manifest_, subjects, static_cast<std::size_t>(options_.participants.back()));
    const std::uint64_t sides = hashed_seed(manifest_.seed, "sides of power");
    for (std::size_t person = 0; person < shares.size(); ++person) {
      for (const std::size_t subject : shares[person]) {
        ComparedPair pair{person, stimulus_number(subjects.stimuli[subject][0]),
                          stimulus_number(subjects.stimuli[subject][1])};
        if (random_choice(2, sides, "side", person * subjects.size() + subject) == 1)
          std::swap(pair.left, pair.right);
        pairs_.push_back(pair);
      }
    }
  }

  void make_tests() {
    std::set<std::size_t> compared;
    for (const ComparedPair& pair : pairs_)
      compared.insert({conditions_.of_stimulus[pair.left], conditions_.of_stimulus[pair.right]});
    const std::vector<std::size_t> list(compared.begin(), compared.end());
    for (std::size_t scale = 0; scale < scales_.size(); ++scale) {
      for (const WorthContrast& contrast :
           begun_worth_contrasts(answers_, conditions_, list, scales_[scale].id)) {
        if (contrast.kind != ContrastKind::planned) continue;
        tests_.push_back({.scale = scale, .name = contrast.name});
        tests_.back().counts.resize(options_.participants.size());
        if (!options_.truth) assume(contrast, list);
      }
    }
    if (tests_.empty())
      throw Error("the study plans no contrasts of its conditions",
                  "state them under questionnaire: analysis: {factors: […], contrasts: […]}");
    if (options_.truth) assume_truth();
  }

  AssumedMeans no_means() const {
    return {.means = std::vector<std::vector<double>>(
                scales_.size(), std::vector<double>(manifest_.stimuli.size(), 0.0)),
            .tests = {}};
  }

  /// The smallest means of conditions that give the last test's contrast the assumed value.
  void assume(const WorthContrast& contrast, const std::vector<std::size_t>& compared) {
    WorthTest& test = tests_.back();
    test.assumed = options_.difference;
    AssumedMeans alone = no_means();
    alone.tests = {tests_.size() - 1};
    double squares = 0.0;
    for (const double weight : contrast.of) squares += weight * weight;
    for (std::size_t i = 0; i < manifest_.stimuli.size(); ++i) {
      const auto place = std::ranges::find(compared, conditions_.of_stimulus[i]);
      if (place != compared.end())
        alone.means[test.scale][i] =
            options_.difference / squares *
            contrast.of[static_cast<std::size_t>(place - compared.begin())];
    }
    assumptions_.push_back(std::move(alone));
  }

  void assume_truth() {
    std::vector<std::string> ids;
    for (const Stimulus& stimulus : manifest_.stimuli) ids.push_back(stimulus.id);
    AssumedMeans stated;
    for (const Scale& scale : scales_)
      stated.means.push_back(cell_truth(manifest_, *options_.truth, ids, scale));
    for (std::size_t test = 0; test < tests_.size(); ++test) stated.tests.push_back(test);
    assumptions_.push_back(std::move(stated));
  }

  /// Answers of a simulated study in the order of participants.
  std::vector<AnalysedPreference> answers_to(const AssumedMeans& assumption) const {
    std::vector<AnalysedPreference> answers;
    const std::vector<std::string> no_choices;
    const Trial trial{.kind = &pair_trials};
    for (std::size_t place = 0; place < pairs_.size(); ++place) {
      const ComparedPair& pair = pairs_[place];
      for (std::size_t scale = 0; scale < scales_.size(); ++scale) {
        const RatingSpread& spread = spread_for(options_.spreads, scales_[scale].id);
        const std::uint64_t own = hashed_seed(stream_, scales_[scale].id);
        const auto opinion = [&](std::size_t which) {
          const std::size_t stimulus = which == 0 ? pair.left : pair.right;
          const std::uint64_t of_cell =
              pair.person * manifest_.stimuli.size() + conditions_.of_stimulus[stimulus];
          return assumption.means[scale][stimulus] +
                 spread.stimulus * normal_number(motion::random_bits(own, 1), stimulus) +
                 spread.participant_by_cell * normal_number(motion::random_bits(own, 2), of_cell) +
                 spread.residual * normal_number(motion::random_bits(own, 3), 2 * place + which);
        };
        const TrialItem item{.item = scales_[scale].id};
        const std::string raw = pair_trials.simulated(
            {trial, item, find_scale(responses_, item.item), no_choices}, {.opinion = opinion});
        const bool is_left = raw.starts_with("left");
        const bool is_tie = raw == tie_value;
        answers.push_back({.person = pair.person,
                           .chosen = is_left || is_tie ? pair.left : pair.right,
                           .other = is_left || is_tie ? pair.right : pair.left,
                           .item = item.item,
                           .is_left_chosen = is_left || is_tie,
                           .is_tie = is_tie});
      }
    }
    return answers;
  }

  /// Tests the studies with each number of participants, and counts the tests of the assumption or,
  /// if it has none, all.
  void count_tests(const AssumedMeans& assumption, auto&& count) {
    const std::vector<AnalysedPreference> answers = answers_to(assumption);
    for (std::size_t size = 0; size < options_.participants.size(); ++size) {
      const auto people = static_cast<std::size_t>(options_.participants[size]);
      const auto end = std::ranges::find_if(
          answers, [&](const AnalysedPreference& answer) { return answer.person >= people; });
      answers_.preferences.assign(answers.begin(), end);
      for (const PairWorth& worth :
           worths_of(answers_, {.resamples = power_resamples, .only_planned = true}))
        for (const WorthContrast& contrast : worth.contrasts)
          count_contrast(assumption, worth.item, contrast, size, count);
    }
  }

  void count_contrast(const AssumedMeans& assumption, const std::string& item,
                      const WorthContrast& contrast, std::size_t size, auto&& count) {
    for (std::size_t test = 0; test < tests_.size(); ++test) {
      const bool is_it =
          scales_[tests_[test].scale].id == item && tests_[test].name == contrast.name;
      const bool is_asked = assumption.tests.empty() ||
                            std::ranges::find(assumption.tests, test) != assumption.tests.end();
      if (is_it && is_asked) count(tests_[test].counts[size], contrast, plan_.alpha);
    }
  }

  const Manifest& manifest_;
  const PlannedPowerOptions& options_;
  const AnalysisPlan& plan_;
  std::vector<Scale> scales_;
  ResponseScales responses_;
  AnswerSet answers_;
  ComparedConditions conditions_;
  std::vector<ComparedPair> pairs_;
  std::vector<WorthTest> tests_;
  std::vector<AssumedMeans> assumptions_;
  std::uint64_t stream_ = 0;
};

}  // namespace

std::vector<PlannedTestPower> pair_power(const Manifest& manifest,
                                         const PlannedPowerOptions& options, int stimuli_per_cell,
                                         const std::function<void(double)>& progress) {
  const TrialForm& form = *questionnaire_of(manifest).trials;
  if (form.is_set || form.is_detection || &form == &same_different_form ||
      questionnaire_scales(manifest).scales.empty())
    throw Error("this questionnaire asks neither for ratings nor for preferences on scales",
                "leave the power of planned tests out");
  PairPower power(manifest, options);
  power.run(progress);
  return power.rows(stimuli_per_cell);
}

}  // namespace mien::pipeline

#include <algorithm>
#include <cmath>
#include <limits>

#include "motion/math/random_number.h"
#include "pipeline/base/statistics/named_random.h"
#include "pipeline/manifest/questionnaire_content.h"
#include "pipeline/study/power/assumed_effects.h"
#include "pipeline/study/power/one_size_power.h"
#include "pipeline/study/power/planned_design.h"
#include "pipeline/study/power/scale_tests.h"
#include "pipeline/study/questionnaire/orders.h"
#include "pipeline/study/results/comparisons.h"

namespace mien::pipeline {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr double not_seen = std::numeric_limits<double>::quiet_NaN();

/// A test on a scale: an effect or a contrast, by its number in ScaleTests::tests.
struct TestOnScale {
  std::size_t scale = 0;
  std::size_t number = 0;
  const DesignContrast* contrast = nullptr;
  std::size_t effect = 0;  ///< without a contrast
};

/// An assumption about true effects, and the tests whose power it gives.
struct Assumption {
  std::vector<MatrixXd> shifts;    ///< of each scale (ScaleTests::tests)
  std::vector<std::size_t> tests;  ///< indices of TestOnScale
  std::vector<bool> differs;       ///< whether the shift of each scale is not 0
};

std::vector<TestOnScale> tests_of(const PlannedDesign& design) {
  std::vector<TestOnScale> tests;
  for (std::size_t scale = 0; scale < design.scales.size(); ++scale) {
    std::size_t number = 0;
    for (std::size_t effect = 0; effect < design.effects.size(); ++effect)
      tests.push_back({scale, number++, nullptr, effect});
    for (const DesignContrast& contrast : design.contrasts)
      if (contrast.scales[scale]) tests.push_back({scale, number++, &contrast});
  }
  return tests;
}

/// The studies with one number of stimuli per cell.
class RatingPower {
 public:
  RatingPower(const Manifest& manifest, const PlannedPowerOptions& options, int per_cell)
      : manifest_(manifest),
        options_(options),
        per_cell_(per_cell),
        design_(planned_design(manifest, static_cast<std::size_t>(options.participants.back()),
                               options.groups)),
        tests_(tests_of(design_)),
        none_(MatrixXd::Zero(static_cast<Index>(design_.group_count),
                             static_cast<Index>(design_.stimuli.size()))) {
    for (const Scale& scale : design_.scales)
      spreads_.push_back(spread_for(options.spreads, scale.id));
    // A cell has the number of the first stimulus with the same levels.
    const auto& rows = design_.factors.rows;
    for (const auto& row : rows)
      cells_.push_back(static_cast<std::size_t>(std::ranges::find(rows, row) - rows.begin()));
    make_assumptions();
    counts_.resize(options.participants.size() * tests_.size() * 2);
    people_.assign(options.participants.size() * design_.scales.size(), 0.0);
  }

  void run(const std::function<void(double)>& progress) {
    for (int study = 0; study < options_.studies; ++study) {
      if (study % 10 == 0) progress(static_cast<double>(study) / options_.studies);
      run_study(study);
    }
  }

  std::vector<PlannedTestPower> rows() const {
    std::vector<PlannedTestPower> rows;
    for (std::size_t test = 0; test < tests_.size(); ++test)
      for (const TestedBy by : {TestedBy::participants, TestedBy::participants_and_stimuli})
        for (std::size_t size = 0; size < options_.participants.size(); ++size)
          add_row(test, by, size, rows);
    return rows;
  }

 private:
  struct Count {
    int possible = 0;
    int found = 0;
    int alarms = 0;
  };

  void make_assumptions() {
    assumed_.assign(tests_.size(), not_seen);
    if (options_.truth) {
      Assumption stated{.shifts = {}, .tests = {}, .differs = {}};
      for (const Scale& scale : design_.scales) {
        const std::vector<double> means =
            cell_truth(manifest_, *options_.truth, design_.stimuli, scale);
        MatrixXd shift = none_;
        for (std::size_t i = 0; i < means.size(); ++i)
          shift.col(static_cast<Index>(i)).setConstant(means[i]);
        stated.shifts.push_back(shift);
        stated.differs.push_back(true);
      }
      for (std::size_t test = 0; test < tests_.size(); ++test) {
        if (is_of_groups(tests_[test])) continue;
        stated.tests.push_back(test);
        if (tests_[test].contrast != nullptr)
          assumed_[test] = value_of(*tests_[test].contrast, stated.shifts[tests_[test].scale]);
      }
      assumptions_.push_back(std::move(stated));
    }
    for (std::size_t test = 0; test < tests_.size(); ++test) {
      const TestOnScale& one = tests_[test];
      if (options_.truth && !is_of_groups(one)) continue;
      Assumption alone{.shifts = std::vector<MatrixXd>(design_.scales.size(), none_),
                       .tests = {test},
                       .differs = std::vector<bool>(design_.scales.size(), false)};
      alone.shifts[one.scale] =
          options_.difference * (one.contrast != nullptr
                                     ? contrast_shift(design_, *one.contrast)
                                     : effect_shift(design_, design_.terms[one.effect]));
      alone.differs[one.scale] = true;
      assumed_[test] = options_.difference;
      assumptions_.push_back(std::move(alone));
    }
  }

  bool is_of_groups(const TestOnScale& test) const {
    return test.contrast == nullptr && design_.terms[test.effect].by_group;
  }

  /// The ratings of a simulated study, without effects of the cells.
  MatrixXd ratings_of(std::uint64_t stream, const RatingSpread& spread) const {
    const auto people = static_cast<Index>(design_.shares.size());
    const std::size_t stimuli = design_.stimuli.size();
    const std::uint64_t of_people = motion::random_bits(stream, 0);
    const std::uint64_t of_stimuli = motion::random_bits(stream, 1);
    const std::uint64_t of_cells = motion::random_bits(stream, 2);
    const std::uint64_t of_rest = motion::random_bits(stream, 3);
    MatrixXd ratings = MatrixXd::Constant(people, static_cast<Index>(stimuli), not_seen);
    for (Index person = 0; person < people; ++person) {
      const auto number = static_cast<std::uint64_t>(person);
      const double own = spread.participant * normal_number(of_people, number);
      for (const std::size_t stimulus : design_.shares[static_cast<std::size_t>(person)]) {
        const std::uint64_t place = number * stimuli + stimulus;
        double rating = own + spread.residual * normal_number(of_rest, place);
        if (spread.stimulus > 0.0) rating += spread.stimulus * normal_number(of_stimuli, stimulus);
        if (spread.participant_by_cell > 0.0)
          rating += spread.participant_by_cell *
                    normal_number(of_cells, number * stimuli + cells_[stimulus]);
        ratings(person, static_cast<Index>(stimulus)) = rating;
      }
    }
    return ratings;
  }

  void run_study(int study) {
    const std::uint64_t stream = motion::random_bits(hashed_seed(options_.seed, "planned power"),
                                                     static_cast<std::uint64_t>(study));
    std::vector<MatrixXd> ratings;
    for (std::size_t scale = 0; scale < spreads_.size(); ++scale)
      ratings.push_back(ratings_of(hashed_seed(stream, design_.scales[scale].id), spreads_[scale]));
    const RandomParticipants random = questionnaire_of(manifest_).analysis.factorial.random_slopes
                                          ? RandomParticipants::slopes
                                          : RandomParticipants::intercepts;
    for (std::size_t size = 0; size < options_.participants.size(); ++size) {
      std::vector<ScaleTests> scales;
      std::vector<std::vector<TestedTwice>> null;
      for (std::size_t scale = 0; scale < ratings.size(); ++scale) {
        scales.emplace_back(design_, scale, ratings[scale].topRows(options_.participants[size]),
                            random);
        null.push_back(scales.back().tests(none_));
        people_[size * spreads_.size() + scale] += scales.back().people();
      }
      count_alarms(size, null);
      for (const Assumption& assumption : assumptions_) {
        std::vector<std::vector<TestedTwice>> found = null;
        for (std::size_t scale = 0; scale < scales.size(); ++scale)
          if (assumption.differs[scale])
            found[scale] = scales[scale].tests(assumption.shifts[scale]);
        count_found(size, found, assumption);
      }
    }
  }

  static double p_of(const std::vector<std::vector<TestedTwice>>& all, const TestOnScale& test,
                     TestedBy by) {
    const TestedTwice& tested = all[test.scale][test.number];
    return by == TestedBy::participants ? tested.by_participants : tested.by_both;
  }

  Count& count_of(std::size_t size, std::size_t test, TestedBy by) {
    return counts_[place_of(size, test, by)];
  }

  std::size_t place_of(std::size_t size, std::size_t test, TestedBy by) const {
    return (size * tests_.size() + test) * 2 + (by == TestedBy::participants ? 0 : 1);
  }

  void count_alarms(std::size_t size, const std::vector<std::vector<TestedTwice>>& null) {
    const double alpha = questionnaire_of(manifest_).analysis.alpha;
    for (std::size_t test = 0; test < tests_.size(); ++test) {
      for (const TestedBy by : {TestedBy::participants, TestedBy::participants_and_stimuli}) {
        const double p = p_of(null, tests_[test], by);
        count_of(size, test, by).possible += !std::isnan(p);
        count_of(size, test, by).alarms += p < alpha;
      }
    }
  }

  /// Effects on all scales form a family, and planned contrasts another one.
  void count_found(std::size_t size, const std::vector<std::vector<TestedTwice>>& all,
                   const Assumption& assumption) {
    const AnalysisPlan& plan = questionnaire_of(manifest_).analysis;
    for (const TestedBy by : {TestedBy::participants, TestedBy::participants_and_stimuli}) {
      for (const bool are_contrasts : {false, true}) {
        std::vector<std::size_t> family;
        std::vector<double> p_values;
        for (std::size_t test = 0; test < tests_.size(); ++test) {
          if ((tests_[test].contrast != nullptr) != are_contrasts) continue;
          family.push_back(test);
          p_values.push_back(p_of(all, tests_[test], by));
        }
        const std::vector<double> adjusted = corrected(p_values, plan.correction);
        for (std::size_t i = 0; i < family.size(); ++i)
          if (std::ranges::find(assumption.tests, family[i]) != assumption.tests.end())
            count_of(size, family[i], by).found += adjusted[i] < plan.alpha;
      }
    }
  }

  void add_row(std::size_t test, TestedBy by, std::size_t size,
               std::vector<PlannedTestPower>& rows) const {
    const Count& count = counts_[place_of(size, test, by)];
    if (count.possible == 0 && by == TestedBy::participants_and_stimuli) return;
    const TestOnScale& one = tests_[test];
    PlannedTestPower row{
        .is_contrast = one.contrast != nullptr,
        .name = one.contrast != nullptr ? one.contrast->name : design_.effects[one.effect],
        .scale = design_.scales[one.scale].id,
        .by = by,
        .participants = options_.participants[size],
        .stimuli_per_cell = per_cell_,
        .people = people_[size * spreads_.size() + one.scale] / options_.studies,
        .assumed = assumed_[test]};
    set_power(row, count.found, count.alarms, count.possible);
    rows.push_back(std::move(row));
  }

  const Manifest& manifest_;
  const PlannedPowerOptions& options_;
  int per_cell_;
  PlannedDesign design_;
  std::vector<TestOnScale> tests_;
  MatrixXd none_;
  std::vector<std::size_t> cells_;  ///< cell of each stimulus
  std::vector<RatingSpread> spreads_;
  std::vector<Assumption> assumptions_;
  std::vector<double> assumed_;  ///< by test
  std::vector<Count> counts_;    ///< by number of participants, test and TestedBy
  std::vector<double> people_;   ///< summed over studies, by number of participants and scale
};

}  // namespace

std::vector<PlannedTestPower> rating_power(const Manifest& manifest,
                                           const PlannedPowerOptions& options, int stimuli_per_cell,
                                           const std::function<void(double)>& progress) {
  RatingPower power(manifest, options, stimuli_per_cell);
  power.run(progress);
  return power.rows();
}

}  // namespace mien::pipeline

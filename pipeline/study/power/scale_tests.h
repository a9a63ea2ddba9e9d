#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "pipeline/base/statistics/crossed_test.h"
#include "pipeline/study/power/planned_design.h"

namespace mien::pipeline {

/// p values of a planned test, not adjusted for the number of tests. NaN if the test is not
/// possible.
struct TestedTwice {
  double by_participants;  ///< of the report: analysis of variance (Greenhouse and Geisser), t test
  double by_both;          ///< with participants and stimuli as random effects (crossed_test)
};

/// The planned tests of the ratings of one scale, to which assumed effects are added afterwards:
/// they shift the means of cells and change no error term.
class ScaleTests {
 public:
  /// `ratings` has a row for each participant, the first of the design, and a column for each
  /// stimulus; NaN where a participant did not rate it. Participants who did not rate every cell of
  /// a test are left out of it, as in the report.
  ScaleTests(const PlannedDesign& design, std::size_t scale, const Eigen::MatrixXd& ratings,
             RandomParticipants random);

  /// The effects of the design, then its contrasts that are tested on this scale. `shift` has the
  /// assumed mean of each stimulus (a column) in each group (a row); it must be the same for all
  /// stimuli of a cell.
  std::vector<TestedTwice> tests(const Eigen::MatrixXd& shift) const;

  /// Number of participants of the analysis of variance; without one, of the first contrast.
  int people() const;

 private:
  struct Scores {
    const DesignContrast* contrast;
    std::vector<double> scores;  ///< of the participants who rated all of its cells
    CrossedSquares squares;      ///< of the cells in which stimuli are compared
    Eigen::VectorXd weights;     ///< of these cells
    bool is_crossed = false;
  };

  void add_cells(const Eigen::MatrixXd& ratings);
  void add_contrast(const DesignContrast& contrast, const Eigen::MatrixXd& ratings);
  void add_effect_tests(const Eigen::MatrixXd& shift, std::vector<TestedTwice>& tests) const;
  TestedTwice test_of(const Scores& one, const Eigen::MatrixXd& shift) const;

  const PlannedDesign& design_;
  RandomParticipants random_;
  Eigen::MatrixXd cells_;            ///< complete participants' means of the cells of the crossing
  std::vector<std::size_t> groups_;  ///< of these participants
  bool has_effects_ = false;
  CrossedSquares squares_;
  bool is_crossed_ = false;
  std::vector<Scores> contrasts_;
};

}  // namespace mien::pipeline

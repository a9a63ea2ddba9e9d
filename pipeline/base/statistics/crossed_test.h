#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

namespace mien::pipeline {

/// Ratings in a design in which participants and stimuli are crossed: each participant rated every
/// stimulus, and every stimulus belongs to one cell (a combination of levels of the factors).
struct CrossedRatings {
  Eigen::MatrixXd ratings;          ///< a row for each participant, a column for each stimulus
  std::vector<std::size_t> cells;   ///< cell of each stimulus, 0 … count − 1; each occurs
  std::vector<std::size_t> groups;  ///< group of each participant, 0 … count − 1, or empty
};

/// Means and sums of squares of crossed ratings, participants' deviations being those from the
/// means of their group.
struct CrossedSquares {
  Eigen::VectorXd cell_means;           ///< means over groups of equal weight
  Eigen::MatrixXd person_deviations;    ///< of each participant's mean of each cell
  std::vector<double> stimuli_of_cell;  ///< number of stimuli of each cell
  double people = 0.0;  ///< number of participants; with groups, that of equally large groups
                        ///< whose mean has the same variance
  double person_degrees = 0.0;    ///< participants less groups
  double stimulus_squares = 0.0;  ///< of the stimuli's means within cells
  double stimulus_degrees = 0.0;  ///< stimuli less cells
  double within_squares = 0.0;    ///< of participants × stimuli within cells
  double within_degrees = 0.0;
  double all_squares = 0.0;  ///< of participants × stimuli, also between cells
  double all_degrees = 0.0;
};

CrossedSquares crossed_squares(const CrossedRatings& ratings);

/// The random effects of participants. Stimuli always have random intercepts.
enum class RandomParticipants {
  intercepts,  ///< participants differ in their mean only
  slopes,      ///< they also differ in the tested effect
};

/// An F test. All numbers are NaN if no cell has two stimuli: differences between stimuli are then
/// part of those between cells.
struct CrossedTest {
  double f;
  double degrees;
  double error_degrees;  ///< by Satterthwaite (1946)
  double p;
};

/// Tests an effect of the cells with participants and stimuli as crossed random effects. The effect
/// is spanned by the columns of `contrasts` (a row for each cell), which must be orthogonal, of the
/// same length, and have sums of 0. `shift` is added to the means of the cells.
///
/// The error term is that of the mixed model, estimated by expected mean squares: with slopes
/// MS(participants × effect) + MS(stimuli) − MS(participants × stimuli), which is Clark's quasi-F
/// (1973), otherwise MS(stimuli); degrees of freedom by Satterthwaite (1946). Variances with
/// negative estimates are 0, and their mean squares are pooled with those below. In designs with
/// equally many stimuli in each cell the result is that of restricted maximum likelihood with
/// Satterthwaite's degrees of freedom, except for several degrees of freedom of the effect with
/// slopes, which assumes sphericity. With different numbers of stimuli, an effect with one degree
/// of freedom has its exact variance, others that of the harmonic mean of the numbers.
CrossedTest crossed_test(const CrossedSquares& squares, const Eigen::MatrixXd& contrasts,
                         RandomParticipants participants, const Eigen::VectorXd& shift);

}  // namespace mien::pipeline

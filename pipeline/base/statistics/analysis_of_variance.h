#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

namespace mien::pipeline {

/// A main effect or an interaction in an analysis of variance, tested against its own error term.
struct VarianceEffect {
  /// Indices of the factors within participants, ascending; empty for the main effect of groups.
  std::vector<std::size_t> factors;
  bool by_group = false;  ///< whether groups of participants are one of the effect's factors

  double squares = 0.0;        ///< sum of squares of the effect
  double degrees = 0.0;        ///< its degrees of freedom, not corrected
  double error_squares = 0.0;  ///< sum of squares of the error term
  double error_degrees = 0.0;  ///< its degrees of freedom, not corrected
  /// NaN, like p, p_corrected and the effect sizes, if the error term is 0.
  double f = 0.0;
  double p = 1.0;  ///< assuming sphericity
  /// Estimate of the departure from sphericity, 1/degrees … 1 (Greenhouse and Geisser 1959). 1 for
  /// effects without factors within participants and for those of factors with two levels.
  double epsilon = 1.0;
  double p_corrected = 1.0;  ///< with both degrees of freedom multiplied by epsilon
  double partial_eta = 0.0;  ///< partial η²: squares/(squares + error_squares)
  /// 90 % interval of partial η² (partial_eta_interval), with the corrected degrees of freedom.
  double partial_eta_low = 0.0;
  double partial_eta_high = 0.0;
  /// Generalized η² (Olejnik and Algina 2003; Bakeman 2005): factors within participants are
  /// manipulated, groups are measured.
  double generalized_eta = 0.0;
};

/// An effect of an analysis of variance, without its test.
struct VarianceTerm {
  std::vector<std::size_t> factors;  ///< as in VarianceEffect
  bool by_group = false;
};

/// The effects of so many factors within participants, in the order of analysis_of_variance.
std::vector<VarianceTerm> variance_terms(std::size_t factors, bool has_groups);

/// Orthonormal contrasts between cells, a column each, that span the effect of these factors: the
/// last factor's levels vary fastest.
Eigen::MatrixXd effect_contrasts(const std::vector<std::size_t>& factors,
                                 const std::vector<int>& levels);

/// Whether the intervals of effect sizes are computed, which takes longest.
enum class EffectIntervals { computed, omitted };

/// Analysis of variance of repeated measures, with or without groups of participants of possibly
/// different sizes. Each effect is tested by the orthonormal contrasts that span it, as in a
/// multivariate linear model (type III sums of squares: all group means have equal weight).
///
/// `cells` has a row for each participant and a column for each combination of levels, the levels
/// of the last factor varying fastest; all must be finite. `levels` are the numbers of levels of
/// the factors, each at least 2. `groups` is empty or gives the group, 0 … n − 1, of each
/// participant; every group must occur, and there must be more participants than groups.
///
/// Effects are sorted by the number of their factors within participants, then by these; each is
/// followed by its interaction with groups, and the main effect of groups comes first.
std::vector<VarianceEffect> analysis_of_variance(
    const Eigen::MatrixXd& cells, const std::vector<int>& levels,
    const std::vector<std::size_t>& groups = {},
    EffectIntervals intervals = EffectIntervals::computed);

/// The half width of a confidence interval of each cell's mean for comparisons within
/// participants: participants' means are removed (Cousineau 2005), and the variance is multiplied
/// by cells/(cells − 1) (Morey 2008). `cells` as above, of a single group, with at least two rows
/// and two columns.
Eigen::VectorXd within_participant_margins(const Eigen::MatrixXd& cells, double confidence);

}  // namespace mien::pipeline

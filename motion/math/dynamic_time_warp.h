#pragma once

#include <vector>

#include <Eigen/Core>

namespace mien::motion {

/// Returns, for each row of `from`, the corresponding (fractional) row of `to`, ascending. `to` is
/// first stretched uniformly to the length of `from`; then dynamic programming finds the path of
/// least summed squared distance from the first rows to the last, with a slope between ½ and 2
/// (Bruderlin and Williams 1995 after Sakoe and Chiba 1978). Among equally good steps, the diagonal
/// one (1, 1) is taken.
///
/// Rows are frames, columns are signals. Both have the same number of columns (≥ 1) and at least 2
/// rows.
std::vector<double> dynamic_time_warp(const Eigen::MatrixXd& from, const Eigen::MatrixXd& to);

/// `signals` at fractional row indices, by linear interpolation.
Eigen::MatrixXd rows_at(const Eigen::MatrixXd& signals, const std::vector<double>& rows);

}  // namespace mien::motion

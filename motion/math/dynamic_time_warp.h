#pragma once

#include <vector>

#include <Eigen/Core>

namespace mien::motion {

/// Returns, for each row of `from`, the corresponding (fractional) row of `to`, ascending. `to` is
/// first stretched uniformly to the length of `from`; then dynamic programming finds the path, from
/// the first rows to the last and with a slope between ½ and 2, along which the sum of squared
/// distances is least (Bruderlin and Williams 1995 after Sakoe and Chiba 1978). Among equally good
/// steps, the diagonal one (1, 1) is taken.
///
/// Rows are frames, columns are signals. `from` and `to` have the same number of columns (≥ 1) and
/// at least 2 rows each.
std::vector<double> dynamic_time_warp(const Eigen::MatrixXd& from, const Eigen::MatrixXd& to);

/// `signals` (at least 2 rows) at fractional row indices, by linear interpolation. Indices are
/// clamped to the rows.
Eigen::MatrixXd rows_at(const Eigen::MatrixXd& signals, const std::vector<double>& rows);

}  // namespace mien::motion

#pragma once

#include <vector>

#include <Eigen/Core>

namespace mien::motion {

/// For each row of `from`, the row of `to` (fractions between) that corresponds: `to` is stretched
/// evenly to the length of `from`, then the path of least summed squared distance from the first
/// rows to the last ones is found among those whose slope stays between ½ and 2 (dynamic
/// programming; Bruderlin and Williams 1995 after Sakoe and Chiba 1978). Ascending; of equally good
/// paths the one with the most steps (1, 1).
///
/// Rows are moments, columns signals, equally many (≥ 1); both have at least 2 rows.
std::vector<double> dynamic_time_warp(const Eigen::MatrixXd& from, const Eigen::MatrixXd& to);

/// Rows of `signals` at fractions of a row, linearly between them.
Eigen::MatrixXd rows_at(const Eigen::MatrixXd& signals, const std::vector<double>& rows);

}  // namespace mien::motion

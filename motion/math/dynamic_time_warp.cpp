#include "motion/math/dynamic_time_warp.h"

#include <algorithm>
#include <limits>

namespace mien::motion {

namespace {

/// How a path came to a cell.
enum class Step : unsigned char { none, diagonal, two_of_to, two_of_from };

struct Cell {
  double cost = std::numeric_limits<double>::infinity();
  Step step = Step::none;
};

}  // namespace

std::vector<double> dynamic_time_warp(const Eigen::MatrixXd& from, const Eigen::MatrixXd& to) {
  const Eigen::Index rows = from.rows();
  const double stretch = static_cast<double>(to.rows() - 1) / static_cast<double>(rows - 1);
  std::vector<double> even;
  std::vector<double> halves;
  for (Eigen::Index i = 0; i < rows; ++i) {
    even.push_back(stretch * static_cast<double>(i));
    halves.push_back(stretch * (static_cast<double>(i) + 0.5));
  }
  const Eigen::MatrixXd at = rows_at(to, even);
  const Eigen::MatrixXd between = rows_at(to, halves);
  const auto distance = [&](Eigen::Index i, const Eigen::MatrixXd& other, Eigen::Index j) {
    return (from.row(i) - other.row(j)).squaredNorm();
  };
  std::vector<std::vector<Cell>> cells(rows, std::vector<Cell>(rows));
  cells[0][0].cost = distance(0, at, 0);
  const auto reach = [&](Cell& cell, const Cell& before, double cost, Step step) {
    if (before.cost + cost < cell.cost) cell = {before.cost + cost, step};
  };
  for (Eigen::Index i = 1; i < rows; ++i) {
    for (Eigen::Index j = 1; j < rows; ++j) {
      Cell& cell = cells[i][j];
      const double here = distance(i, at, j);
      reach(cell, cells[i - 1][j - 1], here, Step::diagonal);
      if (j > 1) reach(cell, cells[i - 1][j - 2], here, Step::two_of_to);
      if (i > 1) {
        const double skipped = distance(i - 1, between, j - 1);
        reach(cell, cells[i - 2][j - 1], here + skipped, Step::two_of_from);
      }
    }
  }
  std::vector<double> path(rows);
  Eigen::Index j = rows - 1;
  for (Eigen::Index i = rows - 1; i > 0;) {
    path[i] = stretch * static_cast<double>(j);
    const Step step = cells[i][j].step;
    if (step == Step::two_of_from) {
      path[i - 1] = stretch * (static_cast<double>(j) - 0.5);
      i -= 2;
      j -= 1;
    } else {
      i -= 1;
      j -= step == Step::two_of_to ? 2 : 1;
    }
  }
  path[0] = 0.0;
  return path;
}

Eigen::MatrixXd rows_at(const Eigen::MatrixXd& signals, const std::vector<double>& rows) {
  Eigen::MatrixXd result(static_cast<Eigen::Index>(rows.size()), signals.cols());
  for (size_t i = 0; i < rows.size(); ++i) {
    const double row = std::clamp(rows[i], 0.0, static_cast<double>(signals.rows() - 1));
    const Eigen::Index whole = std::min(static_cast<Eigen::Index>(row), signals.rows() - 2);
    const double t = row - static_cast<double>(whole);
    result.row(static_cast<Eigen::Index>(i)) =
        t == 0.0 ? Eigen::RowVectorXd(signals.row(whole))
                 : Eigen::RowVectorXd((1.0 - t) * signals.row(whole) + t * signals.row(whole + 1));
  }
  return result;
}

}  // namespace mien::motion

#include "motion/motion_graph/distance_minima.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <thread>
#include <tuple>

namespace mien::motion {

namespace {

constexpr int tile_size = 254;  // windows; with one more at each side 256

/// Sums over each window of what depends on one clip alone.
struct WindowSums {
  Eigen::MatrixXd middle;  ///< mean x and z; 2 × windows
  Eigen::VectorXd square;  ///< mean squared distance from that and from the floor
};

WindowSums window_sums(const PointCloud& cloud, int window) {
  const int count = std::max(0, cloud.frame_count() - window + 1);
  WindowSums sums;
  sums.middle.resize(2, count);
  sums.square.resize(count);
  for (int i = 0; i < count; ++i) {
    sums.middle.col(i) = cloud.mean.middleCols(i, window).rowwise().sum() / window;
    sums.square[i] =
        cloud.square.segment(i, window).sum() / window - sums.middle.col(i).squaredNorm();
  }
  return sums;
}

/// A part of the table of two clips' windows.
struct Tile {
  int a = 0;
  int b = 0;
  int row = 0;
  int column = 0;
};

std::vector<Tile> tiles_of(std::span<const WindowSums> sums, int least_gap) {
  std::vector<Tile> tiles;
  const auto count = static_cast<int>(sums.size());
  for (int a = 0; a < count; ++a) {
    for (int b = a; b < count; ++b) {
      const auto rows = static_cast<int>(sums[static_cast<std::size_t>(a)].square.size());
      const auto columns = static_cast<int>(sums[static_cast<std::size_t>(b)].square.size());
      for (int row = 0; row < rows; row += tile_size) {
        for (int column = 0; column < columns; column += tile_size) {
          if (a == b && column + tile_size <= row + least_gap) continue;
          tiles.push_back({a, b, row, column});
        }
      }
    }
  }
  return tiles;
}

/// Mean along the diagonals: entry (i, j) is that of `window` entries from (i, j) down.
Eigen::MatrixXd diagonal_means(const Eigen::MatrixXd& products, int window) {
  const Eigen::Index rows = products.rows() - window + 1;
  const Eigen::Index columns = products.cols() - window + 1;
  Eigen::MatrixXd sums(rows, columns);
  sums.col(0).setZero();
  sums.row(0).setZero();
  for (int f = 0; f < window; ++f) {
    sums.col(0) += products.col(f).segment(f, rows);
    if (columns > 1) {
      sums.row(0).tail(columns - 1) += products.row(f).segment(f + 1, columns - 1);
    }
  }
  for (Eigen::Index j = 1; j < columns; ++j) {
    sums.col(j).tail(rows - 1) = sums.col(j - 1).head(rows - 1) +
                                 products.col(j - 1 + window).segment(window, rows - 1) -
                                 products.col(j - 1).head(rows - 1);
  }
  return sums / window;
}

/// The squared distances of the windows of a range of rows and columns.
Eigen::MatrixXd squared_distances(const PointCloud& a, const WindowSums& sums_a, int row, int rows,
                                  const PointCloud& b, const WindowSums& sums_b, int column,
                                  int columns, int window) {
  const int more = window - 1;
  const auto level_a = a.level.middleCols(row, rows + more);
  Eigen::MatrixXd along =
      diagonal_means(level_a.transpose() * b.level.middleCols(column, columns + more), window);
  Eigen::MatrixXd turned =
      diagonal_means(level_a.transpose() * b.across.middleCols(column, columns + more), window);
  const Eigen::MatrixXd up = diagonal_means(
      a.up.middleCols(row, rows + more).transpose() * b.up.middleCols(column, columns + more),
      window);
  const auto middle_a = sums_a.middle.middleCols(row, rows);
  const auto middle_b = sums_b.middle.middleCols(column, columns);
  along.noalias() -= middle_a.transpose() * middle_b;
  turned.noalias() -= middle_a.row(0).transpose() * middle_b.row(1);
  turned.noalias() += middle_a.row(1).transpose() * middle_b.row(0);
  Eigen::MatrixXd squares =
      -2.0 * (up.array() + (along.array().square() + turned.array().square()).sqrt());
  squares.colwise() += sums_a.square.segment(row, rows);
  squares.rowwise() += sums_b.square.segment(column, columns).transpose();
  return squares;
}

/// Whether no neighbour is less; of equal ones the first counts. What differs by less than rounding
/// is equal.
bool is_least(const Eigen::MatrixXd& squares, Eigen::Index i, Eigen::Index j) {
  constexpr double rounding = 1e-9;  // m²
  for (Eigen::Index di = -1; di <= 1; ++di) {
    for (Eigen::Index dj = -1; dj <= 1; ++dj) {
      const Eigen::Index r = i + di;
      const Eigen::Index c = j + dj;
      if ((di == 0 && dj == 0) || r < 0 || c < 0 || r >= squares.rows() || c >= squares.cols()) {
        continue;
      }
      const bool before = std::tie(di, dj) < std::tuple<Eigen::Index, Eigen::Index>(0, 0);
      const double more = squares(r, c) - squares(i, j);
      if (before ? more <= rounding : more < -rounding) return false;
    }
  }
  return true;
}

std::vector<DistanceMinimum> minima_in(const Tile& tile, std::span<const PointCloud> clouds,
                                       std::span<const WindowSums> sums,
                                       const MinimaOptions& options) {
  const auto a = static_cast<std::size_t>(tile.a);
  const auto b = static_cast<std::size_t>(tile.b);
  const auto windows_a = static_cast<int>(sums[a].square.size());
  const auto windows_b = static_cast<int>(sums[b].square.size());
  const int row = std::max(0, tile.row - 1);
  const int column = std::max(0, tile.column - 1);
  const int last_row = std::min(windows_a, tile.row + tile_size);
  const int last_column = std::min(windows_b, tile.column + tile_size);
  const Eigen::MatrixXd squares = squared_distances(
      clouds[a], sums[a], row, std::min(windows_a, last_row + 1) - row, clouds[b], sums[b], column,
      std::min(windows_b, last_column + 1) - column, options.window);
  const double most = options.most_metres * options.most_metres;
  std::vector<DistanceMinimum> minima;
  for (int i = tile.row; i < last_row; ++i) {
    for (int j = tile.column; j < last_column; ++j) {
      const double square = squares(i - row, j - column);
      if (square > most || (tile.a == tile.b && j < i + options.least_gap)) continue;
      if (!is_least(squares, i - row, j - column)) continue;
      minima.push_back({tile.a, i, tile.b, j, std::sqrt(std::max(0.0, square))});
    }
  }
  return minima;
}

}  // namespace

std::vector<DistanceMinimum> distance_minima(std::span<const PointCloud> clouds,
                                             const MinimaOptions& options) {
  std::vector<WindowSums> sums;
  for (const PointCloud& cloud : clouds) sums.push_back(window_sums(cloud, options.window));
  const std::vector<Tile> tiles = tiles_of(sums, options.least_gap);
  std::vector<std::vector<DistanceMinimum>> found(tiles.size());
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t t = next++; t < tiles.size(); t = next++) {
      found[t] = minima_in(tiles[t], clouds, sums, options);
    }
  };
  {
    const unsigned processors = std::max(1U, std::thread::hardware_concurrency());
    const unsigned threads =
        options.threads > 0 ? static_cast<unsigned>(options.threads) : processors;
    std::vector<std::thread> others;
    for (unsigned t = 1; t < threads; ++t) others.emplace_back(work);
    work();
    for (std::thread& other : others) other.join();
  }
  std::vector<DistanceMinimum> minima;
  for (const auto& some : found) minima.insert(minima.end(), some.begin(), some.end());
  std::sort(minima.begin(), minima.end(), [](const DistanceMinimum& x, const DistanceMinimum& y) {
    return std::tie(x.clip_a, x.frame_a, x.clip_b, x.frame_b) <
           std::tie(y.clip_a, y.frame_a, y.clip_b, y.frame_b);
  });
  return minima;
}

}  // namespace mien::motion

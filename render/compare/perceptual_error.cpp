#include "render/compare/perceptual_error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <tbb/blocked_range2d.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "render/compare/perceptual_color.h"
#include "render/compare/perceptual_filters.h"
#include "render/compare/picture_difference.h"
#include "render/image/tone.h"
#include "render/math/for_avx2.h"

namespace mien::render {
namespace {

constexpr int tile_width = 256, tile_height = 64;

/// Rows of numbers, so wide that filters may work in whole blocks.
struct Plane {
  std::ptrdiff_t stride = 0;
  std::vector<float> values;

  Plane(int width, int height)
      : stride(width), values(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}
  float* row(int y) { return values.data() + y * stride; }
};

/// Filters and tables that all tiles share.
struct Measure {
  explicit Measure(double pixels_per_degree)
      : contrast(contrast_filters(pixels_per_degree)),
        features(feature_filters(pixels_per_degree)),
        halo(std::max(reach_of(contrast.achromatic), reach_of(features.smooth))) {
    for (std::size_t code = 0; code < linear.size(); ++code)
      linear[code] = static_cast<float>(linear_from_srgb(static_cast<double>(code) / 255.0));
  }

  ContrastFilters contrast;
  FeatureFilters features;
  int halo;  ///< pixels beyond a tile that its filters reach
  std::array<float, 256> linear{};
};

/// Perceptual features of a tile of one picture.
struct Percept {
  Plane l, a, b, edge, point;

  Percept(int width, int height)
      : l(width, height),
        a(width, height),
        b(width, height),
        edge(width, height),
        point(width, height) {}
};

/// Filtered opponent colours of a row to CIELAB with Hunt's effect.
MIEN_FOR_AVX2_TOO void lab_row(const ColorMatrix& to, const ColorMatrix& back, const float* y,
                               const float* cx, const float* cz, int count, float* l, float* a,
                               float* b) {
#pragma omp simd
  for (int i = 0; i < count; ++i) {
    const LinearColor seen = within_cube(linear_from_opponent(back, {y[i], cx[i], cz[i]}));
    const LabColor lab = hunt_lab_from_linear(to, seen);
    l[i] = lab.l;
    a[i] = lab.a;
    b[i] = lab.b;
  }
}

MIEN_FOR_AVX2_TOO void length_row(const float* across, const float* down, int count, float* out) {
#pragma omp simd
  for (int i = 0; i < count; ++i) out[i] = std::sqrt(across[i] * across[i] + down[i] * down[i]);
}

MIEN_FOR_AVX2_TOO void mix_row(const float* wide, const float* narrow, float share, int count,
                               float* out) {
#pragma omp simd
  for (int i = 0; i < count; ++i) out[i] = share * wide[i] + (1.0f - share) * narrow[i];
}

struct PerceptRow {
  const float *l, *a, *b, *edge, *point;
};

PerceptRow row_of(Percept& percept, int y) {
  return {percept.l.row(y), percept.a.row(y), percept.b.row(y), percept.edge.row(y),
          percept.point.row(y)};
}

MIEN_FOR_AVX2_TOO void error_row(const PerceptRow& p, const PerceptRow& q, float largest, int count,
                                 float* errors) {
#pragma omp simd
  for (int i = 0; i < count; ++i) {
    const float distance = hyab({p.l[i], p.a[i], p.b[i]}, {q.l[i], q.a[i], q.b[i]});
    const float color = redistributed(power(distance, color_exponent), largest);
    const float edge = std::abs(p.edge[i] - q.edge[i]);
    const float point = std::abs(p.point[i] - q.point[i]);
    const float feature = std::sqrt(std::numbers::sqrt2_v<float> * 0.5f *
                                    (edge > point ? edge : point));  // q_f = 0.5
    const float error = power(color, feature < 1.0f ? 1.0f - feature : 0.0f);
    errors[i] = error < 1.0f ? error : 1.0f;
  }
}

/// Works on one tile at a time, with planes of its own.
class TilePercepts {
 public:
  TilePercepts(const Measure& measure, int width, int height)
      : measure_(measure),
        width_((width + filter_block - 1) / filter_block * filter_block),
        height_(height),
        y_(width_ + 2 * measure.halo, height + 2 * measure.halo),
        cx_(y_),
        cz_(y_),
        passed_{tall(), tall(), tall(), tall(), tall(), tall(), tall()} {}

  int width() const { return width_; }

  /// Computes the features of the tile of the picture that begins at (x, y).
  void look(const Image8& picture, int x, int y, Percept& percept) {
    load(picture, x, y);
    filter_rows();
    for (int row = 0; row < height_; ++row) finish_row(row, percept);
  }

 private:
  Plane tall() const { return Plane(width_, height_ + 2 * measure_.halo); }
  void load(const Image8& picture, int x, int y);
  void filter_rows();
  void finish_row(int row, Percept& percept);

  const Measure& measure_;
  int width_;
  int height_;
  Plane y_, cx_, cz_;
  std::array<Plane, 7> passed_;  // filtered along rows: y, cx, cz twice; smooth, edge, point
  std::array<std::vector<float>, 4> line_ = {std::vector<float>(static_cast<std::size_t>(width_)),
                                             std::vector<float>(static_cast<std::size_t>(width_)),
                                             std::vector<float>(static_cast<std::size_t>(width_)),
                                             std::vector<float>(static_cast<std::size_t>(width_))};
};

// The border's pixels stand for those beyond.
void TilePercepts::load(const Image8& picture, int x, int y) {
  const ColorMatrix& matrix = white_relative_xyz();
  const int halo = measure_.halo;
  for (int j = 0; j < height_ + 2 * halo; ++j) {
    const int from = std::clamp(y + j - halo, 0, picture.height - 1);
    float *to_y = y_.row(j), *to_cx = cx_.row(j), *to_cz = cz_.row(j);
    for (int i = 0; i < width_ + 2 * halo; ++i) {
      const std::uint8_t* pixel = picture.at(std::clamp(x + i - halo, 0, picture.width - 1), from);
      const OpponentColor color = opponent_from_linear(
          matrix,
          {measure_.linear[pixel[0]], measure_.linear[pixel[1]], measure_.linear[pixel[2]]});
      to_y[i] = color.y;
      to_cx[i] = color.cx;
      to_cz[i] = color.cz;
    }
  }
}

void TilePercepts::filter_rows() {
  const int halo = measure_.halo;
  const ContrastFilters& contrast = measure_.contrast;
  const FeatureFilters& features = measure_.features;
  for (int j = 0; j < height_ + 2 * halo; ++j) {
    const float *y = y_.row(j) + halo, *cx = cx_.row(j) + halo, *cz = cz_.row(j) + halo;
    filter_even(contrast.achromatic, y, 1, width_, passed_[0].row(j));
    filter_even(contrast.red_green, cx, 1, width_, passed_[1].row(j));
    filter_even(contrast.blue_yellow, cz, 1, width_, passed_[2].row(j));
    filter_even(contrast.blue_yellow_narrow, cz, 1, width_, passed_[3].row(j));
    filter_even(features.smooth, y, 1, width_, passed_[4].row(j));
    filter_odd(features.edge, y, 1, width_, passed_[5].row(j));
    filter_even(features.point, y, 1, width_, passed_[6].row(j));
  }
}

void TilePercepts::finish_row(int row, Percept& percept) {
  const int centre = row + measure_.halo;
  const ContrastFilters& contrast = measure_.contrast;
  const FeatureFilters& features = measure_.features;
  const auto down = [&](const HalfKernel& kernel, std::size_t plane, std::size_t line) {
    filter_even(kernel, passed_[plane].row(centre), passed_[plane].stride, width_,
                line_[line].data());
  };
  down(contrast.achromatic, 0, 0);
  down(contrast.red_green, 1, 1);
  down(contrast.blue_yellow, 2, 2);
  down(contrast.blue_yellow_narrow, 3, 3);
  mix_row(line_[2].data(), line_[3].data(), contrast.wide_share, width_, line_[2].data());
  lab_row(white_relative_xyz(), linear_from_white_relative_xyz(), line_[0].data(), line_[1].data(),
          line_[2].data(), width_, percept.l.row(row), percept.a.row(row), percept.b.row(row));
  down(features.smooth, 5, 0);
  filter_odd(features.edge, passed_[4].row(centre), passed_[4].stride, width_, line_[1].data());
  length_row(line_[0].data(), line_[1].data(), width_, percept.edge.row(row));
  down(features.smooth, 6, 0);
  down(features.point, 4, 1);
  length_row(line_[0].data(), line_[1].data(), width_, percept.point.row(row));
}

PicturePart tile_at(int column, int row, const PixelMap& errors) {
  const int x = column * tile_width, y = row * tile_height;
  return {x, y, std::min(tile_width, errors.width - x), std::min(tile_height, errors.height - y)};
}

/// Leaves pixels 0 that have nothing to tell apart.
void compare_tile(const Measure& measure, const Image8& a, const Image8& b, const PicturePart& tile,
                  PixelMap& errors) {
  const PicturePart part = changed_part(a, b, tile, measure.halo);
  if (part.height <= 0) return;
  TilePercepts viewer(measure, part.width, part.height);
  Percept of_a(viewer.width(), part.height), of_b(viewer.width(), part.height);
  viewer.look(a, part.x, part.y, of_a);
  viewer.look(b, part.x, part.y, of_b);
  for (int j = 0; j < part.height; ++j)
    error_row(row_of(of_a, j), row_of(of_b, j), largest_color_power(), part.width,
              errors.row(part.y + j) + part.x);
}

constexpr std::size_t error_steps = 65536;

/// How many pixels have an error of so many steps.
std::vector<std::uint32_t> histogram_of(const PixelMap& errors) {
  std::vector<std::uint32_t> counts(error_steps + 1);
  for (const float error : errors.values)
    ++counts[static_cast<std::size_t>(std::clamp(error, 0.0f, 1.0f) * float{error_steps} + 0.5f)];
  return counts;
}

double weighted_percentile_of(const std::vector<std::uint32_t>& counts, double share) {
  std::uint64_t whole = 0;
  for (std::size_t step = 0; step < counts.size(); ++step) whole += step * counts[step];
  std::uint64_t sum = 0;
  for (std::size_t step = 1; step < counts.size(); ++step) {
    sum += step * counts[step];
    if (sum > 0 && static_cast<double>(sum) >= share * static_cast<double>(whole))
      return static_cast<double>(step) / error_steps;
  }
  return 0.0;
}

}  // namespace

double Viewing::pixels_per_degree() const {
  return distance_metres * (screen_pixels / screen_metres) * std::numbers::pi / 180.0;
}

PixelMap perceptual_error(const Image8& a, const Image8& b, const Viewing& viewing, int threads) {
  require_same_size(a, b);
  const double pixels_per_degree = viewing.pixels_per_degree();
  if (!(pixels_per_degree >= 1.0 && pixels_per_degree <= 1000.0))
    throw std::invalid_argument("perceptual_error: there are not 1 to 1,000 pixels per degree");
  const Measure measure(pixels_per_degree);
  PixelMap errors(a.width, a.height);
  const tbb::blocked_range2d<int> tiles(0, (a.height + tile_height - 1) / tile_height, 1, 0,
                                        (a.width + tile_width - 1) / tile_width, 1);
  tbb::task_arena arena(threads > 0 ? threads : tbb::task_arena::automatic);
  arena.execute([&] {
    tbb::parallel_for(tiles, [&](const tbb::blocked_range2d<int>& part) {
      for (int row = part.rows().begin(); row < part.rows().end(); ++row)
        for (int column = part.cols().begin(); column < part.cols().end(); ++column)
          compare_tile(measure, a, b, tile_at(column, row, errors), errors);
    });
  });
  return errors;
}

ErrorSummary summary_of(const PixelMap& errors) {
  ErrorSummary summary;
  if (errors.values.empty()) return summary;
  double sum = 0.0;
  for (const float error : errors.values) sum += static_cast<double>(error);
  const auto [least, largest] = std::minmax_element(errors.values.begin(), errors.values.end());
  const auto first = std::find(errors.values.begin(), errors.values.end(), *largest);
  const auto place = static_cast<int>(first - errors.values.begin());
  const std::vector<std::uint32_t> counts = histogram_of(errors);
  summary.mean = sum / static_cast<double>(errors.values.size());
  summary.least = static_cast<double>(*least);
  summary.largest = static_cast<double>(*largest);
  summary.largest_x = place % errors.width;
  summary.largest_y = place / errors.width;
  summary.weighted_first_quartile = weighted_percentile_of(counts, 0.25);
  summary.weighted_median = weighted_percentile_of(counts, 0.5);
  summary.weighted_third_quartile = weighted_percentile_of(counts, 0.75);
  return summary;
}

}  // namespace mien::render

#include "render/compare/structural_similarity.h"

#include <algorithm>
#include <array>

#include "render/compare/picture_difference.h"
#include "render/compare/separable.h"
#include "render/math/for_avx2.h"

namespace mien::render {
namespace {

constexpr int window_reach = 5;
constexpr std::size_t moments = 5;  // of a, b, a², b², ab

/// Luma of a row, its border going on; room beyond for whole blocks.
std::vector<float> luma_line(const Image8& picture, int y, int width) {
  std::vector<float> line(static_cast<std::size_t>(width + 2 * window_reach));
  for (int i = 0; i < width + 2 * window_reach; ++i) {
    const std::uint8_t* p = picture.at(std::clamp(i - window_reach, 0, picture.width - 1), y);
    line[static_cast<std::size_t>(i)] = 0.2126f * static_cast<float>(p[0]) +
                                        0.7152f * static_cast<float>(p[1]) +
                                        0.0722f * static_cast<float>(p[2]);
  }
  return line;
}

using MomentRows = std::array<std::vector<float>, moments>;

MIEN_FOR_AVX2_TOO void similarity_row(const MomentRows& rows, int width, float* similarity) {
  constexpr float c1 = 0.01f * 255.0f * 0.01f * 255.0f;
  constexpr float c2 = 0.03f * 255.0f * 0.03f * 255.0f;
  const float *a = rows[0].data(), *b = rows[1].data();
  const float *aa = rows[2].data(), *bb = rows[3].data(), *ab = rows[4].data();
#pragma omp simd
  for (int i = 0; i < width; ++i) {
    const float product = a[i] * b[i], a_square = a[i] * a[i], b_square = b[i] * b[i];
    const float covariance = ab[i] - product;
    const float variances = (aa[i] - a_square) + (bb[i] - b_square);
    similarity[i] = ((product + product + c1) * (covariance + covariance + c2)) /
                    ((a_square + b_square + c1) * (variances + c2));
  }
}

double inner_mean(const PixelMap& map) {
  const int inset =
      map.width > 2 * window_reach && map.height > 2 * window_reach ? window_reach : 0;
  double sum = 0.0;
  for (int y = inset; y < map.height - inset; ++y)
    for (int x = inset; x < map.width - inset; ++x) sum += static_cast<double>(map.at(x, y));
  return sum / (static_cast<double>(map.width - 2 * inset) * (map.height - 2 * inset));
}

}  // namespace

StructuralSimilarity structural_similarity(const Image8& a, const Image8& b) {
  require_same_size(a, b);
  const HalfKernel window = gaussian_kernel(1.5, window_reach);
  const int width = (a.width + filter_block - 1) / filter_block * filter_block;
  const auto stride = static_cast<std::size_t>(width);
  // Filtered along rows; the border's rows go on.
  MomentRows passed, finished;
  for (std::vector<float>& plane : passed)
    plane.resize(stride * static_cast<std::size_t>(a.height + 2 * window_reach));
  for (std::vector<float>& row : finished) row.resize(stride);
  for (int j = 0; j < a.height + 2 * window_reach; ++j) {
    const int y = std::clamp(j - window_reach, 0, a.height - 1);
    const std::vector<float> of_a = luma_line(a, y, width), of_b = luma_line(b, y, width);
    std::array<std::vector<float>, moments> values = {of_a, of_b, of_a, of_b, of_a};
    for (std::size_t i = 0; i < of_a.size(); ++i) {
      values[2][i] = of_a[i] * of_a[i];
      values[3][i] = of_b[i] * of_b[i];
      values[4][i] = of_a[i] * of_b[i];
    }
    for (std::size_t m = 0; m < moments; ++m)
      filter_even(window, values[m].data() + window_reach, 1, width,
                  passed[m].data() + static_cast<std::size_t>(j) * stride);
  }
  StructuralSimilarity result{.map = PixelMap(a.width, a.height)};
  for (int y = 0; y < a.height; ++y) {
    for (std::size_t m = 0; m < moments; ++m)
      filter_even(window, passed[m].data() + static_cast<std::size_t>(y + window_reach) * stride,
                  width, width, finished[m].data());
    similarity_row(finished, a.width, result.map.row(y));
  }
  result.mean = inner_mean(result.map);
  return result;
}

}  // namespace mien::render

#include "render/compare/separable.h"

#include <cmath>

#include "render/math/for_avx2.h"

namespace mien::render {
namespace {

MIEN_FOR_AVX2_TOO void even_line(const float* weights, int reach, const float* in,
                                 std::ptrdiff_t step, int count, float* out) {
  for (int i = 0; i < count; i += filter_block) {
    float sum[filter_block];
    const float* centre = in + i;
#pragma omp simd
    for (int j = 0; j < filter_block; ++j) sum[j] = weights[0] * centre[j];
    for (int k = 1; k <= reach; ++k) {
      const float weight = weights[k];
      const float *before = centre - k * step, *after = centre + k * step;
#pragma omp simd
      for (int j = 0; j < filter_block; ++j) sum[j] += weight * (after[j] + before[j]);
    }
#pragma omp simd
    for (int j = 0; j < filter_block; ++j) out[i + j] = sum[j];
  }
}

MIEN_FOR_AVX2_TOO void odd_line(const float* weights, int reach, const float* in,
                                std::ptrdiff_t step, int count, float* out) {
  for (int i = 0; i < count; i += filter_block) {
    float sum[filter_block] = {};
    const float* centre = in + i;
    for (int k = 1; k <= reach; ++k) {
      const float weight = weights[k];
      const float *before = centre - k * step, *after = centre + k * step;
#pragma omp simd
      for (int j = 0; j < filter_block; ++j) sum[j] += weight * (after[j] - before[j]);
    }
#pragma omp simd
    for (int j = 0; j < filter_block; ++j) out[i + j] = sum[j];
  }
}

}  // namespace

HalfKernel gaussian_kernel(double deviation, int reach) {
  std::vector<double> weights;
  double sum = 0.0;
  for (int k = 0; k <= reach; ++k) {
    weights.push_back(std::exp(-0.5 * k * k / (deviation * deviation)));
    sum += (k == 0 ? 1.0 : 2.0) * weights.back();
  }
  HalfKernel kernel;
  for (const double weight : weights) kernel.push_back(static_cast<float>(weight / sum));
  return kernel;
}

void filter_even(const HalfKernel& kernel, const float* in, std::ptrdiff_t step, int count,
                 float* out) {
  even_line(kernel.data(), reach_of(kernel), in, step, count, out);
}

void filter_odd(const HalfKernel& kernel, const float* in, std::ptrdiff_t step, int count,
                float* out) {
  odd_line(kernel.data(), reach_of(kernel), in, step, count, out);
}

}  // namespace mien::render

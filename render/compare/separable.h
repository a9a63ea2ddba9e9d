#pragma once

#include <cstddef>
#include <vector>

namespace mien::render {

/// Weights of a filter along a line: of the centre, then of each distance from it. What lies on
/// both sides at one distance has the same weight (even) or the opposite one (odd, whose first
/// weight is 0).
using HalfKernel = std::vector<float>;

/// How far it reaches, pixels.
inline int reach_of(const HalfKernel& kernel) { return static_cast<int>(kernel.size()) - 1; }

/// A Gaussian of that standard deviation (pixels) up to `reach`, its whole sum 1.
HalfKernel gaussian_kernel(double deviation, int reach);

/// How many values are filtered at a time: counts given below are multiples of it.
inline constexpr int filter_block = 16;

/// out[i] = Σ weight[k] · (in[i + k · step] ± in[i − k · step]) for i = 0 … count − 1. The sum runs
/// from the centre outwards, whatever machine: the result is the same everywhere, and a mirrored
/// line gives the mirrored result.
void filter_even(const HalfKernel& kernel, const float* in, std::ptrdiff_t step, int count,
                 float* out);
void filter_odd(const HalfKernel& kernel, const float* in, std::ptrdiff_t step, int count,
                float* out);

}  // namespace mien::render

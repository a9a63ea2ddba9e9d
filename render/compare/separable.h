#pragma once

#include <cstddef>
#include <vector>

namespace mien::render {

/// One half of a 1-D filter kernel: the weight at the centre, then at each distance from it, in
/// pixels. At the same distance on the other side the weight is equal (even kernel) or has the
/// opposite sign (odd kernel, whose central weight is 0).
using HalfKernel = std::vector<float>;

/// The radius of a kernel, pixels.
inline int reach_of(const HalfKernel& kernel) { return static_cast<int>(kernel.size()) - 1; }

/// Returns a Gaussian kernel with this standard deviation (pixels) and radius `reach` (pixels),
/// whose full weights add up to 1.
HalfKernel gaussian_kernel(double deviation, int reach);

/// Number of values that are filtered at a time; `count` below must be a multiple of it.
inline constexpr int filter_block = 16;

/// For i = 0 … count − 1: out[i] = Σ weight[k] · (in[i + k · step] ± in[i − k · step]) over k ≥ 1,
/// with + for an even and − for an odd kernel; for an even one plus weight[0] · in[i]. Terms are
/// added from the centre outwards in a fixed order, so that results are the same on every machine,
/// and mirroring a line mirrors its result exactly (with an odd kernel, it also changes the sign).
void filter_even(const HalfKernel& kernel, const float* in, std::ptrdiff_t step, int count,
                 float* out);
void filter_odd(const HalfKernel& kernel, const float* in, std::ptrdiff_t step, int count,
                float* out);

}  // namespace mien::render

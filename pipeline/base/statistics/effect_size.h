#pragma once

#include <vector>

namespace mien::pipeline {

/// Difference of the means of two independent samples in units of their pooled standard deviation:
/// d_s of Cohen 1988. NaN with fewer than two values in either, or where nothing varies.
double cohens_d(const std::vector<double>& a, const std::vector<double>& b);

/// What d times it is without bias: Γ(ν/2)/(√(ν/2)·Γ((ν − 1)/2)) (Hedges 1981) with ν degrees of
/// freedom: n + m − 2 of two samples, n − 1 of differences. NaN below two.
double hedges_correction(double degrees);

/// g of two independent samples.
double hedges_g(const std::vector<double>& a, const std::vector<double>& b);

/// g_z of paired differences.
double hedges_gz(const std::vector<double>& differences);

}  // namespace mien::pipeline

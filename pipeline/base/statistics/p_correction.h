#pragma once

#include <vector>

namespace mien::pipeline {

/// p values adjusted for multiple testing by the method of Holm (1979), in the given order. Of m
/// values in ascending order the k-th becomes max over i ≤ k of min(1, (m − i + 1)·p_i). NaN values
/// are kept and not counted.
std::vector<double> holm(const std::vector<double>& p_values);

/// p values adjusted for the false discovery rate (Benjamini and Hochberg 1995), in the given
/// order. Of m values in ascending order the k-th becomes min over i ≥ k of min(1, m/i·p_i). NaN
/// values are kept and not counted.
std::vector<double> benjamini_hochberg(const std::vector<double>& p_values);

}  // namespace mien::pipeline

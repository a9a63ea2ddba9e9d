#pragma once

#include <vector>

namespace mien::pipeline {

/// p values corrected for their number (Holm 1979), in the order given: of m values in ascending
/// order the k-th becomes max over i ≤ k of min(1, (m − i + 1)·p_i). NaN stays and does not count.
std::vector<double> holm(const std::vector<double>& p_values);

/// p values corrected for the share of false discoveries (Benjamini and Hochberg 1995), in the
/// order given: of m values in ascending order the k-th becomes min over i ≥ k of min(1, m/i·p_i).
/// NaN stays and does not count.
std::vector<double> benjamini_hochberg(const std::vector<double>& p_values);

}  // namespace mien::pipeline

#pragma once

#include <array>

#include "pipeline/study/results/result_rows.h"

namespace mien::pipeline {

/// Columns of the tests within participants.
template <class Row>
inline constexpr std::array within_columns = std::to_array<ResultColumn<Row>>({
    {"paired_difference", "scale units",
     "mean within-participant difference; for best-seen from the other videos of the setting",
     [](auto& r) { return r.of.within.t.mean; }},
    {"paired_low", "scale units", "lower end of its 95 % interval",
     [](auto& r) { return r.of.within.t.low(0.95); }},
    {"paired_high", "scale units", "upper end", [](auto& r) { return r.of.within.t.high(0.95); }},
    {"paired_t", "", "paired t statistic", [](auto& r) { return r.of.within.t.t; }},
    {"paired_df", "", "degrees of freedom", [](auto& r) { return r.of.within.t.degrees; }},
    {"paired_p", "", "two-sided p; empty if all differences are equal",
     [](auto& r) { return p_field(r.of.within.t.p); }},
    {"paired_p_adjusted", "", "p corrected within the family",
     [](auto& r) { return p_field(r.of.paired_adjusted); }},
    {"cohens_dz", "",
     "Cohen's d_z: mean difference divided by the standard deviation of the differences",
     [](auto& r) { return r.of.within.dz; }},
    {"hedges_gz", "", "the same with Hedges' bias correction",
     [](auto& r) { return r.of.within.gz; }},
    {"wilcoxon_v", "", "sum of the ranks of positive differences, zeros excluded",
     [](auto& r) { return r.of.within.wilcoxon.w_plus; }},
    {"wilcoxon_n", "", "number of nonzero differences",
     [](auto& r) { return r.of.within.wilcoxon.used; }},
    {"wilcoxon_zeros", "", "number of zero differences",
     [](auto& r) { return r.of.within.wilcoxon.zeros; }},
    {"wilcoxon_tied", "",
     "number of nonzero differences that share their absolute value with another",
     [](auto& r) { return r.of.within.wilcoxon.tied; }},
    {"wilcoxon_p", "",
     "two-sided p, exact, conditional on ties; zeros excluded; empty without participants",
     [](auto& r) { return p_field(r.of.within.wilcoxon.p); }},
    {"wilcoxon_p_adjusted", "", "p corrected within the family",
     [](auto& r) { return p_field(r.of.wilcoxon_adjusted); }},
    {"wilcoxon_p_normal", "", "two-sided p, normal approximation without continuity correction",
     [](auto& r) { return p_field(r.of.within.wilcoxon_normal); }},
    {"wilcoxon_p_normal_corrected", "",
     "two-sided p, normal approximation with continuity correction",
     [](auto& r) { return p_field(r.of.within.wilcoxon_normal_corrected); }},
    {"pratt_v", "", "as wilcoxon_v, with zeros ranked together with the others (Pratt)",
     [](auto& r) { return r.of.within.pratt.w_plus; }},
    {"pratt_p", "", "two-sided p, exact, of Pratt's ranks",
     [](auto& r) { return p_field(r.of.within.pratt.p); }},
    {"zsplit_p", "",
     "two-sided p, normal approximation, with the zeros' ranks split equally between the signs",
     [](auto& r) { return p_field(r.of.within.wilcoxon_zsplit); }},
    {"hodges_lehmann", "scale units",
     "Hodges–Lehmann estimate: median of all pairwise means of the differences, zeros included",
     [](auto& r) { return r.of.within.location.estimate; }},
    {"hodges_lehmann_low", "scale units",
     "lower end of its 95 % interval, which needs at least six differences",
     [](auto& r) { return r.of.within.location.low; }},
    {"hodges_lehmann_high", "scale units", "upper end",
     [](auto& r) { return r.of.within.location.high; }},
    {"rank_biserial", "-1–1", "matched-pairs rank-biserial correlation, zeros excluded",
     [](auto& r) { return r.of.within.wilcoxon.rank_biserial; }},
    {"all_alike", "", "1 if all differences are equal, so that there is no t test",
     [](auto& r) { return r.of.within.all_equal; }},
});

}  // namespace mien::pipeline

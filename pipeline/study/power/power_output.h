#pragma once

#include <string>
#include <vector>

#include "pipeline/base/documents/table.h"
#include "pipeline/base/drawing/plot.h"
#include "pipeline/study/power/planned_power.h"

namespace mien::pipeline {

/// The table of the power of planned tests: a row for each test and size of the study.
WrittenTable power_table(const std::vector<PlannedTestPower>& rows);

/// Sentences on what is assumed: sizes of effects, standard deviations, numbers of simulated
/// studies, level of significance and correction.
std::vector<std::string> power_assumptions(const Manifest& manifest,
                                           const PlannedPowerOptions& options);

/// Sentences on what those lines mean: what counts as a false positive, and why a test with too
/// many of them has no number of participants.
std::vector<std::string> planned_power_notes(const std::vector<PlannedTestPower>& rows,
                                             int participants, double alpha);

/// The power of each test against the number of participants, with a line for each number of
/// stimuli per cell and for each way of testing, and Monte-Carlo intervals. At most
/// most_power_panels tests, planned contrasts first. `notes` are printed below, a line each.
Plot power_chart(const std::string& study, const std::vector<PlannedTestPower>& rows,
                 double wanted_power, const std::vector<std::string>& notes = {});

inline constexpr std::size_t most_power_panels = 24;

/// Lines of text, by test, on its power in the study with `participants`: percent with the
/// Monte-Carlo standard error, the percentage of false positives, and the smallest simulated number
/// of participants with the intended power, which is not given for a test with too many false
/// positives.
std::vector<std::string> planned_power_lines(const std::vector<PlannedTestPower>& rows,
                                             int participants, double wanted_power, double alpha);

}  // namespace mien::pipeline

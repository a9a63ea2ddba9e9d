#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "pipeline/commands/line/command.h"
#include "pipeline/commands/line/console.h"
#include "pipeline/study/power/planned_power.h"

namespace mien::pipeline {

/// Options of `mien study design --power` for the power of planned tests.
struct PlannedTestsCommand {
  std::string table;  ///< CSV to be written; empty: planned tests are not simulated
  std::string truth;  ///< table of assumed true ratings
  std::vector<double> participants, stimuli, groups;
};

std::vector<CommandOption> planned_tests_options(PlannedTestsCommand& options);

/// The power of planned tests.
struct PlannedTestsResult {
  std::vector<PlannedTestPower> rows;
  std::vector<std::string> assumptions;  ///< sentences
  int stated_participants = 0;  ///< the planned number or, if it is not simulated, the largest one
};

/// Throws Error if the figure would overwrite files that are not those of an earlier table.
void refuse_figure_loss(const PlannedTestsCommand& command);

/// Reads the assumptions and simulates. Throws Error, or Interrupted if the console asks to stop.
/// `common` has the assumptions that are shared with the power of single comparisons.
PlannedTestsResult simulate_planned_tests(const PlannedTestsCommand& command,
                                          const PlannedPowerOptions& common,
                                          const Manifest& manifest, const Console& console);

/// Prints sentences on the result. The table is written by the caller.
void print_planned_tests(const PlannedTestsResult& result, double wanted_power,
                         const Manifest& manifest, std::ostream& out);

/// Writes the figure beside the table, as .pdf, .svg and .png, and lists its files.
void write_power_figure(const PlannedTestsCommand& command, const PlannedTestsResult& result,
                        double wanted_power, const Manifest& manifest, std::ostream& out);

}  // namespace mien::pipeline

#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/base/documents/csv.h"

namespace mien::pipeline {

/// A matching trial: a participant adjusts a motion to match a target.
struct MatchingTrial {
  std::string participant;
  std::string target;
  std::string interface;                ///< "weights", "adjectives", "features", …
  std::optional<double> first_guess_d;  ///< D of the guess made without seeing the motion, metres
  std::optional<double>
      time_s;            ///< until the match; the limit when there was none; empty if unknown
  bool success = false;  ///< matched within the limit
};

struct MatchingResults {
  std::vector<MatchingTrial> trials;  ///< in the order of the files
  /// weights, features, adjectives, as far as they occur, then others in order of occurrence. The
  /// sign of differences thus does not depend on the order of rows.
  std::vector<std::string> interfaces;
  std::vector<std::string> targets;  ///< in order of occurrence
  double limit_s = 300.0;
  double threshold_m = 0.06;  ///< D below which motions matched, metres
  bool simulated = false;
};

/// Settings of the experiment where known from elsewhere than the tables.
struct MatchingSettings {
  std::optional<double> limit_s;      ///< seconds allowed for a match
  std::optional<double> threshold_m;  ///< D below which motions match, metres
};

/// Reads tidy CSV with the columns participant, target, interface, first_guess_d (metres), time_s,
/// success (1 or 0) and, optionally, simulated, design, limit_s and threshold_m: one table of all
/// participants, or as many as there are. Empty or "NA" numbers are unknown; a trial without
/// success took the limit, whatever its time. The limit is that of the tables, else of `settings`,
/// else 300 s; the threshold, which decides nothing but which guesses count as near, that of
/// `settings`, else of the tables, else 0.06 m.
///
/// Throws Faults with every fault: a column missing, a number below 0 or none, a success after the
/// limit or without a time, a success that is neither 0 nor 1, an empty name, a trial that is there
/// twice; and Error: rows of several designs, limits or thresholds, real and simulated rows,
/// another limit than the tables', no trial at all.
MatchingResults read_matching_results(const std::vector<std::filesystem::path>& files,
                                      const MatchingSettings& settings = {});
MatchingResults matching_results(const std::vector<CsvTable>& tables,
                                 const MatchingSettings& settings = {});

}  // namespace mien::pipeline

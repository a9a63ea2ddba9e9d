#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/base/documents/csv.h"

namespace mien::pipeline {

/// A matching trial, in which a participant adjusts a motion to match a target.
struct MatchingTrial {
  std::string participant;
  std::string target;
  std::string interface;  ///< "weights", "adjectives", "features", …
  /// D of the first guess, which is made before the created motion is shown; metres.
  std::optional<double> first_guess_d;
  /// Time until the match or, without a match, the limit; empty if unknown.
  std::optional<double> time_s;
  bool success = false;  ///< matched within the limit
};

struct MatchingResults {
  std::vector<MatchingTrial> trials;  ///< in the order of the files
  /// "weights", "features" and "adjectives" as far as they occur, then others in order of
  /// occurrence, so that the sign of differences does not depend on the order of rows.
  std::vector<std::string> interfaces;
  std::vector<std::string> targets;  ///< in order of occurrence
  double limit_s = 300.0;            ///< seconds allowed for a match
  double threshold_m = 0.06;         ///< D below which motions match, metres
  bool simulated = false;
};

/// Settings of the experiment from sources other than the tables.
struct MatchingSettings {
  std::optional<double> limit_s;      ///< seconds allowed for a match
  std::optional<double> threshold_m;  ///< D below which motions match, metres
};

/// Reads tidy CSV with the columns participant, target, interface, first_guess_d (metres), time_s,
/// success (1 or 0) and, optionally, simulated, design, limit_s and threshold_m, from one or more
/// tables. Empty or "NA" numbers are unknown. The time of a trial without success is set to the
/// limit. The limit is that of the tables, else of `settings`, else 300 s. The threshold is that of
/// `settings`, else of the tables, else 0.06 m; it only determines which first guesses count as
/// near.
///
/// Throws Faults with all faults: invalid or negative numbers, a success after the limit or with an
/// empty time ("NA" is accepted), a success that is neither 0 nor 1, empty names, and repeated
/// trials. Throws Error for missing columns, for rows of several designs, limits or thresholds, for
/// a limit or threshold in the tables that is not positive, for a mixture of real and simulated
/// rows, for a limit in `settings` that differs from that of the tables, and for a table without
/// trials.
MatchingResults read_matching_results(const std::vector<std::filesystem::path>& files,
                                      const MatchingSettings& settings = {});
MatchingResults matching_results(const std::vector<CsvTable>& tables,
                                 const MatchingSettings& settings = {});

}  // namespace mien::pipeline

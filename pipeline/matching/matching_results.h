#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/documents/csv.h"

namespace mien::pipeline {

/// One trial of a matching session: a person brings a motion as near to a target as he can.
struct MatchingTrial {
  std::string participant;
  std::string target;
  std::string interface;                ///< "weights", "adjectives", "features", …
  std::optional<double> first_guess_d;  ///< D of the guess made blind, metres
  std::optional<double>
      time_s;            ///< until the match; the limit when there was none; empty if unknown
  bool success = false;  ///< matched within the limit
};

struct MatchingResults {
  std::vector<MatchingTrial> trials;    ///< in the order of the file
  std::vector<std::string> interfaces;  ///< in the order in which they occur
  std::vector<std::string> targets;     ///< likewise
  double limit_s = 300.0;
  bool simulated = false;
};

/// Reads a tidy CSV with the columns participant, target, interface, first_guess_d (metres),
/// time_s, success (1 or 0) and, optionally, simulated. Empty or "NA" numbers are unknown; a trial
/// without success took the limit, whatever its time.
///
/// Throws Faults with every fault: a column missing, a number below 0 or none, a success after the
/// limit or without a time, a success that is neither 0 nor 1, an empty name, a trial that is there
/// twice, no trial at all.
MatchingResults read_matching_results(const std::filesystem::path& file, double limit_s = 300.0);
MatchingResults matching_results(const CsvTable& table, double limit_s = 300.0);

}  // namespace mien::pipeline

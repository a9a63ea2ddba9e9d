#pragma once

#include <map>
#include <string>
#include <vector>

#include "pipeline/documents/csv.h"
#include "pipeline/ratings/answer_rules.h"

namespace mien::pipeline {

/// Names in a table that mean nothing, each told once, with the number of rows that use it.
class UnknownNames {
 public:
  /// `what` they should be: "stimulus".
  explicit UnknownNames(std::string what) : what_(std::move(what)) {}

  void note(const CsvField& field);

  /// Faults or warnings, as the rules say, with the nearest of the names that are known.
  void report(const CsvTable& table, const std::vector<std::string>& known,
              const AnswerRules& rules, std::vector<Fault>& faults,
              std::vector<StudyWarning>& warnings) const;

 private:
  struct Met {
    CsvField field;  ///< where first
    int rows = 0;
  };

  std::string what_;
  std::map<std::string, Met> names_;
};

}  // namespace mien::pipeline

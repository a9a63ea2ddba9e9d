#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "pipeline/base/documents/csv.h"
#include "pipeline/manifest/ratings/answers/answer_rules.h"

namespace mien::pipeline {

/// Names in a table that mean nothing, each reported once, with the number of rows that use it; of
/// many the first five, and how many more there are.
class UnknownNames {
 public:
  /// What they should be: "stimulus", "stimuli".
  UnknownNames(std::string what, std::string what_many)
      : what_(std::move(what)), what_many_(std::move(what_many)) {}

  void note(const CsvField& field);

  /// Faults or warnings, as the rules say, with the nearest of the names that are known.
  void report(const CsvTable& table, const std::vector<std::string>& known,
              const AnswerRules& rules, std::vector<Fault>& faults,
              std::vector<StudyWarning>& warnings) const;

 private:
  struct UnknownName {
    CsvField field;  ///< where first
    int rows = 0;
  };

  std::string what_;
  std::string what_many_;
  std::vector<UnknownName> names_;  ///< in the order of the file
  std::map<std::string, std::size_t> index_;
};

}  // namespace mien::pipeline

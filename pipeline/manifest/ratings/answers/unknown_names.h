#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "pipeline/base/documents/csv.h"
#include "pipeline/manifest/ratings/answers/answer_rules.h"

namespace mien::pipeline {

/// Collects unknown names in a table and reports them, each with the number of rows that use it. If
/// there are more than five, only the first five are named, followed by the number of the others;
/// but warnings of `mien study analyze` (AnswerRules::plain is false) name all.
class UnknownNames {
 public:
  /// `singular` and `plural` name the expected kind: "stimulus", "stimuli".
  UnknownNames(std::string singular, std::string plural)
      : singular_(std::move(singular)), plural_(std::move(plural)) {}

  void note(const CsvField& field);

  /// Adds faults, each with the most similar of the known names, or warnings, as the rules say.
  void report(const CsvTable& table, const std::vector<std::string>& known,
              const AnswerRules& rules, std::vector<Fault>& faults,
              std::vector<StudyWarning>& warnings) const;

 private:
  struct UnknownName {
    CsvField field;  ///< first occurrence
    int rows = 0;
  };

  std::string singular_;
  std::string plural_;
  std::vector<UnknownName> names_;  ///< in file order
  std::map<std::string, std::size_t> index_;
};

}  // namespace mien::pipeline

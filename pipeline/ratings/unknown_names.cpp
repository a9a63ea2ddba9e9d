#include "pipeline/ratings/unknown_names.h"

#include <fmt/format.h>

#include "motion/text/nearest_word.h"

namespace mien::pipeline {

void UnknownNames::note(const CsvField& field) {
  Met& met = names_[field.text];
  if (met.rows++ == 0) met.field = field;
}

void UnknownNames::report(const CsvTable& table, const std::vector<std::string>& known,
                          const AnswerRules& rules, std::vector<Fault>& faults,
                          std::vector<StudyWarning>& warnings) const {
  for (const auto& [text, met] : names_) {
    const Place place = place_of(table, met.field);
    const std::string wrong = fmt::format("unknown {} \"{}\" ({} row{})", what_, text, met.rows,
                                          met.rows == 1 ? "" : "s");
    if (rules.unknown == AnswerRules::Unknown::refuse) {
      const char* choice = rules.plain ? "unknown: ignore" : "--unknown ignore";
      faults.push_back(
          {place, "", wrong,
           fmt::format("{} ({} leaves it out)", motion::did_you_mean(text, known), choice)});
    } else {
      warnings.push_back({"unknown-" + what_, place, wrong + " left out"});
    }
  }
}

}  // namespace mien::pipeline

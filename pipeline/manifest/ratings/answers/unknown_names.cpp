#include "pipeline/manifest/ratings/answers/unknown_names.h"

#include <algorithm>

#include <fmt/format.h>

#include "motion/text/excerpt.h"
#include "motion/text/nearest_word.h"

namespace mien::pipeline {

namespace {

/// Where more are unknown, the file is about something else, and naming each does not help.
constexpr std::size_t most_named = 5;

std::string rows_text(int rows) { return fmt::format("({} row{})", rows, rows == 1 ? "" : "s"); }

/// "--unknown ignore leaves it out".
std::string exclusion_remedy(const AnswerRules& rules, const char* them) {
  return fmt::format("({} leaves {} out)", rules.plain ? "unknown: ignore" : "--unknown ignore",
                     them);
}

}  // namespace

void UnknownNames::note(const CsvField& field) {
  const auto [entry, is_new] = index_.emplace(field.text, names_.size());
  if (is_new) names_.push_back({field, 0});
  ++names_[entry->second].rows;
}

void UnknownNames::report(const CsvTable& table, const std::vector<std::string>& known,
                          const AnswerRules& rules, std::vector<Fault>& faults,
                          std::vector<StudyWarning>& warnings) const {
  const bool refuses = rules.unknown == AnswerRules::Unknown::refuse;
  const auto report_name = [&](const UnknownName& entry, const std::string& wrong,
                               const std::string& remedy) {
    const Place place = place_of(table, entry.field);
    if (refuses) {
      faults.push_back({place, "", wrong, remedy});
    } else {
      warnings.push_back({"unknown-" + singular_, place, wrong + " excluded"});
    }
  };
  // A table of warnings has room for all.
  const bool names_all = !refuses && !rules.plain;
  const std::size_t named = names_all ? names_.size() : std::min(names_.size(), most_named);
  for (std::size_t i = 0; i < named; ++i) {
    const UnknownName& entry = names_[i];
    report_name(
        entry,
        fmt::format("unknown {} {} {}", singular_, motion::in_quotes(entry.field.text),
                    rows_text(entry.rows)),
        motion::did_you_mean(entry.field.text, known) + " " + exclusion_remedy(rules, "it"));
  }
  if (named == names_.size()) return;
  int rows = 0;
  for (std::size_t i = named; i < names_.size(); ++i) rows += names_[i].rows;
  const std::size_t more = names_.size() - named;
  report_name(
      names_[named],
      fmt::format("and {} more unknown {} {}", more, more == 1 ? singular_ : plural_,
                  rows_text(rows)),
      "check that the file is about these examples and scales " + exclusion_remedy(rules, "them"));
}

}  // namespace mien::pipeline

#include "pipeline/manifest/ratings/answers/answers_of_files.h"

#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "motion/text/excerpt.h"
#include "pipeline/base/documents/fault.h"

namespace mien::pipeline {

namespace {

/// Takes each row once; counts by session what was there again.
class RowsTakenOnce {
 public:
  void add(AnswerRow row) {
    if (met_.insert(fields_of_row(row)).second) {
      result.rows.push_back(std::move(row));
    } else {
      ++again_[{row.participant, row.session}];
    }
  }

  AnswersOfFiles finished() {
    for (const auto& [who, count] : again_)
      result.told.push_back(
          fmt::format("participant {}, session {}: {} answer{} {} saved more than once and "
                      "counted once",
                      motion::in_quotes(who.first),
                      who.second.empty() ? "without a name" : motion::excerpt(who.second), count,
                      count == 1 ? "" : "s", count == 1 ? "was" : "were"));
    return std::move(result);
  }

  AnswersOfFiles result;

 private:
  std::set<std::vector<std::string>> met_;
  std::map<std::pair<std::string, std::string>, int> again_;
};

}  // namespace

AnswersOfFiles answers_of_files(const std::vector<std::filesystem::path>& files) {
  RowsTakenOnce taken;
  for (const std::filesystem::path& file : files)
    for (AnswerRow& row : answer_rows(read_csv(file), Doubled::allowed)) taken.add(std::move(row));
  AnswersOfFiles all = taken.finished();
  const std::vector<Fault> faults = doubled_answers(all.rows);
  if (!faults.empty()) throw Faults(faults);
  return all;
}

}  // namespace mien::pipeline

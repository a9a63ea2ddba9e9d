#include "pipeline/study/results/participant_flow.h"

#include <algorithm>
#include <map>

#include "pipeline/manifest/ratings/answers/session_end.h"

namespace mien::pipeline {

std::vector<FlowStage> participant_flow(const AnswerSet& answer_set,
                                        const ParticipantTable& participants) {
  const CsvTable& table = participants.table;
  const int ended = find_column(table, "ended");
  const int fault = find_column(table, "screening_fault");
  if (ended < 0 || participants.empty()) return {};
  const auto text_in = [](const std::vector<CsvField>& row, int column) {
    return column < 0 ? std::string() : row[static_cast<std::size_t>(column)].text;
  };
  int turned_away = 0, unfinished = 0, finished = 0;
  std::map<std::string, int> reasons;
  for (const std::vector<CsvField>& row : table.rows) {
    const std::string end = text_in(row, ended);
    if (end == word_of(session_end_words, SessionEnd::screened_out)) {
      ++turned_away;
      ++reasons[text_in(row, fault)];
    } else if (end == word_of(session_end_words, SessionEnd::completed)) {
      ++finished;
    } else {
      ++unfinished;
    }
  }
  std::vector<FlowStage> flow = {{"consented", static_cast<int>(table.rows.size())},
                                 {"turned away by the screening", turned_away}};
  for (const auto& [reason, count] : reasons)
    if (!reason.empty()) flow.push_back({"turned away by the screening: " + reason, count});
  flow.push_back({"did not reach the last page", unfinished});
  flow.push_back({"reached the last page", finished});
  flow.push_back({"gave answers", static_cast<int>(answer_set.attention.size())});
  flow.push_back({"of these, left out of the analysis",
                  static_cast<int>(answer_set.attention.size() - answer_set.people.size())});
  flow.push_back({"analysed", static_cast<int>(answer_set.people.size())});
  return flow;
}

}  // namespace mien::pipeline

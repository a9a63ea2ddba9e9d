#include "pipeline/manifest/ratings/answers/participant_row.h"

namespace mien::pipeline {

namespace {

constexpr auto participant_columns = table_of<ParticipantRow>(
    "participants.csv", "a participant",
    {{"participant", "", "who answered: the place in the design, no name",
      [](auto& r) { return r.participant; }},
     {"session", "", "random name of the browser session", [](auto& r) { return r.session; }},
     {"design", "", "hash of the questionnaire that was run", [](auto& r) { return r.design; }},
     {"consented_at", "", "when the participant agreed (ISO 8601, UTC)",
      [](auto& r) { return r.consented_at; }},
     {"finished", "", "1 when the participant came to the end",
      [](auto& r) { return r.has_finished; }},
     {"*", "", "answer to the question", [](auto& r) { return r.answers; }}});

}  // namespace

const TableForm participant_form = participant_columns.form();

std::string to_csv(const std::vector<ParticipantRow>& rows,
                   const std::vector<std::string>& questions) {
  return participant_columns.of(rows, questions).csv;
}

}  // namespace mien::pipeline

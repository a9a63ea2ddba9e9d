#include "pipeline/manifest/ratings/answers/participant_row.h"

#include "pipeline/manifest/ratings/answers/answer_row.h"

namespace mien::pipeline {

namespace {

constexpr auto participant_columns = table_of<ParticipantRow>(
    "participants.csv", "participant",
    {{"participant", "", "participant id: position in the design, not a name",
      [](auto& r) { return r.participant; }},
     {"session", "", "random id of the browser session", [](auto& r) { return r.session; }},
     {"design", "", "hash of the questionnaire design", [](auto& r) { return r.design; }},
     {"consented_at", "", "time of consent (ISO 8601, UTC)",
      [](auto& r) { return r.consented_at; }},
     {"finished", "", "1 if the participant finished", [](auto& r) { return r.has_finished; }},
     {"ended", "", "completed or screened_out; empty while under way, or if broken off",
      [](auto& r) { return r.ended; }},
     {"screening_fault", "",
      "why the screening turned the participant away: answer, window, refresh_hz, sound or quota",
      [](auto& r) { return r.screening_fault; }},
     {"language", "", "language of the pages (BCP 47)", [](auto& r) { return r.language; }},
     {"consent_version", "", "version of the consent text",
      [](auto& r) { return r.consent_version; }},
     {"consent_sha256", "", "SHA-256 of the consent text",
      [](auto& r) { return r.consent_sha256; }},
     {"closing_comment", "",
      "participant's comment on the last page; left out of reports and datasets",
      [](auto& r) { return r.closing_comment; }},
     {"*", "", "answer to the question", [](auto& r) { return r.answers; }}});

}  // namespace

const TableForm participant_form = participant_columns.form();

bool is_question_column(std::string_view name) {
  return find_column(participant_form, name) == nullptr && !is_parameter_column(name) &&
         name != "simulated" && name != "tones_1" && name != "tones_2";
}

std::string to_csv(const std::vector<ParticipantRow>& rows,
                   const std::vector<std::string>& questions) {
  return participant_columns.of(rows, questions).csv;
}

}  // namespace mien::pipeline

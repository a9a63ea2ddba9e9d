#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "pipeline/base/documents/csv.h"
#include "pipeline/manifest/ratings/answers/answer_row.h"

namespace mien::pipeline {

/// A session as tables name it: the participant, before separate_participants, and the session id.
using SessionName = std::pair<std::string, std::string>;

/// Which sessions are of the same person, according to a URL parameter of the participants' links.
/// The values of the parameter, which may identify people, are replaced by numbers.
struct SessionPeople {
  bool is_known = false;                            ///< some table has the parameter's column
  std::map<SessionName, int> person;                ///< only sessions with a value
  std::map<SessionName, std::string> consented_at;  ///< ISO 8601, UTC; only where it is known
};

/// Reads the parameter's column (parameter_column) of tables of answers and tables of participants,
/// and the times of consent in the latter. If tables differ about a session, the first one with a
/// value counts.
///
/// Throws Faults for times of consent that are not in the form 2026-03-01T09:30:00.000Z, and Error
/// if a table with the column has no columns participant and session.
SessionPeople session_people(const std::vector<CsvTable>& answers,
                             const std::vector<CsvTable>& participants,
                             const std::string& parameter);

/// Where a session begins in the rows of answers.
struct SessionStart {
  SessionName name;
  std::size_t row = 0;  ///< index of its first row
};

/// The sessions of the rows in order of their first rows. Call this before separate_participants.
std::vector<SessionStart> session_starts(const std::vector<AnswerRow>& rows);

/// Returns, for each participant whose person had taken part before, the reason in words. `rows`
/// are those of session_starts after separate_participants.
///
/// Sessions that only continue each other (of one participant) are one participation; only sessions
/// with answers count, so whoever was turned away or withdrew has not taken part. The first
/// participation is the one with the earliest consent or, if the time of consent is unknown for one
/// of a person's participations, the one that comes first in the rows; the reason states which. The
/// first one is never flagged, whether or not it is excluded for other reasons.
std::map<std::string, std::string> repeated_participants(const std::vector<SessionStart>& sessions,
                                                         const std::vector<AnswerRow>& rows,
                                                         const SessionPeople& people);

}  // namespace mien::pipeline

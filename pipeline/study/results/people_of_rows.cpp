#include "pipeline/study/results/people_of_rows.h"

#include <cstddef>
#include <map>

#include "pipeline/base/documents/csv.h"
#include "pipeline/study/results/repeated_participation.h"

namespace mien::pipeline {

namespace {

class RowOwners {
 public:
  RowOwners(const CsvTable& table, const AnswerSet& answer_set)
      : answer_set_(answer_set),
        participant_(static_cast<std::size_t>(require_column(table, "participant"))),
        session_(find_column(table, "session")) {
    for (const auto& [session, participant] : answer_set.person_of_session) {
      AnsweredId& id = ids_[session.first];
      id.is_separated = id.is_separated || participant != session.first;
      id.lacks_session = id.lacks_session || session.second.empty();
    }
  }

  SessionName session_of(const std::vector<CsvField>& row) const {
    return {row[participant_].text,
            session_ < 0 ? "" : row[static_cast<std::size_t>(session_)].text};
  }

  std::string owner_of(const SessionName& session) const {
    const auto answered = answer_set_.person_of_session.find(session);
    if (!session.second.empty() && answered != answer_set_.person_of_session.end())
      return answered->second;
    const auto id = ids_.find(session.first);
    if (id == ids_.end()) return session.first;
    const bool is_by_id = session.second.empty() || id->second.lacks_session;
    return is_by_id && !id->second.is_separated ? session.first : "";
  }

 private:
  /// What is known of an id from the answers.
  struct AnsweredId {
    bool is_separated = false;
    bool lacks_session = false;
  };

  const AnswerSet& answer_set_;
  std::size_t participant_;
  int session_;
  std::map<std::string, AnsweredId> ids_;
};

}  // namespace

std::vector<std::string> people_of_rows(const ParticipantTable& participants,
                                        const AnswerSet& answer_set) {
  if (participants.empty()) return {};
  const RowOwners owners(participants.table, answer_set);
  std::vector<std::string> people;
  for (const auto& row : participants.table.rows)
    people.push_back(owners.owner_of(owners.session_of(row)));
  return people;
}

std::vector<std::string> published_names(const ParticipantTable& participants,
                                         const AnswerSet& answer_set) {
  if (participants.empty()) return {};
  const RowOwners owners(participants.table, answer_set);
  std::vector<std::string> names;
  for (const auto& row : participants.table.rows) {
    const SessionName session = owners.session_of(row);
    names.push_back(owners.owner_of(session));
    if (!names.back().empty()) continue;
    names.back() = session.first;
    if (!session.second.empty()) names.back() += "/" + session.second;
  }
  return names;
}

}  // namespace mien::pipeline

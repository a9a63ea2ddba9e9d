#pragma once

#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "pipeline/study/questionnaire/service/live_results.h"
#include "pipeline/study/questionnaire/service/screening_record.h"
#include "pipeline/study/questionnaire/service/served_study.h"
#include "pipeline/study/questionnaire/service/shared_chains.h"
#include "pipeline/study/server/session_store.h"

namespace mien::pipeline {

/// A clock that returns seconds since 1970.
using ClockSeconds = std::function<std::int64_t()>;
/// The system's clock.
std::int64_t system_seconds();

/// ISO 8601 time in UTC: "2026-01-31T09:00:00Z"
std::string iso_time(std::int64_t seconds);

/// The seconds of such a time; 0 if the text is not one.
std::int64_t seconds_of(const std::string& iso_time);

/// A session and its progress.
struct SessionState {
  StoredSession session;
  std::vector<std::string> names;  ///< names of this session's records, in order
  std::size_t stored = 0;          ///< number of these records that have been stored
  /// Time at which the page last loaded its session, sent a record or said that it is still open
  /// (once a minute), seconds since 1970; after a start of the server that of the last record; 0:
  /// never.
  std::int64_t last_seen = 0;
  std::string browser;  ///< browser session that sent the first record; other browsers are refused
  /// How the session ended early: refused, screened_out, withdrawn or, in chains,
  /// failed_attention. Nothing more is accepted.
  std::optional<SessionEnd> ended;
  int failed_checks = 0;                ///< number of attention checks of chains that were failed
  std::vector<ItemResponse> screening;  ///< answers to the questions of the screening
  ScreeningFault screening_fault = ScreeningFault::none;  ///< why it turned the participant away

  bool has_finished() const { return stored == names.size(); }
  /// Has begun and neither finished nor ended early.
  bool is_under_way() const { return stored > 0 && !has_finished() && !ended; }
  /// Whether `last_seen` is within the last five minutes.
  bool is_online(std::int64_t now) const { return last_seen != 0 && now - last_seen <= 300; }
};

/// The outcome of submitting a record.
struct SubmissionResult {
  RecordOutcome outcome = RecordOutcome::stored;
  /// Name of the next record to be sent; empty if the session is finished, or if one of the
  /// following members is true.
  std::string next;
  std::optional<SessionEnd> ended;  ///< the session ended early; further records are refused
  bool is_other_browser = false;    ///< the session was begun in another browser
  bool is_taken = false;  ///< somebody else has answered the step of the chain, or it is no longer
                          ///< the present one
};

/// The step that a trial of a chain across participants is given.
struct StepAssignment {
  std::optional<AssignedStep> step;
  NoStep reason = NoStep::busy;   ///< if there is none
  bool is_other_browser = false;  ///< the session was begun in another browser
};

/// The outcome of consent on the page of the shared link.
struct JoinResult {
  std::optional<SessionState> session;  ///< none: has_enough(), or is_other_browser
  bool is_other_browser = false;  ///< a session of this browser session was begun with another
                                  ///< consent, or has gone on since
};

/// The sessions of a served study: links and progress. Thread-safe.
class StudySessions {
 public:
  /// Opens the sessions in `store`; if it is new, first writes the planned sessions to it. Throws
  /// Error if the store belongs to another study, to another design of this study, or to other
  /// media. `study` and `store` must outlive this object.
  StudySessions(const ServedStudy& study, SessionStore& store, ClockSeconds clock);

  /// The session with this link, or nullopt.
  std::optional<int> find(const std::string& link) const;

  SessionState state(int session) const;
  std::vector<SessionState> states() const;

  /// Sets the time at which the participant's page last loaded its session.
  void note_request(int session);

  /// Stores a record, which must have been checked (record_check.h). `content`: its JSON text. A
  /// screening that turns the participant away (screening_record.h), or a quota that is full, ends
  /// the session.
  SubmissionResult submit(int session, const PageRecord& record, const std::string& content);

  /// The step for a trial (SharedChains::assign). The study must have chains across participants.
  StepAssignment assign_step(int session, const std::string& browser, const std::string& trial);
  /// The numbers of complete steps and of all steps of chains across participants; 0 without them.
  std::pair<int, int> step_progress() const;

  /// Deletes all that is stored of a session and ends it as withdrawn; only its number and link
  /// remain. Returns the number of deleted records. Throws WriteFailure as SessionStore does.
  int withdraw(int session);

  /// Adds a session for a participant who gave consent on the page of the shared link. It follows
  /// the plan that the fewest participants have finished or are following (next_plan). Participants
  /// whose session ended early, or who are offline without having finished, are not counted.
  /// Planned sessions are never used, since their links may have been handed out. If a browser
  /// session that has already joined sends the same consent again, and nothing else since, its
  /// session is returned: the first answer may have been lost.
  JoinResult join(const PageRecord& consent, const std::string& content);

  /// Counts a visitor of the shared link who refuses consent, of whom nothing else is stored. A
  /// browser session that sends its refusal again is not counted again while the server runs.
  void count_refusal(const PageRecord& consent);
  /// The number of such visitors.
  int refusals() const;

  /// Whether all plans are finished, or the maximum number of sessions is reached: four per plan
  /// apart from those that ended early, and forty per plan in all.
  bool has_enough() const;

  std::string lab_link() const { return lab_link_; }
  std::string join_link() const { return join_link_; }
  /// Random text of this store, which pseudonyms are made with (recruited_participants.h).
  std::string salt() const { return salt_; }

  /// The plan of a session, with the name of the session's participant.
  SessionPlan plan_of(const StoredSession& session) const;

  nlohmann::ordered_json histograms() const;
  nlohmann::ordered_json checks() const;

  SessionStore& store() const { return store_; }

 private:
  void begin();
  void mark_begun(SessionState& state);
  void load();
  bool is_quota_full(const Quota& quota) const;
  /// Why the screening turns away the participant who sends this record.
  ScreeningFault fault_of(const PageRecord& record) const;
  void add_state(const StoredSession& session);
  void count(SessionState& state, const PageRecord& record);
  bool is_full() const;
  bool is_chain_trial(const SessionState& state, const PageRecord& record) const;
  bool fails_check(const SessionState& state, const PageRecord& record) const;
  std::optional<SessionEnd> end_by(const SessionState& state, const PageRecord& record) const;
  StepChange step_change(const SessionState& state, const PageRecord& record,
                         const std::optional<SessionEnd>& end) const;
  bool is_step_open(const SessionState& state, const PageRecord& record) const;
  StoredSession additional_session() const;

  const ServedStudy& study_;
  SessionStore& store_;
  ClockSeconds clock_;
  std::string lab_link_, join_link_, salt_;
  mutable std::mutex mutex_;
  std::vector<SessionState> states_;
  std::map<std::string, int> by_link_;
  std::set<std::string> refused_browsers_;  ///< of count_refusal
  LiveResults results_;
  std::optional<SharedChains> chains_;  ///< those that go across participants
};

}  // namespace mien::pipeline

#pragma once

#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/study/questionnaire/service/live_results.h"
#include "pipeline/study/questionnaire/service/served_study.h"
#include "pipeline/study/server/session_store.h"

namespace mien::pipeline {

/// Seconds since 1970.
using ClockSeconds = std::function<std::int64_t()>;
std::int64_t system_seconds();

/// "2026-01-31T09:00:00Z"
std::string iso_time(std::int64_t seconds);

/// The progress of a participant.
struct SessionState {
  StoredSession session;
  std::vector<std::string> names;  ///< of this session's records, in order
  std::size_t stored = 0;          ///< number of stored records, the first of these
  std::int64_t last_seen = 0;      ///< time of the last request, seconds since 1970; 0: never
  std::string browser;  ///< browser session that sent the first record; others are refused
  bool has_refused = false;

  bool has_finished() const { return stored == names.size(); }
  /// Whether the page sent a request within the last five minutes.
  bool is_online(std::int64_t now) const { return last_seen != 0 && now - last_seen <= 300; }
};

/// The outcome of a sent record.
struct SubmissionResult {
  RecordOutcome outcome = RecordOutcome::stored;
  std::string next;          ///< name of the expected record, where the order was wrong
  bool has_refused = false;  ///< the participant has refused consent; further records are refused
  bool is_other_browser = false;  ///< the session was begun in another browser
};

/// The sessions of a served study: links and progress. Thread-safe.
class StudySessions {
 public:
  /// Initialises the store unless it was. Throws Error when the store is of another study or of
  /// another design of this one. `study` and `store` must outlive this.
  StudySessions(const ServedStudy& study, SessionStore& store, ClockSeconds clock);

  /// The session with this link, or nullopt.
  std::optional<int> find(const std::string& link) const;

  SessionState state(int session) const;
  std::vector<SessionState> states() const;

  /// Notes a request of the participant's page.
  void note_request(int session);

  /// Stores a record, which must have been checked.
  SubmissionResult submit(int session, const PageRecord& record, const std::string& content);

  /// Adds a session for a participant who gave consent by the shared link. It follows the plan with
  /// the fewest participants, not counting those who have left or refused. Planned sessions are
  /// never used, since their links may have been handed out. The same consent sent again returns
  /// the same session. Nullopt when has_enough().
  std::optional<SessionState> join(const PageRecord& consent, const std::string& content);

  /// Whether all plans are finished, or the limit of further sessions is reached.
  bool has_enough() const;

  std::string lab_link() const { return lab_link_; }
  std::string join_link() const { return join_link_; }

  /// The plan of a session, with the session's participant name.
  SessionPlan plan_of(const StoredSession& session) const;

  nlohmann::ordered_json histograms() const;
  nlohmann::ordered_json checks() const;

  SessionStore& store() const { return store_; }

 private:
  void begin();
  void mark_begun(SessionState& state);
  void load();
  void add_state(const StoredSession& session);
  void count(SessionState& state, const PageRecord& record);
  bool is_full() const;
  StoredSession additional_session() const;

  const ServedStudy& study_;
  SessionStore& store_;
  ClockSeconds clock_;
  std::string lab_link_, join_link_;
  mutable std::mutex mutex_;
  std::vector<SessionState> states_;
  std::map<std::string, int> by_link_;
  LiveResults results_;
};

}  // namespace mien::pipeline

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

/// How far a participant is.
struct SessionState {
  StoredSession session;
  std::vector<std::string> names;  ///< of this session's records, in order
  std::size_t kept = 0;            ///< the first so many of them were given
  std::int64_t last_seen = 0;      ///< when the page last asked for something; 0: never
  std::string browser;             ///< that gave the first record, and alone may give more
  bool has_refused = false;

  bool has_finished() const { return kept == names.size(); }
  /// The page has asked for something within the last five minutes.
  bool is_here(std::int64_t now) const { return last_seen != 0 && now - last_seen <= 300; }
};

/// What became of a record that was given.
struct GivenRecord {
  Keeping keeping = Keeping::kept;
  std::string next;           ///< record that is due, where the order was wrong
  bool has_refused = false;   ///< the participant has refused; nothing more is taken
  bool is_elsewhere = false;  ///< the session was begun in another browser, where it goes on
};

/// The participants of a served study: their links, and how far they are. For several threads.
class StudySessions {
 public:
  /// Begins the study in the store unless it was begun. Throws Error when another study, or another
  /// state of this one, was begun there. Both must outlive this.
  StudySessions(const ServedStudy& study, SessionStore& store, ClockSeconds clock);

  /// The session behind a link, or nothing.
  std::optional<int> find(const std::string& link) const;

  SessionState state(int session) const;
  std::vector<SessionState> states() const;

  /// The participant's page was opened, or asks for something.
  void see(int session);

  /// Keeps a record, which must have been checked.
  GivenRecord give(int session, const PageRecord& record, const std::string& content);

  /// A further session for somebody who came by the link of all and has agreed, with the plan that
  /// is filled least, where those who have left or refused do not count. Never one of those
  /// planned: somebody may have been given its link. A consent that is sent again gets the same
  /// session again. Nothing when there is enough.
  std::optional<SessionState> join(const PageRecord& consent, const std::string& content);

  /// All plans are finished, or too many have come.
  bool has_enough() const;

  std::string lab_link() const { return lab_link_; }
  std::string join_link() const { return join_link_; }

  /// The plan of a session, under the participant's own name.
  SessionPlan plan_of(const StoredSession& session) const;

  nlohmann::ordered_json histograms() const;
  nlohmann::ordered_json checks() const;

  SessionStore& store() const { return store_; }

 private:
  void begin();
  void come(SessionState& state);
  void load();
  void add_state(const StoredSession& session);
  void count(SessionState& state, const PageRecord& record);
  bool is_full() const;
  StoredSession further_session() const;

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

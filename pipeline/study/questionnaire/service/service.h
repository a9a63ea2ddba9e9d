#pragma once

#include <mutex>
#include <string>

#include "pipeline/study/questionnaire/service/study_sessions.h"
#include "pipeline/study/server/http_message.h"
#include "pipeline/study/server/rate_limit.h"

namespace mien::pipeline {

/// Rate limits of requests.
struct ServiceRates {
  Rate link{.burst = 300, .per_second = 10};     ///< per participant's link
  Rate shared{.burst = 2000, .per_second = 50};  ///< page of the open link, per client address
  Rate live{.burst = 600, .per_second = 120};    ///< synthesized motions, per participant's link
  Rate wrong{.burst = 60, .per_second = 0.5};   ///< requests with unknown links, per client address
  Rate joining{.burst = 300, .per_second = 1};  ///< new sessions, per client address
};

/// Handles the requests of a served study:
///
///   /s/<link>/                    a participant's page and its files
///   /s/<link>/session.json        content of the page and progress of the session
///   /s/<link>/records/<name>      POST: a record
///   /s/<link>/withdrawal          POST: deletes the participant's answers
///   /s/<link>/live/…              motions of a matching or adaptive experiment (live_motions.h)
///   /s/<link>/step/<trial>        POST: assigns a step of a chain across participants
///   /media/<token>                a video or 3-D clip
///   /join/<link>/                 the page that asks for consent before a session is assigned
///   /join/<link>/records/consent  POST: consent; the response has the link of a session
///   /lab/<link>/                  the experimenter's page and exports (lab_answer)
///   /lab/<link>/withdrawal        POST: deletes the answers of the participant of an id or code
///
/// A participant's link gives access to one session only. No part of a request is used as a file
/// path. Thread-safe.
class QuestionnaireService {
 public:
  /// Throws Error as StudySessions does. `study` and `store` must outlive this.
  QuestionnaireService(const ServedStudy& study, SessionStore& store, ServiceRates rates = {},
                       ClockSeconds clock = system_seconds);

  /// Handles a request. If a record cannot be stored, the response has status 507, and the failure
  /// is shown on the experimenter's page (last_failure()).
  HttpResponse answer(const HttpRequest& request);

  /// The last storage failure; empty if there was none, or if a later record has been handled
  /// without a failure.
  std::string last_failure() const;

  const StudySessions& sessions() const { return sessions_; }

 private:
  HttpResponse answer_kind(const HttpRequest& request);
  HttpResponse answer_session(const HttpRequest& request);
  HttpResponse answer_in_session(const HttpRequest& request, int session);
  HttpResponse answer_live(const HttpRequest& request);
  HttpResponse take_record(const HttpRequest& request, int session);
  bool has_shared_chains() const;
  HttpResponse assign_step(const HttpRequest& request, int session);
  HttpResponse take_withdrawal(const HttpRequest& request, int session);
  HttpResponse keep_record(int session, const PageRecord& record, const std::string& content);
  /// The salt of pseudonyms, if the study keeps hashes of URL parameters.
  std::optional<std::string> salt() const;
  /// Where the participant is sent to; null unless the session is finished or has ended early.
  nlohmann::ordered_json destination_of(int session) const;
  std::vector<PageRecord> stored_records(int session) const;
  /// answered_levels_json of a session; null without adaptive trials.
  nlohmann::ordered_json answered_levels(const SessionState& state) const;
  HttpResponse answer_media(const HttpRequest& request) const;
  std::optional<HttpResponse> page_file(const std::string& name) const;
  HttpResponse answer_join(const HttpRequest& request);
  HttpResponse take_joining(const HttpRequest& request);
  HttpResponse answer_lab(const HttpRequest& request);
  HttpResponse take_lab_withdrawal(const HttpRequest& request);
  void set_last_failure(const std::string& last_failure);
  HttpResponse unknown(const HttpRequest& request);

  const ServedStudy& study_;
  ClockSeconds clock_;
  StudySessions sessions_;
  mutable std::mutex last_failure_mutex_;
  std::string last_failure_;
  RateLimit link_rate_, shared_rate_, live_rate_, wrong_rate_, joining_rate_;
};

}  // namespace mien::pipeline

#pragma once

#include <mutex>
#include <string>

#include "pipeline/study/questionnaire/service/study_sessions.h"
#include "pipeline/study/server/http_message.h"
#include "pipeline/study/server/rate_limit.h"

namespace mien::pipeline {

/// How often things may be asked for.
struct ServiceRates {
  Rate link{.burst = 300, .per_second = 10};    ///< by one participant's link
  Rate live{.burst = 600, .per_second = 120};   ///< motions, by one participant's link
  Rate wrong{.burst = 60, .per_second = 0.5};   ///< links that do not exist, by one address
  Rate joining{.burst = 100, .per_second = 1};  ///< new sessions, by one address
};

/// What a web server answers for a study:
///
///   /s/<link>/                    a participant's page, and the files of it
///   /s/<link>/session.json        what it shows, and what was given already
///   /s/<link>/records/<name>      POST: something is given
///   /s/<link>/live/…              motions of a matching experiment (live_motions.h)
///   /media/<token>                a video
///   /join/<link>/                 the page for somebody who has no session: it asks for consent
///   /join/<link>/records/consent  POST: who agrees is given a session
///   /lab/<link>/                  the experimenter's page and exports (lab_answer)
///
/// A link opens one session and nothing else. Nothing of a request names a file. For several
/// threads.
class QuestionnaireService {
 public:
  /// Throws Error as StudySessions does. Both must outlive this.
  QuestionnaireService(const ServedStudy& study, SessionStore& store, ServiceRates rates = {},
                       ClockSeconds clock = system_seconds);

  /// What could not be kept is answered with 507 and told to the laboratory (`trouble`).
  HttpResponse answer(const HttpRequest& request);

  /// What the machine failed at last; empty when nothing has failed since something was kept.
  std::string trouble() const;

  const StudySessions& sessions() const { return sessions_; }

 private:
  HttpResponse answer_kind(const HttpRequest& request);
  HttpResponse answer_session(const HttpRequest& request);
  HttpResponse answer_own(const HttpRequest& request, int session);
  HttpResponse answer_live(const HttpRequest& request);
  HttpResponse take_record(const HttpRequest& request, int session);
  HttpResponse keep_record(int session, const PageRecord& record, const std::string& content);
  HttpResponse answer_media(const HttpRequest& request) const;
  std::optional<HttpResponse> page_file(const std::string& name) const;
  HttpResponse answer_join(const HttpRequest& request);
  HttpResponse take_joining(const HttpRequest& request);
  HttpResponse answer_lab(const HttpRequest& request);
  void set_trouble(const std::string& trouble);
  HttpResponse unknown(const HttpRequest& request);

  const ServedStudy& study_;
  ClockSeconds clock_;
  StudySessions sessions_;
  mutable std::mutex trouble_mutex_;
  std::string trouble_;
  RateLimit link_rate_, live_rate_, wrong_rate_, joining_rate_;
};

}  // namespace mien::pipeline

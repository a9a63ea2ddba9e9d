#include "pipeline/study/questionnaire/service/service.h"

#include <algorithm>
#include <functional>

#include "motion/text/json_depth.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/base/documents/html.h"
#include "pipeline/manifest/texts/page_texts.h"
#include "pipeline/study/questionnaire/service/collected_answers.h"
#include "pipeline/study/questionnaire/service/record_check.h"
#include "pipeline/study/questionnaire/service/recruited_participants.h"
#include "pipeline/study/questionnaire/service/track_check.h"
#include "pipeline/study/questionnaire/service/withdrawal.h"

namespace mien::pipeline {

namespace {

bool is_reading(const HttpRequest& request) {
  return request.method == "GET" || request.method == "HEAD";
}

HttpResponse redirect(int status, const std::string& where) {
  HttpResponse response{
      .status = status, .type = "text/plain; charset=utf-8", .body = where + "\n"};
  response.headers["Location"] = where;
  return response;
}

/// A text of the pages in a language, as a paragraph.
std::string paragraph_in(const nlohmann::ordered_json& experiment, const std::string& language,
                         const char* text) {
  nlohmann::ordered_json texts = built_in_texts(language);
  if (const auto own = experiment.find("page_texts"); own != experiment.end())
    if (const auto found = own->find(language); found != own->end()) texts = *found;
  return "<p lang=\"" + html_escaped(language) + "\" dir=\"" +
         texts.at("direction").get<std::string>() + "\">" +
         html_escaped(texts.at("questionnaire").at(text).get<std::string>()) + "</p>";
}

/// A page for participants, with a text in each language of the study.
HttpResponse message_page(int status, const nlohmann::ordered_json& experiment, const char* text) {
  std::string paragraphs;
  if (const auto languages = experiment.find("languages"); languages != experiment.end()) {
    for (const auto& [language, shown] : languages->items())
      paragraphs += paragraph_in(experiment, language, text);
  } else {
    paragraphs = paragraph_in(experiment, experiment.value("language", "en"), text);
  }
  return {.status = status,
          .type = "text/html; charset=utf-8",
          .body = html_page("Questionnaire", "", paragraphs)};
}

/// The posted JSON; discarded if it is malformed or nested too deeply.
nlohmann::json json_of(const HttpRequest& request) {
  constexpr std::size_t deepest = 16;
  if (motion::is_nested_deeper(request.body, deepest))
    return nlohmann::json(nlohmann::json::value_t::discarded);
  return nlohmann::json::parse(request.body, nullptr, false);
}

/// Parses the posted record, checks that its name is that in the path, and returns the response of
/// `take`. Where `salt` is given, the values of URL parameters are replaced by hashes.
HttpResponse with_record(
    const HttpRequest& request, const std::optional<std::string>& salt,
    const std::function<HttpResponse(const PageRecord&, const std::string&)>& take) {
  if (!is_json(request))
    return http_refusal(415, "type", "this is not JSON", "send Content-Type: application/json");
  nlohmann::json text = json_of(request);
  if (text.is_discarded())
    return http_refusal(400, "malformed", "this is not JSON", "load the page again");
  try {
    PageRecord record = read_record(text);
    if (salt) pseudonymise(record, text, *salt);
    if (record.name != request.path.back()) throw RecordFault("the record belongs to another page");
    return take(record, text.dump());
  } catch (const RecordFault& fault) {
    return http_refusal(400, "malformed", fault.what(), "load the page again");
  }
}

HttpResponse other_browser() {
  return http_refusal(409, "elsewhere", "this session was started in another browser",
                      "continue there, or ask for another link");
}

/// A text in the posted JSON; nullopt if it is not there.
std::optional<std::string> text_in(const HttpRequest& request, const char* member) {
  if (!is_json(request)) return std::nullopt;
  const nlohmann::json given = json_of(request);
  if (!given.is_object()) return std::nullopt;
  const auto found = given.find(member);
  if (found == given.end() || !found->is_string()) return std::nullopt;
  return found->get<std::string>();
}

}  // namespace

QuestionnaireService::QuestionnaireService(const ServedStudy& study, SessionStore& store,
                                           ServiceRates rates, ClockSeconds clock)
    : study_(study),
      clock_(clock),
      sessions_(study, store, clock),
      link_rate_(rates.link),
      shared_rate_(rates.shared),
      live_rate_(rates.live),
      wrong_rate_(rates.wrong),
      joining_rate_(rates.joining) {}

std::string QuestionnaireService::last_failure() const {
  const std::lock_guard lock(last_failure_mutex_);
  return last_failure_;
}

void QuestionnaireService::set_last_failure(const std::string& last_failure) {
  const std::lock_guard lock(last_failure_mutex_);
  last_failure_ = last_failure;
}

HttpResponse QuestionnaireService::answer(const HttpRequest& request) {
  try {
    return answer_kind(request);
  } catch (const WriteFailure& failure) {
    set_last_failure(failure.what());
    return http_refusal(507, "full", "the answer could not be stored", "send it again later");
  }
}

HttpResponse QuestionnaireService::answer_kind(const HttpRequest& request) {
  const std::string& kind = request.path.front();
  if (kind == "s") return answer_session(request);
  if (kind == "media") return answer_media(request);
  if (kind == "join") return answer_join(request);
  if (kind == "lab") return answer_lab(request);
  if (kind == "robots.txt" && request.path.size() == 1)
    return {.body = "User-agent: *\nDisallow: /\n"};
  return unknown(request);
}

/// Many requests for unknown links suggest guessing, and are limited.
HttpResponse QuestionnaireService::unknown(const HttpRequest& request) {
  if (!wrong_rate_.allows(request.address)) return http_too_many_requests();
  if (is_reading(request) && request.path.size() <= 3 && request.path.back().empty())
    return message_page(404, study_.experiment, "unknown_link");
  return http_refusal(404, "unknown", "page not found", "check the address");
}

HttpResponse QuestionnaireService::answer_session(const HttpRequest& request) {
  if (request.path.size() < 2) return unknown(request);
  const std::optional<int> session = sessions_.find(request.path[1]);
  if (!session) return unknown(request);
  if (study_.live && request.path.size() == 4 && request.path[2] == "live")
    return answer_live(request);
  if (!link_rate_.allows(request.path[1])) return http_too_many_requests();
  if (request.path.size() == 4 && request.path[2] == "records")
    return request.method == "POST" ? take_record(request, *session)
                                    : http_method_not_allowed("POST");
  if (request.path.size() == 3 && request.path[2] == "withdrawal")
    return request.method == "POST" ? take_withdrawal(request, *session)
                                    : http_method_not_allowed("POST");
  if (has_shared_chains() && request.path.size() == 4 && request.path[2] == "step")
    return request.method == "POST" ? assign_step(request, *session)
                                    : http_method_not_allowed("POST");
  if (!is_reading(request)) return http_method_not_allowed("GET, HEAD");
  return answer_in_session(request, *session);
}

HttpResponse QuestionnaireService::answer_in_session(const HttpRequest& request, int session) {
  if (request.path.size() == 2) return redirect(308, "/s/" + request.path[1] + "/");
  if (request.path.size() > 3) return unknown(request);
  const std::string& name = request.path[2];
  if (name == "session.json") {
    sessions_.note_request(session);
    const SessionState state = sessions_.state(session);
    const auto stored_end = state.names.begin() + static_cast<std::ptrdiff_t>(state.stored);
    return http_json(session_json(study_, state.session.plan, state.session.participant,
                                  {.stored = {state.names.begin(), stored_end},
                                   .browser = state.browser,
                                   .ended = state.ended,
                                   .destination = destination_of(session),
                                   .answered = answered_levels(state)}));
  }
  const std::optional<HttpResponse> file = page_file(name);
  return file ? *file : unknown(request);
}

std::vector<PageRecord> QuestionnaireService::stored_records(int session) const {
  std::vector<PageRecord> records;
  for (const StoredRecord& stored : sessions_.store().records_of(session))
    records.push_back(read_record(nlohmann::json::parse(stored.content)));
  return records;
}

nlohmann::ordered_json QuestionnaireService::answered_levels(const SessionState& state) const {
  if (!study_.facts.tracks) return nullptr;
  return answered_levels_json(sessions_.plan_of(state.session),
                              stored_records(state.session.index));
}

HttpResponse QuestionnaireService::answer_live(const HttpRequest& request) {
  if (!live_rate_.allows(request.path[1])) return http_too_many_requests();
  return study_.live->answer(request, std::span(request.path).subspan(3));
}

std::optional<HttpResponse> QuestionnaireService::page_file(const std::string& name) const {
  const auto file = study_.page.find(name.empty() ? "index.html" : name);
  if (file == study_.page.end()) return std::nullopt;
  return HttpResponse{.type = file->second.type, .body = file->second.bytes};
}

HttpResponse QuestionnaireService::take_record(const HttpRequest& request, int session) {
  const SessionState state = sessions_.state(session);
  const std::string& name = request.path[3];
  if (std::ranges::find(state.names, name) == state.names.end())
    return http_refusal(404, "unknown", "this session has no such page", "load the page again");
  return with_record(request, salt(), [&](const PageRecord& record, const std::string& content) {
    const SessionPlan plan = sessions_.plan_of(state.session);
    check_record(study_.facts, plan, record);
    // Records that are not the next are refused, or repeat a stored one.
    if (study_.facts.tracks && state.stored < state.names.size() &&
        state.names[state.stored] == record.name)
      check_level_shown(study_.facts, plan, record, stored_records(session));
    if (record.matching)
      check_distances(*study_.live, *trial_of(plan, record.name), *record.matching);
    return keep_record(session, record, content);
  });
}

bool QuestionnaireService::has_shared_chains() const {
  return study_.facts.chains && study_.facts.chains->across_participants;
}

HttpResponse QuestionnaireService::assign_step(const HttpRequest& request, int session) {
  const std::optional<std::string> browser = text_in(request, "session");
  const SessionState state = sessions_.state(session);
  const SessionPlan plan = sessions_.plan_of(state.session);
  const Trial* trial = trial_of(plan, request.path[3]);
  if (trial == nullptr || trial->practice || trial->is_attention_check() || state.ended)
    return http_refusal(404, "unknown", "this session has no such trial", "load the page again");
  if (!browser)
    return http_refusal(400, "malformed", "names no browser session", "load the page again");
  const StepAssignment assigned = sessions_.assign_step(session, *browser, request.path[3]);
  if (assigned.is_other_browser) return other_browser();
  if (assigned.step) return http_value(step_json(study_.facts.chains->design, *assigned.step));
  if (assigned.reason == NoStep::finished)
    return http_refusal(409, "finished", "all chains are complete",
                        "no further answers are needed");
  HttpResponse response = http_refusal(503, "busy", "all open steps are with other participants",
                                       "ask again in a few seconds");
  response.headers["Retry-After"] = "2";
  return response;
}

/// Only the browser in which the session was begun may withdraw; again, it has the same answer.
HttpResponse QuestionnaireService::take_withdrawal(const HttpRequest& request, int session) {
  const std::optional<std::string> browser = text_in(request, "session");
  if (!browser)
    return http_refusal(400, "malformed", "names no browser session", "load the page again");
  const SessionState state = sessions_.state(session);
  if (state.ended != SessionEnd::withdrawn) {
    if (state.stored == 0 || state.browser != *browser)
      return http_refusal(409, "elsewhere", "this session was started in another browser",
                          "withdraw there, or ask the experimenter");
    sessions_.withdraw(session);
    set_last_failure("");
  }
  nlohmann::ordered_json answer = {{"ended", word_of(session_end_words, SessionEnd::withdrawn)}};
  if (auto destination = destination_of(session); !destination.is_null())
    answer["destination"] = std::move(destination);
  return http_value(answer);
}

HttpResponse QuestionnaireService::take_lab_withdrawal(const HttpRequest& request) {
  const std::optional<std::string> name = text_in(request, "participant");
  if (!name) return http_refusal(400, "malformed", "names no participant", "load the page again");
  const std::optional<int> session = session_of(sessions_.store(), *name);
  if (!session)
    return http_refusal(404, "unknown", "no participant with this id or code has given consent",
                        "check what was entered");
  const std::string participant = sessions_.state(*session).session.participant;
  return http_value({{"participant", participant}, {"erased", sessions_.withdraw(*session)}});
}

HttpResponse QuestionnaireService::keep_record(int session, const PageRecord& record,
                                               const std::string& content) {
  const SubmissionResult given = sessions_.submit(session, record, content);
  if (!given.is_other_browser) set_last_failure("");
  if (given.is_other_browser) return other_browser();
  if (given.is_taken)
    return http_refusal(409, "taken", "somebody else has answered this step in the meantime",
                        "ask for another step");
  if (given.ended)
    return http_refusal(409, std::string(word_of(session_end_words, *given.ended)),
                        "the session has ended", "no further answers are accepted");
  if (given.outcome == RecordOutcome::other)
    return http_refusal(409, "other", "a different answer has already been stored",
                        "the stored answer is kept");
  if (given.outcome == RecordOutcome::out_of_order)
    return http_value({{"error", "order"},
                       {"wrong", "an earlier page has not been answered"},
                       {"remedy", "send the earlier page first"},
                       {"next", given.next}},
                      409);
  nlohmann::ordered_json kept = {{"kept", record.name}};
  if (const auto ended = sessions_.state(session).ended)
    kept["ended"] = word_of(session_end_words, *ended);
  if (auto destination = destination_of(session); !destination.is_null())
    kept["destination"] = std::move(destination);
  return http_value(kept);
}

std::optional<std::string> QuestionnaireService::salt() const {
  if (!study_.facts.recruitment.pseudonymise) return std::nullopt;
  return sessions_.salt();
}

nlohmann::ordered_json QuestionnaireService::destination_of(int session) const {
  const SessionState state = sessions_.state(session);
  if (state.ended) return destination_json(study_.experiment, *state.ended);
  if (!state.has_finished()) return nullptr;
  return destination_json(study_.experiment,
                          completed_end(study_.facts, sessions_.plan_of(state.session),
                                        sessions_.store().records_of(session)));
}

HttpResponse QuestionnaireService::answer_media(const HttpRequest& request) const {
  if (!is_reading(request)) return http_method_not_allowed("GET, HEAD");
  const auto media =
      request.path.size() == 2 ? study_.media.find(request.path[1]) : study_.media.end();
  if (media == study_.media.end())
    return http_refusal(404, "unknown", "page not found", "check the address");
  return http_file(request, media->second.file, media->second.type);
}

HttpResponse QuestionnaireService::answer_join(const HttpRequest& request) {
  const std::vector<std::string>& path = request.path;
  if (path.size() < 2 || path[1] != sessions_.join_link()) return unknown(request);
  if (path.size() == 4 && path[2] == "records" && path[3] == consent_record)
    return request.method == "POST" ? take_joining(request) : http_method_not_allowed("POST");
  if (!is_reading(request)) return http_method_not_allowed("GET, HEAD");
  if (path.size() == 2) return redirect(308, "/join/" + path[1] + "/");
  if (path.size() > 3) return unknown(request);
  if (!shared_rate_.allows(request.address)) return http_too_many_requests();
  if (path[2] == "session.json") return http_json(joining_json(study_, sessions_.has_enough()));
  const std::optional<HttpResponse> file = page_file(path[2]);
  return file ? *file : unknown(request);
}

/// Nothing is stored about visitors who refuse, except their number, or who leave.
HttpResponse QuestionnaireService::take_joining(const HttpRequest& request) {
  if (!joining_rate_.allows(request.address)) return http_too_many_requests();
  return with_record(request, salt(), [&](const PageRecord& consent, const std::string& content) {
    check_record(study_.facts, study_.plans.front(), consent);
    if (is_refusal(consent)) {
      try {
        sessions_.count_refusal(consent);
      } catch (const WriteFailure& failure) {  // whoever refuses need not wait for a full disk
        set_last_failure(failure.what());
      }
      return http_value({{"kept", consent.name}});
    }
    const JoinResult joined = sessions_.join(consent, content);
    if (joined.is_other_browser) return other_browser();
    if (!joined.session)
      return http_refusal(409, "enough", "all places in this study have been taken",
                          "no further answers are accepted");
    set_last_failure("");
    const std::string where = "../../s/" + joined.session->session.link + "/";
    return http_value({{"kept", consent.name}, {"session", where}});
  });
}

HttpResponse QuestionnaireService::answer_lab(const HttpRequest& request) {
  if (request.path.size() < 2 || request.path[1] != sessions_.lab_link()) return unknown(request);
  if (request.path.size() == 3 && request.path[2] == "withdrawal")
    return request.method == "POST" ? take_lab_withdrawal(request)
                                    : http_method_not_allowed("POST");
  if (!is_reading(request)) return http_method_not_allowed("GET, HEAD");
  if (request.path.size() == 2) return redirect(308, "/lab/" + sessions_.lab_link() + "/");
  std::optional<HttpResponse> answer;
  if (request.path.size() == 3)
    answer = lab_answer(request, study_, sessions_, last_failure(), clock_());
  return answer ? *answer : unknown(request);
}

}  // namespace mien::pipeline

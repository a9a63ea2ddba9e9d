#include "pipeline/questionnaire/service/service.h"

#include <algorithm>

#include "pipeline/documents/files.h"
#include "pipeline/documents/html.h"
#include "pipeline/questionnaire/service/lab_page.h"
#include "pipeline/questionnaire/service/record_check.h"

namespace mien::pipeline {

namespace {

bool is_reading(const HttpRequest& request) {
  return request.method == "GET" || request.method == "HEAD";
}

HttpResponse wrong_method(const std::string& allowed) {
  HttpResponse response = http_refusal(405, "method", "this cannot be done here", allowed);
  response.headers["Allow"] = allowed;
  return response;
}

HttpResponse too_often() {
  HttpResponse response =
      http_refusal(429, "often", "too many requests", "wait a few seconds and ask again");
  response.headers["Retry-After"] = "5";
  return response;
}

HttpResponse redirect(int status, const std::string& where) {
  HttpResponse response{
      .status = status, .type = "text/plain; charset=utf-8", .body = where + "\n"};
  response.headers["Location"] = where;
  return response;
}

/// For people who open a link.
HttpResponse message_page(int status, const std::string& english, const std::string& japanese) {
  return {.status = status,
          .type = "text/html; charset=utf-8",
          .body = html_page("Questionnaire", "",
                            "<p>" + html_escaped(english) + "</p><p lang=\"ja\">" +
                                html_escaped(japanese) + "</p>")};
}

/// "application/json", with or without parameters.
bool is_json(const HttpRequest& request) {
  const auto type = request.headers.find("content-type");
  if (type == request.headers.end()) return false;
  std::string name = type->second.substr(0, type->second.find(';'));
  while (!name.empty() && name.back() == ' ') name.pop_back();
  return name == "application/json";
}

}  // namespace

QuestionnaireService::QuestionnaireService(const ServedStudy& study, SessionStore& store,
                                           ServiceRates rates, ClockSeconds clock)
    : study_(study),
      clock_(clock),
      sessions_(study, store, clock),
      link_rate_(rates.link),
      wrong_rate_(rates.wrong),
      joining_rate_(rates.joining) {}

std::string QuestionnaireService::trouble() const {
  const std::lock_guard lock(trouble_mutex_);
  return trouble_;
}

void QuestionnaireService::set_trouble(const std::string& trouble) {
  const std::lock_guard lock(trouble_mutex_);
  trouble_ = trouble;
}

HttpResponse QuestionnaireService::answer(const HttpRequest& request) {
  try {
    return answer_kind(request);
  } catch (const WriteFailure& failure) {
    set_trouble(failure.what());
    return http_refusal(507, "full", "the answer could not be kept", "send it again in a while");
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

/// Of those that ask for much that is not there, somebody is guessing.
HttpResponse QuestionnaireService::unknown(const HttpRequest& request) {
  if (!wrong_rate_.allows(request.address)) return too_often();
  if (is_reading(request) && request.path.size() <= 3 && request.path.back().empty())
    return message_page(404, "This link is not known here. Please ask the experimenter for yours.",
                        "このリンクは登録されていません。実験者にお尋ねください。");
  return http_refusal(404, "unknown", "there is nothing here", "check the address");
}

HttpResponse QuestionnaireService::answer_session(const HttpRequest& request) {
  if (request.path.size() < 2) return unknown(request);
  const std::optional<int> session = sessions_.find(request.path[1]);
  if (!session) return unknown(request);
  if (!link_rate_.allows(request.path[1])) return too_often();
  if (request.path.size() == 4 && request.path[2] == "records")
    return request.method == "POST" ? take_record(request, *session) : wrong_method("POST");
  if (!is_reading(request)) return wrong_method("GET, HEAD");
  return answer_own(request, *session);
}

HttpResponse QuestionnaireService::answer_own(const HttpRequest& request, int session) {
  if (request.path.size() == 2) return redirect(308, "/s/" + request.path[1] + "/");
  if (request.path.size() > 3) return unknown(request);
  const std::string& name = request.path[2];
  if (name == "session.json") {
    sessions_.see(session);
    const SessionState state = sessions_.state(session);
    return http_json(session_json(
        study_, state.session.plan, state.session.participant,
        {state.names.begin(), state.names.begin() + static_cast<std::ptrdiff_t>(state.kept)}));
  }
  const auto file = study_.page.find(name.empty() ? "index.html" : name);
  if (file == study_.page.end()) return unknown(request);
  return {.type = file->second.type, .body = file->second.bytes};
}

HttpResponse QuestionnaireService::take_record(const HttpRequest& request, int session) {
  const SessionState state = sessions_.state(session);
  const std::string& name = request.path[3];
  if (std::ranges::find(state.names, name) == state.names.end())
    return http_refusal(404, "unknown", "this session has no such page", "load the page again");
  if (!is_json(request))
    return http_refusal(415, "type", "this is no JSON", "send Content-Type: application/json");
  const nlohmann::json text = nlohmann::json::parse(request.body, nullptr, false);
  if (text.is_discarded())
    return http_refusal(400, "malformed", "this is no JSON", "load the page again");
  try {
    const PageRecord record = read_record(text);
    if (record.name != name) throw RecordFault("the record is of another page");
    check_record(study_.facts, sessions_.plan_of(state.session), record);
    return keep_record(session, record, text.dump());
  } catch (const RecordFault& fault) {
    return http_refusal(400, "malformed", fault.what(), "load the page again");
  }
}

HttpResponse QuestionnaireService::keep_record(int session, const PageRecord& record,
                                               const std::string& content) {
  const GivenRecord given = sessions_.give(session, record, content);
  set_trouble("");
  if (given.has_refused)
    return http_refusal(409, "refused", "the participant has not agreed", "nothing more is taken");
  if (given.keeping == Keeping::other)
    return http_refusal(409, "other", "another answer was kept before", "that one stays");
  const auto replace = nlohmann::ordered_json::error_handler_t::replace;
  if (given.keeping == Keeping::out_of_order) {
    HttpResponse refusal = http_json("");
    refusal.status = 409;
    refusal.body = nlohmann::ordered_json{
        {"error", "order"},
        {"wrong", "something goes before it"},
        {"remedy", "send what is due"},
        {"next",
         given.next}}.dump(-1, ' ', false, replace);
    return refusal;
  }
  return http_json(nlohmann::ordered_json{{"kept", record.name}}.dump(-1, ' ', false, replace));
}

HttpResponse QuestionnaireService::answer_media(const HttpRequest& request) const {
  if (!is_reading(request)) return wrong_method("GET, HEAD");
  const auto media =
      request.path.size() == 2 ? study_.media.find(request.path[1]) : study_.media.end();
  if (media == study_.media.end())
    return http_refusal(404, "unknown", "there is nothing here", "check the address");
  return http_file(request, media->second.file, media->second.type);
}

HttpResponse QuestionnaireService::answer_join(const HttpRequest& request) {
  if (request.path.size() < 2 || request.path.size() > 3 ||
      request.path[1] != sessions_.join_link() || !request.path.back().empty())
    return request.path.size() == 2 && request.path[1] == sessions_.join_link()
               ? redirect(308, "/join/" + sessions_.join_link() + "/")
               : unknown(request);
  if (request.method != "GET") return wrong_method("GET");
  if (!joining_rate_.allows(request.address)) return too_often();
  const std::optional<SessionState> joined = sessions_.join();
  if (!joined)
    return message_page(403, "Enough people have taken part. Thank you for coming.",
                        "必要な人数が集まりました。お越しいただきありがとうございました。");
  return redirect(303, "/s/" + joined->session.link + "/");
}

HttpResponse QuestionnaireService::answer_lab(const HttpRequest& request) {
  if (request.path.size() < 2 || request.path[1] != sessions_.lab_link()) return unknown(request);
  if (!is_reading(request)) return wrong_method("GET, HEAD");
  if (request.path.size() == 2) return redirect(308, "/lab/" + sessions_.lab_link() + "/");
  std::optional<HttpResponse> answer;
  if (request.path.size() == 3)
    answer = lab_answer(request, study_, sessions_, trouble(), clock_());
  return answer ? *answer : unknown(request);
}

}  // namespace mien::pipeline

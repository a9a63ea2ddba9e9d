#include <algorithm>
#include <cctype>

#include "pipeline/study/questionnaire/service/collected_answers.h"

namespace mien::pipeline {

namespace {

std::string state_word(const SessionState& state, std::int64_t now) {
  if (state.ended) return std::string(word_of(session_end_words, *state.ended));
  if (state.has_finished()) return "done";
  if (state.stored == 0) return state.last_seen == 0 ? "waiting" : "opened";
  return state.is_online(now) ? "here" : "away";
}

nlohmann::ordered_json status_of(const SessionState& state, std::int64_t now) {
  nlohmann::ordered_json last = nullptr;
  if (state.last_seen != 0) last = std::max<std::int64_t>(0, now - state.last_seen);
  return {{"participant", state.session.participant},
          {"link", "/s/" + state.session.link + "/"},
          {"state", state_word(state, now)},
          {"came_by", state.session.entry_route},
          {"kept", state.stored},
          {"records", state.names.size()},
          {"next", state.has_finished() || state.ended ? "" : state.names[state.stored]},
          {"seen_seconds_ago", last}};
}

bool has_continuous_trials(const ServedStudy& study) {
  return std::ranges::any_of(study.plans, [](const SessionPlan& plan) {
    return std::ranges::any_of(plan.trials,
                               [](const Trial& trial) { return trial.kind == &continuous_trials; });
  });
}

/// Ends of a scale, as participants see them.
void add_poles(nlohmann::ordered_json& histogram, const ServedStudy& study) {
  const auto& items = study.experiment.at("items");
  const auto item = items.find(histogram.at("item").get<std::string>());
  if (item == items.end() || histogram.at("is_pair")) return;
  histogram["low"] = item->value("low", "");
  histogram["high"] = item->value("high", "");
}

nlohmann::ordered_json lab_status(const ServedStudy& study, const StudySessions& sessions,
                                  const std::string& last_failure, std::int64_t now) {
  nlohmann::ordered_json participants = nlohmann::ordered_json::array();
  for (const SessionState& state : sessions.states()) participants.push_back(status_of(state, now));
  nlohmann::ordered_json histograms = sessions.histograms();
  for (nlohmann::ordered_json& histogram : histograms) add_poles(histogram, study);
  return {{"study", study.experiment.at("study")},
          {"title", study.experiment.at("title")},
          {"design", study.facts.design},
          {"is_matching", study.facts.matching.has_value()},
          {"is_adaptive", study.facts.chains.has_value()},
          {"steps", sessions.step_progress()},
          {"has_traces", has_continuous_trials(study)},
          {"trouble", last_failure},
          {"has_erased_log", sessions.store().has_erased_log()},
          {"planned", study.plans.size()},
          {"join", "/join/" + sessions.join_link() + "/"},
          {"refused_at_join", sessions.refusals()},
          {"participants", std::move(participants)},
          {"checks", sessions.checks()},
          {"histograms", std::move(histograms)}};
}

HttpResponse saved_as(const std::string& name, const std::string& type, std::string text) {
  HttpResponse response{.type = type, .body = std::move(text)};
  response.headers["Content-Disposition"] = "attachment; filename=\"" + name + "\"";
  return response;
}

/// The server's origin as the browser addressed it.
std::string base_of(const HttpRequest& request) {
  const std::string host = header_of(request, "host");
  const bool is_plain = std::ranges::all_of(host, [](unsigned char one) {
    return std::isalnum(one) != 0 || one == '.' || one == ':' || one == '-' || one == '[' ||
           one == ']';
  });
  const bool is_secure = header_of(request, "x-forwarded-proto") == "https";
  return is_plain && !host.empty() ? (is_secure ? "https://" : "http://") + host : std::string();
}

}  // namespace

std::optional<HttpResponse> lab_answer(const HttpRequest& request, const ServedStudy& study,
                                       const StudySessions& sessions,
                                       const std::string& last_failure, std::int64_t now) {
  const std::string& name = request.path.at(2);
  const std::string csv = "text/csv; charset=utf-8";
  const std::string file = study.experiment.at("study").get<std::string>() + "-" + name;
  const auto page = study.lab.find(name.empty() ? "index.html" : name);
  if (page != study.lab.end())
    return HttpResponse{.type = page->second.type, .body = page->second.bytes};
  if (name == "status.json") return http_value(lab_status(study, sessions, last_failure, now));
  if (study.facts.matching && name == "trials.csv")
    return saved_as(file, csv, trials_csv(study, sessions));
  if (study.facts.matching && name == "changes.csv")
    return saved_as(file, csv, changes_csv(study, sessions));
  if (study.facts.chains && name == "steps.csv")
    return saved_as(file, csv, steps_csv(study, sessions));
  if (!study.facts.matching && !study.facts.chains && name == "answers.csv")
    return saved_as(file, csv, answers_csv(study, sessions));
  if (has_continuous_trials(study) && name == "traces.csv")
    return saved_as(file, csv, traces_csv(study, sessions));
  if (name == "participants.csv") return saved_as(file, csv, participants_csv(study, sessions));
  if (name == "links.csv")
    return saved_as(
        file, csv,
        links_csv(sessions, study.public_url.empty() ? base_of(request) : study.public_url));
  if (name == "answers.json")
    return saved_as(file, "application/json; charset=utf-8", answers_json(study, sessions));
  return std::nullopt;
}

}  // namespace mien::pipeline

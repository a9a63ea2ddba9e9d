#include "pipeline/study/questionnaire/service/study_sessions.h"

#include <algorithm>
#include <chrono>
#include <ctime>

#include <fmt/chrono.h>
#include <fmt/format.h>

#include "motion/text/as_number.h"
#include "motion/text/excerpt.h"
#include "pipeline/study/questionnaire/service/record_check.h"

namespace mien::pipeline {

namespace {

/// The answer of a record to a step of a chain across participants.
std::optional<StoredStep> stored_step(int session, const PageRecord& record) {
  if (!record.chain) return std::nullopt;
  const ChainRecord& answer = *record.chain;
  return StoredStep{.chain = ChainName{answer.word, answer.chain, ""}.key(),
                    .step = answer.step,
                    .person = answer.person,
                    .content = chain_json(answer).dump(),
                    .session = session};
}

/// Limits of sessions for each planned one: of those that did not end early, and of all.
constexpr std::size_t max_sessions_per_plan = 4;
constexpr std::size_t max_all_sessions_per_plan = 40;

constexpr char study_fact[] = "study";
constexpr char design_fact[] = "design";
constexpr char media_fact[] = "media";
constexpr char lab_fact[] = "lab link";
constexpr char join_fact[] = "join link";
constexpr char salt_fact[] = "pseudonym salt";
constexpr char refusals_fact[] = "refusals at the open link";

}  // namespace

std::int64_t system_seconds() {
  return std::chrono::duration_cast<std::chrono::seconds>(
             std::chrono::system_clock::now().time_since_epoch())
      .count();
}

std::string iso_time(std::int64_t seconds) {
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(static_cast<std::time_t>(seconds)));
}

std::int64_t seconds_of(const std::string& iso_time) {
  std::tm parts{};
  const char* end = strptime(iso_time.c_str(), "%Y-%m-%dT%H:%M:%SZ", &parts);
  return end != nullptr && *end == '\0' ? timegm(&parts) : 0;
}

StudySessions::StudySessions(const ServedStudy& study, SessionStore& store, ClockSeconds clock)
    : study_(study), store_(store), clock_(std::move(clock)), results_(study.facts) {
  if (!store_.fact(design_fact)) begin();
  const std::string name = study_.experiment.at("study");
  if (store_.fact(study_fact) != name)
    throw Error(
        {store_.file().string()},
        fmt::format("holds answers of the study {}", motion::in_quotes(*store_.fact(study_fact))),
        "name another file with --store");
  const bool has_same_design = store_.fact(design_fact) == study_.facts.design;
  if (!has_same_design || store_.fact(media_fact) != media_hash(study_))
    throw Error({store_.file().string()},
                has_same_design ? (study_.live ? "was started with different motions or another "
                                                 "number of participants"
                                               : "was started with different videos")
                : study_.live ? "was started with a different experiment: texts, plans, sliders or "
                                "settings have changed since"
                              : "was started with a different questionnaire: texts, plans or "
                                "participants have changed since",
                study_.live
                    ? "serve the unchanged experiment, or start again with another file (--store)"
                    : "serve the unchanged study, or start again with another file (--store); mien "
                      "study report accepts several files of answers");
  lab_link_ = store_.fact(lab_fact).value();
  join_link_ = store_.fact(join_fact).value();
  salt_ = store_.fact(salt_fact).value_or("");
  load();
  if (!study_.facts.chains || !study_.facts.chains->across_participants) return;
  chains_.emplace(*study_.facts.chains);
  for (const StoredStep& step : store_.steps())
    chains_->add(step.session.value_or(-1), read_chain_record(nlohmann::json::parse(step.content)));
}

void StudySessions::begin() {
  std::vector<StoredSession> sessions;
  for (std::size_t plan = 0; plan < study_.plans.size(); ++plan)
    sessions.push_back({.index = static_cast<int>(plan),
                        .plan = static_cast<int>(plan),
                        .participant = study_.plans[plan].participant,
                        .link = random_link()});
  store_.begin({{study_fact, study_.experiment.at("study").get<std::string>()},
                {design_fact, study_.facts.design},
                {media_fact, media_hash(study_)},
                {lab_fact, random_link()},
                {join_fact, random_link()},
                {salt_fact, random_link()}},
               sessions);
}

void StudySessions::load() {
  for (const StoredSession& session : store_.sessions()) add_state(session);
  for (const StoredRecord& stored : store_.records()) {
    SessionState& state = states_.at(static_cast<std::size_t>(stored.session));
    count(state, read_record(nlohmann::json::parse(stored.content)));
    state.last_seen = std::max(state.last_seen, seconds_of(stored.stored_at));
  }
}

void StudySessions::add_state(const StoredSession& session) {
  SessionState state{.session = session};
  state.names = record_names(study_.plans.at(static_cast<std::size_t>(session.plan)), study_.facts);
  state.ended = meaning_of(session_end_words, session.ended);
  by_link_[session.link] = session.index;
  states_.push_back(std::move(state));
}

void StudySessions::count(SessionState& state, const PageRecord& record) {
  if (state.stored++ == 0) state.browser = record.session;
  if (is_refusal(record)) state.ended = SessionEnd::refused;
  if (fails_check(state, record)) ++state.failed_checks;
  if (record.name == screening_record) {
    state.screening = record.responses;
    state.screening_fault = screening_fault(study_.facts.screening, record);
    // What only a quota can have decided.
    if (state.ended == SessionEnd::screened_out && state.screening_fault == ScreeningFault::none)
      state.screening_fault = ScreeningFault::quota;
  }
  const SessionPlan plan = plan_of(state.session);
  if (const Trial* trial = trial_of(plan, record.name))
    results_.add(rows_of(study_.facts, plan, *trial, record));
}

std::optional<int> StudySessions::find(const std::string& link) const {
  const std::lock_guard lock(mutex_);
  const auto found = by_link_.find(link);
  return found == by_link_.end() ? std::nullopt : std::optional<int>(found->second);
}

SessionState StudySessions::state(int session) const {
  const std::lock_guard lock(mutex_);
  return states_.at(static_cast<std::size_t>(session));
}

std::vector<SessionState> StudySessions::states() const {
  const std::lock_guard lock(mutex_);
  return states_;
}

void StudySessions::note_request(int session) {
  const std::lock_guard lock(mutex_);
  states_.at(static_cast<std::size_t>(session)).last_seen = clock_();
}

void StudySessions::mark_begun(SessionState& state) {
  if (!state.session.begun_at.empty()) return;
  const std::string now = iso_time(state.last_seen);
  store_.mark_begun(state.session.index, "link", now);
  state.session.begun_at = now;
  state.session.entry_route = "link";
}

SubmissionResult StudySessions::submit(int session, const PageRecord& record,
                                       const std::string& content) {
  const std::lock_guard lock(mutex_);
  SessionState& state = states_.at(static_cast<std::size_t>(session));
  if (state.stored > 0 && state.browser != record.session) return {.is_other_browser = true};
  state.last_seen = clock_();
  const auto position = std::ranges::find(state.names, record.name) - state.names.begin();
  const bool is_stored_before = position < static_cast<std::ptrdiff_t>(state.stored);
  if (state.ended && !is_stored_before) return {.ended = state.ended};
  if (chains_ && !is_stored_before && !is_step_open(state, record)) return {.is_taken = true};
  const std::optional<SessionEnd> end = end_by(state, record);
  const std::string ended = end ? std::string(word_of(session_end_words, *end)) : "";
  const StepChange change = is_stored_before ? StepChange() : step_change(state, record, end);
  const RecordOutcome outcome = store_.keep({.session = session,
                                             .position = static_cast<int>(position),
                                             .name = record.name,
                                             .content = content,
                                             .stored_at = iso_time(state.last_seen)},
                                            ended, change);
  if (outcome == RecordOutcome::stored) {
    if (change.added) chains_->add(session, *record.chain);
    if (end) state.ended = end;
    if (chains_ && end == SessionEnd::failed_attention) chains_->forget_open(session);
    count(state, record);
    mark_begun(state);
  }
  const bool is_over = state.has_finished() || state.ended.has_value();
  return {.outcome = outcome, .next = is_over ? "" : state.names[state.stored]};
}

/// How the session ends early with this record.
std::optional<SessionEnd> StudySessions::end_by(const SessionState& state,
                                                const PageRecord& record) const {
  if (record.name == screening_record && fault_of(record) != ScreeningFault::none)
    return SessionEnd::screened_out;
  if (fails_check(state, record) &&
      state.failed_checks + 1 > study_.facts.chains->max_failed_checks)
    return SessionEnd::failed_attention;
  return std::nullopt;
}

bool StudySessions::fails_check(const SessionState& state, const PageRecord& record) const {
  if (!study_.facts.chains || !record.chain) return false;
  const SessionPlan plan = plan_of(state.session);
  const Trial* trial = trial_of(plan, record.name);
  return trial != nullptr && trial->is_attention_check() &&
         !passes_check(study_.facts.chains->design, trial->expected, *record.chain);
}

StepChange StudySessions::step_change(const SessionState& state, const PageRecord& record,
                                      const std::optional<SessionEnd>& end) const {
  StepChange change;
  if (!chains_) return change;
  const int session = state.session.index;
  if (is_chain_trial(state, record)) change.added = stored_step(session, record);
  if (end == SessionEnd::failed_attention)
    for (const ChainPlace& place : chains_->open_answers(session))
      change.removed.push_back(
          {.chain = place.name.key(), .step = place.step, .person = place.person});
  return change;
}

/// Practice and attention checks are not part of a chain across participants.
bool StudySessions::is_chain_trial(const SessionState& state, const PageRecord& record) const {
  const SessionPlan plan = plan_of(state.session);
  const Trial* trial = trial_of(plan, record.name);
  return trial != nullptr && !trial->practice && !trial->is_attention_check();
}

/// Whether chains across participants take the record. Without a step, all of them must be over.
bool StudySessions::is_step_open(const SessionState& state, const PageRecord& record) const {
  if (is_chain_trial(state, record) && record.chain)
    return chains_->is_open(state.session.index, *record.chain, clock_());
  const SessionPlan plan = plan_of(state.session);
  const Trial* trial = trial_of(plan, record.name);
  return trial == nullptr || record.chain.has_value() || chains_->is_finished();
}

StepAssignment StudySessions::assign_step(int session, const std::string& browser,
                                          const std::string& trial) {
  const std::lock_guard lock(mutex_);
  const SessionState& state = states_.at(static_cast<std::size_t>(session));
  StepAssignment assigned;
  assigned.is_other_browser = state.stored == 0 || state.browser != browser;
  if (!assigned.is_other_browser)
    assigned.step = chains_->assign(session, trial, clock_(), assigned.reason);
  return assigned;
}

std::pair<int, int> StudySessions::step_progress() const {
  const std::lock_guard lock(mutex_);
  return chains_ ? std::pair(chains_->complete_steps(), chains_->all_steps()) : std::pair(0, 0);
}

ScreeningFault StudySessions::fault_of(const PageRecord& record) const {
  const ScreeningFault own = screening_fault(study_.facts.screening, record);
  if (own != ScreeningFault::none) return own;
  const bool is_full = std::ranges::any_of(study_.facts.screening.quotas, [&](const Quota& quota) {
    return counts_for(quota, record.responses) && is_quota_full(quota);
  });
  return is_full ? ScreeningFault::quota : ScreeningFault::none;
}

/// Participants who have finished or are following their plan count. The caller must prevent others
/// from passing the screening meanwhile.
bool StudySessions::is_quota_full(const Quota& quota) const {
  const auto counted = std::ranges::count_if(states_, [&](const SessionState& state) {
    const bool is_there =
        state.has_finished() || (state.is_under_way() && state.is_online(clock_()));
    return is_there && counts_for(quota, state.screening);
  });
  return counted >= quota.at_most;
}

int StudySessions::withdraw(int session) {
  const std::lock_guard lock(mutex_);
  const int erased =
      store_.erase_records(session, std::string(word_of(session_end_words, SessionEnd::withdrawn)));
  // The results count the answers of all sessions.
  std::map<int, std::int64_t> seen;
  for (const SessionState& state : states_) seen[state.session.index] = state.last_seen;
  states_.clear();
  by_link_.clear();
  results_.clear();
  load();
  for (SessionState& state : states_) state.last_seen = seen[state.session.index];
  return erased;
}

bool StudySessions::has_enough() const {
  const std::lock_guard lock(mutex_);
  return is_full();
}

/// The caller must prevent other participants from joining meanwhile.
bool StudySessions::is_full() const {
  std::vector<bool> finished(study_.plans.size());
  std::size_t lasting = 0;
  for (const SessionState& state : states_) {
    lasting += state.ended ? 0 : 1;
    if (state.has_finished()) finished[static_cast<std::size_t>(state.session.plan)] = true;
  }
  return std::ranges::all_of(finished, std::identity()) ||
         lasting >= max_sessions_per_plan * study_.plans.size() ||
         states_.size() >= max_all_sessions_per_plan * study_.plans.size();
}

/// The caller must prevent other participants from joining meanwhile.
StoredSession StudySessions::additional_session() const {
  std::vector<int> given(study_.plans.size()), finished(study_.plans.size());
  for (const SessionState& state : states_) {
    const auto plan = static_cast<std::size_t>(state.session.plan);
    const bool is_under_way = state.is_under_way() && state.is_online(clock_());
    finished[plan] += state.has_finished() ? 1 : 0;
    given[plan] += state.has_finished() || is_under_way ? 1 : 0;
  }
  const int index = static_cast<int>(states_.size());
  return StoredSession{.index = index,
                       .plan = static_cast<int>(next_plan(study_.plans, given, finished)),
                       .participant = participant_name(index),
                       .link = random_link(),
                       .begun_at = iso_time(clock_()),
                       .entry_route = "join"};
}

JoinResult StudySessions::join(const PageRecord& consent, const std::string& content) {
  const std::lock_guard lock(mutex_);
  const auto again = std::ranges::find_if(states_, [&](const SessionState& state) {
    return state.session.entry_route == "join" && state.browser == consent.session;
  });
  // Tables show the names of browser sessions: they do not give the session's link to anybody.
  if (again != states_.end()) {
    const bool is_repeated =
        again->stored == 1 && store_.records_of(again->session.index).front().content == content;
    if (!is_repeated) return {.is_other_browser = true};
    return {.session = *again};
  }
  if (is_full()) return {};
  const StoredSession further = additional_session();
  store_.add(further, {.session = further.index,
                       .position = 0,
                       .name = consent.name,
                       .content = content,
                       .stored_at = further.begun_at});
  add_state(further);
  states_.back().last_seen = clock_();
  count(states_.back(), consent);
  return {.session = states_.back()};
}

void StudySessions::count_refusal(const PageRecord& consent) {
  constexpr std::size_t most_refused_browsers = 10000;
  const std::lock_guard lock(mutex_);
  if (refused_browsers_.contains(consent.session)) return;
  store_.add_to_count(refusals_fact);
  if (refused_browsers_.size() < most_refused_browsers) refused_browsers_.insert(consent.session);
}

int StudySessions::refusals() const {
  const std::string count = store_.fact(refusals_fact).value_or("0");
  return static_cast<int>(motion::as_written_number(count).value_or(0.0));
}

SessionPlan StudySessions::plan_of(const StoredSession& session) const {
  SessionPlan plan = study_.plans.at(static_cast<std::size_t>(session.plan));
  plan.participant = session.participant;
  return plan;
}

nlohmann::ordered_json StudySessions::histograms() const {
  const std::lock_guard lock(mutex_);
  return results_.histograms();
}

nlohmann::ordered_json StudySessions::checks() const {
  const std::lock_guard lock(mutex_);
  return results_.checks();
}

}  // namespace mien::pipeline

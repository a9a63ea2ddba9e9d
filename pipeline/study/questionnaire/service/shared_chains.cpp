#include "pipeline/study/questionnaire/service/shared_chains.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include <fmt/format.h>

#include "pipeline/study/questionnaire/orders.h"

namespace mien::pipeline {

nlohmann::ordered_json step_json(const ChainDesign& design, const AssignedStep& step) {
  nlohmann::ordered_json json = {{"word", step.name.word},
                                 {"chain", step.name.chain},
                                 {"step", step.step},
                                 {"person", step.person},
                                 {"point", step.point}};
  const StepView view = step_view(design, step.name, step.step, step.person);
  if (design.method == ChainMethod::gibbs) {
    json["dimension"] = view.dimension;
    json["slider"] = {{"start", view.slider.start}, {"reversed", view.slider.is_reversed}};
  } else {
    const ChoiceTrial trial = choice_trial(design.choices(step.name.word, step.name.participant),
                                           step.name.chain, step.step, step.point);
    json["proposal"] = trial.proposal;
    json["proposal_first"] = trial.is_proposal_first;
  }
  return json;
}

SharedChains::SharedChains(const ChainFacts& facts) : facts_(facts) {
  for (const std::string& word : facts.design.words)
    for (int chain = 1; chain <= facts.design.chains; ++chain) {
      const ChainName name{word, chain, ""};
      chains_.push_back({.name = name, .point = facts.starts.at(name.key())});
    }
}

std::optional<int> SharedChains::open_person(std::size_t at, int session, std::int64_t now) const {
  const Chain& chain = chains_[at];
  if (chain.step >= facts_.design.steps) return std::nullopt;
  for (const auto& [person, who] : chain.sessions)
    if (who == session) return std::nullopt;
  for (int person = 0; person < facts_.design.people_per_step; ++person) {
    if (chain.values.contains(person)) continue;
    const auto lease = leases_.find({at, chain.step, person});
    if (lease == leases_.end() || lease->second.until <= now) return person;
  }
  return std::nullopt;
}

std::optional<AssignedStep> SharedChains::assign(int session, const std::string& trial,
                                                 std::int64_t now, NoStep& reason) {
  std::erase_if(leases_, [&](const auto& lease) { return lease.second.until <= now; });
  const auto until = now + static_cast<std::int64_t>(std::ceil(facts_.answer_within_s));
  for (auto& [place, lease] : leases_) {
    const auto& [at, step, person] = place;
    if (lease.session != session || lease.trial != trial) continue;
    if (chains_[at].step != step || chains_[at].values.contains(person)) continue;
    return AssignedStep{chains_[at].name, step, person, chains_[at].point};
  }
  const std::vector<std::size_t> order =
      random_order(chains_.size(), facts_.design.seed, fmt::format("{} {}", session, trial));
  std::optional<std::tuple<int, bool, std::size_t, int>> best;  // steps, was last, chain, person
  for (const std::size_t at : order) {
    const std::optional<int> person = open_person(at, session, now);
    if (!person) continue;
    const std::tuple one{chains_[at].step, chains_[at].last_session == session, at, *person};
    const auto rank = [](const auto& of) { return std::pair(std::get<0>(of), std::get<1>(of)); };
    if (!best || rank(one) < rank(*best)) best = one;
  }
  if (!best) {
    reason = is_finished() ? NoStep::finished : NoStep::busy;
    return std::nullopt;
  }
  const auto [step, was_last, at, person] = *best;
  leases_[{at, step, person}] = {session, trial, until};
  return AssignedStep{chains_[at].name, step, person, chains_[at].point};
}

const SharedChains::Chain* SharedChains::chain_of(const ChainRecord& record) const {
  const auto found = std::ranges::find_if(chains_, [&](const Chain& chain) {
    return chain.name.word == record.word && chain.name.chain == record.chain;
  });
  return found == chains_.end() ? nullptr : &*found;
}

bool SharedChains::is_open(int session, const ChainRecord& record, std::int64_t now) const {
  const Chain* chain = chain_of(record);
  if (chain == nullptr || chain->step != record.step || chain->point != record.point ||
      chain->values.contains(record.person))
    return false;
  for (const auto& [person, who] : chain->sessions)
    if (who == session) return false;
  const auto at = static_cast<std::size_t>(chain - chains_.data());
  const auto lease = leases_.find({at, record.step, record.person});
  // After a restart nobody has a lease, and whoever answers first is taken.
  return lease == leases_.end() || lease->second.session == session || lease->second.until <= now;
}

void SharedChains::complete_step(Chain& chain, const ChainRecord& record) {
  if (facts_.design.method == ChainMethod::mcmc) {
    if (record.chose_proposal) chain.point = record.proposal;
  } else {
    std::vector<double> values;
    for (const auto& [person, value] : chain.values) values.push_back(value);
    chain.point[record.dimension] = aggregated(std::move(values), facts_.design.aggregate);
  }
  ++chain.step;
  chain.values.clear();
  chain.sessions.clear();
}

void SharedChains::add(int session, const ChainRecord& record) {
  const auto at = static_cast<std::size_t>(chain_of(record) - chains_.data());
  Chain& chain = chains_[at];
  chain.values[record.person] = record.value;
  chain.sessions[record.person] = session;
  chain.last_session = session;
  leases_.erase({at, record.step, record.person});
  if (std::ssize(chain.values) == facts_.design.people_per_step) complete_step(chain, record);
}

bool SharedChains::is_finished() const { return complete_steps() == all_steps(); }

int SharedChains::complete_steps() const {
  int steps = 0;
  for (const Chain& chain : chains_) steps += chain.step;
  return steps;
}

int SharedChains::all_steps() const {
  return facts_.design.steps * static_cast<int>(chains_.size());
}

}  // namespace mien::pipeline

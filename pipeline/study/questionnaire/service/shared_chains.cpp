#include "pipeline/study/questionnaire/service/shared_chains.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "pipeline/base/adaptive/chain_convergence.h"
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
  if (is_over(chain)) return std::nullopt;
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
  if (chain == nullptr || is_over(*chain) || chain->step != record.step ||
      chain->point != record.point || chain->values.contains(record.person))
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
  const bool is_sweep_end =
      static_cast<std::size_t>(chain.step) % facts_.design.steps_per_sweep() == 0;
  if (!facts_.design.until || !is_sweep_end) return;
  std::vector<double>& point = chain.sweeps.emplace_back(chain.point);
  if (facts_.design.has_relative_values) {
    const double sum = std::accumulate(point.begin(), point.end(), 0.0);
    for (double& value : point) value /= sum;
  }
  end_if_converged(chain.name.word);
}

/// R̂ is computed each time that the shortest chain has one more sweep, so that the order in which
/// answers to different chains come does not matter.
void SharedChains::end_if_converged(const std::string& word) {
  if (ended_words_.contains(word)) return;
  const auto is_of_word = [&](const Chain& chain) { return chain.name.word == word; };
  std::size_t shortest = std::numeric_limits<std::size_t>::max();
  for (const Chain& chain : chains_)
    if (is_of_word(chain)) shortest = std::min(shortest, chain.sweeps.size());
  if (shortest == std::exchange(sweeps_seen_[word], shortest)) return;
  const ChainEnd& until = *facts_.design.until;
  if (shortest < static_cast<std::size_t>(until.at_least)) return;
  std::vector<std::vector<std::vector<double>>> paths;
  for (const Chain& chain : chains_)
    if (is_of_word(chain)) paths.push_back(chain.sweeps);
  if (have_converged(paths, 1, until.r_hat)) ended_words_.insert(word);
}

bool SharedChains::is_over(const Chain& chain) const {
  return chain.step >= facts_.design.steps || ended_words_.contains(chain.name.word);
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

std::vector<ChainPlace> SharedChains::open_answers(int session) const {
  std::vector<ChainPlace> open;
  for (const Chain& chain : chains_)
    for (const auto& [person, who] : chain.sessions)
      if (who == session) open.push_back({chain.name, chain.step, person});
  return open;
}

void SharedChains::forget_open(int session) {
  for (Chain& chain : chains_)
    std::erase_if(chain.sessions, [&](const auto& one) {
      if (one.second != session) return false;
      chain.values.erase(one.first);
      return true;
    });
  std::erase_if(leases_, [&](const auto& lease) { return lease.second.session == session; });
}

bool SharedChains::is_finished() const {
  return std::ranges::all_of(chains_, [&](const Chain& chain) { return is_over(chain); });
}

int SharedChains::complete_steps() const {
  int steps = 0;
  for (const Chain& chain : chains_) steps += chain.step;
  return steps;
}

int SharedChains::all_steps() const {
  int steps = 0;
  for (const Chain& chain : chains_) steps += is_over(chain) ? chain.step : facts_.design.steps;
  return steps;
}

}  // namespace mien::pipeline

#include "pipeline/study/chains/experiment/simulated_chains.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <boost/math/distributions/normal.hpp>
#include <fmt/format.h>

#include "pipeline/base/statistics/named_random.h"
#include "pipeline/study/questionnaire/orders.h"
#include "pipeline/study/questionnaire/service/chain_record.h"
#include "pipeline/study/questionnaire/service/shared_chains.h"

namespace mien::pipeline {

namespace {

constexpr double usual_deviation = 0.12;
constexpr double usual_place = 0.8;

/// A value of a normal distribution truncated to a range, at a share of its probability.
double truncated_value(double mean, double deviation, const DimensionRange& range, double share) {
  const boost::math::normal normal(mean, deviation);
  // In the tail where probabilities are small, so that none is rounded to 1.
  const bool is_above = range.low > mean;
  const auto p = [&](double x) { return is_above ? cdf(complement(normal, x)) : cdf(normal, x); };
  const double at = std::lerp(p(range.low), p(range.high), share);
  if (!(at > 0.0 && at < 1.0)) return mean < range.low ? range.low : range.high;
  const double value = is_above ? quantile(complement(normal, at)) : quantile(normal, at);
  return std::clamp(value, range.low, range.high);
}

double log_density(const WordTruth& truth, const std::vector<double>& point) {
  double sum = 0.0;
  for (std::size_t d = 0; d < point.size(); ++d)
    sum -= 0.5 * std::pow((point[d] - truth.mean[d]) / truth.deviation[d], 2);
  return sum;
}

/// Answers the trials of all sessions.
class Simulation {
 public:
  Simulation(const ChainStudy& study, const std::map<std::string, WordTruth>& truth,
             double attention_pass_rate)
      : study_(study),
        design_(study.design),
        truth_(truth),
        attention_pass_rate_(attention_pass_rate) {}

  /// The answer to a step at a point; `who` names its random numbers.
  ChainRecord answered(const PlannedStep& step, int person, const std::vector<double>& point,
                       const std::string& who) const {
    ChainRecord record{.word = step.name.word,
                       .chain = step.name.chain,
                       .step = step.step,
                       .person = person,
                       .point = point};
    const WordTruth& truth = truth_.at(step.name.word);
    const double chance = uniform(design_.seed, "answer of " + who);
    if (design_.method == ChainMethod::gibbs) {
      record.dimension = step.view.dimension;
      record.slider = step.view.slider;
      record.moves = 1;
      const std::size_t d = record.dimension;
      record.value =
          stepped(truncated_value(truth.mean[d], truth.deviation[d], design_.space[d], chance), d);
    } else {
      propose(record, step.view);
      record.chose_proposal =
          chance < luce_probability(log_density(truth, record.proposal), log_density(truth, point));
    }
    return record;
  }

  /// The answer to an attention check of a session.
  ChainRecord checked(const ChainSession& session, std::size_t trial) const {
    const PlannedStep& step = session.steps[trial];
    const std::string& expected = session.plan.trials[trial].expected;
    ChainRecord record{.word = step.name.word,
                       .chain = step.name.chain,
                       .step = step.step,
                       .point = session.starts.at(step.name.key())};
    const bool is_left = expected == word_of(check_side_words, CheckSide::left);
    const bool passes =
        uniform(design_.seed, fmt::format("attention of {} trial {}", session.plan.participant,
                                          trial)) < attention_pass_rate_;
    if (design_.method == ChainMethod::gibbs) {
      record.dimension = step.view.dimension;
      record.slider = step.view.slider;
      record.moves = 1;
      const DimensionRange& range = design_.space[record.dimension];
      const bool is_low = (is_left == passes) != step.view.slider.is_reversed;
      record.value = is_low ? range.low : range.high;
    } else {
      propose(record, step.view);
      record.chose_proposal = (is_left == passes) == record.is_proposal_first;
    }
    return record;
  }

  /// Whether a check ends the session.
  bool ends(const ChainSession& session, std::size_t trial, const ChainRecord& record,
            int& failed) const {
    if (!passes_check(design_, session.plan.trials[trial].expected, record)) ++failed;
    return failed > study_.experiment.at("chains").value("max_failed_checks", 0);
  }

  ChainAnswer answer_of(const ChainSession& session, std::size_t trial, ChainRecord record) const {
    return {.participant = session.plan.participant,
            .design = study_.experiment.at("design"),
            .simulated = true,
            .trial = session.plan.trials[trial].number,
            .is_practice = session.plan.trials[trial].practice,
            .expected = session.plan.trials[trial].expected,
            .answer = std::move(record)};
  }

  /// Trials whose steps are planned: all of them or, in chains across participants, practice.
  std::vector<ChainAnswer> planned_answers(const ChainSession& session, bool is_shared) const {
    std::vector<ChainAnswer> answers;
    std::map<std::string, std::vector<double>> points = session.starts;
    for (std::size_t i = 0; i < session.steps.size(); ++i) {
      const PlannedStep& step = session.steps[i];
      if (step.name.word.empty()) continue;
      if (session.plan.trials[i].is_attention_check()) {
        if (!is_shared) answers.push_back(answer_of(session, i, checked(session, i)));
        continue;
      }
      const bool is_practice = session.plan.trials[i].practice;
      std::vector<double>& point =
          points.at(is_practice ? fmt::format("practice/{}", step.name.chain) : step.name.key());
      ChainRecord record =
          answered(step, 0, point, fmt::format("{} trial {}", session.plan.participant, i));
      if (design_.method == ChainMethod::gibbs)
        point[record.dimension] = record.value;
      else if (record.chose_proposal)
        point = record.proposal;
      answers.push_back(answer_of(session, i, std::move(record)));
    }
    return answers;
  }

 private:
  void propose(ChainRecord& record, const StepView& view) const {
    record.is_proposal_first = view.is_proposal_first;
    for (std::size_t d = 0; d < record.point.size(); ++d) {
      const DimensionRange& range = design_.space[d];
      const double by = design_.deviation * (range.high - range.low) * view.normals[d];
      record.proposal.push_back(reflected(record.point[d] + by, range));
    }
  }

  /// To a thousandth of the range, like the slider of the page.
  double stepped(double value, std::size_t d) const {
    const DimensionRange& range = design_.space[d];
    const double width = range.high - range.low;
    const double share = std::round(1000.0 * (value - range.low) / width) / 1000.0;
    return std::min(range.low + share * width, range.high);
  }

  const ChainStudy& study_;
  const ChainDesign& design_;
  const std::map<std::string, WordTruth>& truth_;
  double attention_pass_rate_;
};

/// Participants take turns, one trial each.
class SharedSimulation {
 public:
  SharedSimulation(const ChainStudy& study, const Simulation& simulation)
      : study_(study),
        simulation_(simulation),
        facts_(chain_facts(study.experiment)),
        chains_(facts_) {}

  std::vector<ChainAnswer> run() {
    std::size_t longest = 0;
    for (const ChainSession& session : study_.sessions)
      longest = std::max(longest, session.steps.size());
    for (std::size_t trial = 0; trial < longest; ++trial)
      for (const ChainSession& session : study_.sessions)
        if (trial < session.steps.size() && !session.plan.trials[trial].practice &&
            !ended_.contains(session.plan.index))
          answer(session, trial);
    return std::move(answers_);
  }

 private:
  void answer(const ChainSession& session, std::size_t trial) {
    if (chains_.is_finished()) return;
    if (session.plan.trials[trial].is_attention_check()) return answer_check(session, trial);
    NoStep reason = NoStep::busy;
    const int index = session.plan.index;
    const auto assigned = chains_.assign(index, fmt::format("trial-{}", trial), 0, reason);
    if (!assigned) return;
    const StepView view =
        step_view(study_.design, assigned->name, assigned->step, assigned->person);
    ChainRecord record = simulation_.answered(
        {assigned->name, assigned->step, view}, assigned->person, assigned->point,
        fmt::format("{} trial {}", session.plan.participant, trial));
    chains_.add(index, record);
    answers_.push_back(simulation_.answer_of(session, trial, std::move(record)));
  }

  /// Who fails too many is not asked again, and answers to open steps do not count.
  void answer_check(const ChainSession& session, std::size_t trial) {
    ChainRecord record = simulation_.checked(session, trial);
    const int index = session.plan.index;
    if (simulation_.ends(session, trial, record, failed_[index])) {
      ended_.insert(index);
      for (const ChainPlace& place : chains_.open_answers(index))
        std::erase_if(answers_, [&](const ChainAnswer& one) {
          return one.expected.empty() && one.answer.word == place.name.word &&
                 one.answer.chain == place.name.chain && one.answer.step == place.step &&
                 one.answer.person == place.person;
        });
      chains_.forget_open(index);
    }
    answers_.push_back(simulation_.answer_of(session, trial, std::move(record)));
  }

  const ChainStudy& study_;
  const Simulation& simulation_;
  ChainFacts facts_;
  SharedChains chains_;
  std::map<int, int> failed_;  ///< number of failed checks by session
  std::set<int> ended_;
  std::vector<ChainAnswer> answers_;
};

}  // namespace

std::map<std::string, WordTruth> usual_truth(const ChainStudy& study) {
  const auto& examples = study.bundle.examples.examples;
  std::map<std::string, WordTruth> truth;
  for (const std::string& word : study.design.words) {
    WordTruth& of = truth[word];
    // Not the start of any chain, which are numbered from 1.
    of.mean = chain_start(study.design, study.dimensions.at_examples, {word, 0, "truth"});
    const auto same = std::ranges::find(examples, word, [](const auto& one) { return one.name; });
    if (same != examples.end() && study.dimensions.at_examples.size() > 0) {
      const auto at = study.dimensions.at_examples.col(same - examples.begin());
      of.mean.assign(at.begin(), at.end());
    }
    const auto recipe = std::ranges::find(study.design.dimensions, word);
    if (study.dimensions.kind == motion::InterfaceKind::modifications &&
        recipe != study.design.dimensions.end()) {
      const auto d = static_cast<std::size_t>(recipe - study.design.dimensions.begin());
      of.mean[d] = std::lerp(study.design.space[d].low, study.design.space[d].high, usual_place);
    }
    for (const DimensionRange& range : study.design.space)
      of.deviation.push_back(usual_deviation * (range.high - range.low));
  }
  return truth;
}

std::vector<ChainAnswer> simulated_chains(const ChainStudy& study, bool across_participants,
                                          const std::map<std::string, WordTruth>& truth,
                                          double attention_pass_rate) {
  const Simulation simulation(study, truth, attention_pass_rate);
  std::vector<ChainAnswer> answers;
  for (const ChainSession& session : study.sessions)
    std::ranges::move(simulation.planned_answers(session, across_participants),
                      std::back_inserter(answers));
  if (across_participants)
    std::ranges::move(SharedSimulation(study, simulation).run(), std::back_inserter(answers));
  return answers;
}

}  // namespace mien::pipeline

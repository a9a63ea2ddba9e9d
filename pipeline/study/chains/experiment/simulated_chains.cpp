#include "pipeline/study/chains/experiment/simulated_chains.h"

#include <algorithm>
#include <cmath>

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
  Simulation(const ChainStudy& study, const std::map<std::string, WordTruth>& truth)
      : study_(study), design_(study.design), truth_(truth) {}

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
      record.is_proposal_first = step.view.is_proposal_first;
      for (std::size_t d = 0; d < point.size(); ++d) {
        const DimensionRange& range = design_.space[d];
        const double by = design_.deviation * (range.high - range.low) * step.view.normals[d];
        record.proposal.push_back(reflected(point[d] + by, range));
      }
      record.chose_proposal =
          chance < luce_probability(log_density(truth, record.proposal), log_density(truth, point));
    }
    return record;
  }

  ChainAnswer answer_of(const ChainSession& session, std::size_t trial, ChainRecord record) const {
    return {.participant = session.plan.participant,
            .design = study_.experiment.at("design"),
            .simulated = true,
            .trial = session.plan.trials[trial].number,
            .is_practice = session.plan.trials[trial].practice,
            .answer = std::move(record)};
  }

  /// Trials whose steps are planned: all of them, or practice.
  std::vector<ChainAnswer> planned_answers(const ChainSession& session) const {
    std::vector<ChainAnswer> answers;
    std::map<std::string, std::vector<double>> points = session.starts;
    for (std::size_t i = 0; i < session.steps.size(); ++i) {
      const PlannedStep& step = session.steps[i];
      if (step.name.word.empty()) continue;
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
};

/// Participants take turns, one trial each.
std::vector<ChainAnswer> shared_answers(const ChainStudy& study, const Simulation& simulation) {
  const ChainFacts facts = chain_facts(study.experiment);
  SharedChains chains(facts);
  std::vector<ChainAnswer> answers;
  std::size_t longest = 0;
  for (const ChainSession& session : study.sessions)
    longest = std::max(longest, session.steps.size());
  for (std::size_t trial = 0; trial < longest; ++trial)
    for (const ChainSession& session : study.sessions) {
      if (trial >= session.steps.size() || session.plan.trials[trial].practice) continue;
      NoStep reason = NoStep::busy;
      const int index = session.plan.index;
      const auto assigned = chains.assign(index, fmt::format("trial-{}", trial), 0, reason);
      if (!assigned) continue;
      const StepView view =
          step_view(study.design, assigned->name, assigned->step, assigned->person);
      ChainRecord record = simulation.answered(
          {assigned->name, assigned->step, view}, assigned->person, assigned->point,
          fmt::format("{} trial {}", session.plan.participant, trial));
      chains.add(index, record);
      answers.push_back(simulation.answer_of(session, trial, std::move(record)));
    }
  return answers;
}

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
                                          const std::map<std::string, WordTruth>& truth) {
  const Simulation simulation(study, truth);
  std::vector<ChainAnswer> answers;
  for (const ChainSession& session : study.sessions)
    std::ranges::move(simulation.planned_answers(session), std::back_inserter(answers));
  if (across_participants)
    std::ranges::move(shared_answers(study, simulation), std::back_inserter(answers));
  return answers;
}

}  // namespace mien::pipeline

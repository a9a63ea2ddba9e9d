#include "pipeline/study/chains/chain_plan.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "pipeline/base/statistics/named_random.h"
#include "pipeline/manifest/adaptive_plan.h"
#include "pipeline/manifest/questionnaire_content.h"
#include "pipeline/study/questionnaire/orders.h"
#include "pipeline/study/questionnaire/session_duration.h"

namespace mien::pipeline {

namespace {

constexpr char practice_block[] = "practice";
constexpr double least_weight = 0.01;
constexpr std::size_t blended_examples = 3;
constexpr double trial_seconds = 12.0;
constexpr double question_seconds = 8.0;
constexpr double words_per_second = 200.0 / 60.0;

double rounded(double value) { return std::round(1000.0 * value) / 1000.0; }

std::uint64_t chain_seed(const ChainDesign& design, const std::string& word,
                         const std::string& participant) {
  return hashed_seed(design.seed, fmt::format("chains of {} for \"{}\"", word, participant));
}

std::vector<double> blended_start(const Eigen::MatrixXd& at_examples, std::uint64_t seed,
                                  int chain) {
  const auto count = static_cast<std::size_t>(at_examples.cols());
  const std::vector<std::size_t> order =
      random_order(count, seed, fmt::format("start of chain {}", chain));
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(at_examples.cols());
  // Exponential variables divided by their sum are uniform among weights with a sum of 1.
  for (std::size_t i = 0; i < std::min(blended_examples, count); ++i)
    weights[static_cast<Eigen::Index>(order[i])] =
        -std::log1p(-uniform(seed, fmt::format("start of chain {} weight {}", chain, i)));
  const Eigen::VectorXd point = at_examples * (weights / weights.sum());
  return {point.begin(), point.end()};
}

/// Expected duration of a session, seconds: reading texts, questions, and 12 s a trial.
double chain_session_seconds(const Manifest& manifest, const SessionPlan& plan) {
  const Adaptive& adaptive = adaptive_of(manifest);
  double seconds = question_seconds * static_cast<double>(adaptive.demographics.size());
  for (const TextSource* text : {&adaptive.consent, &adaptive.instructions, &adaptive.ending})
    seconds += word_count(text->text) / words_per_second;
  return seconds + trial_seconds * static_cast<double>(plan.trials.size());
}

/// Plans the session of one participant.
class SessionPlanner {
 public:
  SessionPlanner(const Manifest& manifest, const ChainDesign& design,
                 const Eigen::MatrixXd& at_examples, int index)
      : manifest_(manifest), design_(design), at_examples_(at_examples) {
    session_.plan = {.index = index, .participant = participant_name(index)};
    // So that a number of JavaScript represents it exactly.
    session_.plan.seed = hashed_seed(manifest.seed, session_.plan.participant) >> 11U;
  }

  ChainSession session() {
    add_practice();
    if (adaptive().across_participants)
      add_open_trials();
    else
      add_own_chains();
    session_.plan.expected_seconds = chain_session_seconds(manifest_, session_.plan);
    return std::move(session_);
  }

 private:
  const Adaptive& adaptive() const { return *manifest_.adaptive; }
  const std::string& participant() const { return session_.plan.participant; }

  /// Adds a trial that counts, and an attention check where one follows it.
  void add_main(const std::string& block, PlannedStep step) {
    add_trial(block, std::move(step));
    if (std::ranges::find(check_places_, main_trials_++) != check_places_.end()) add_check(block);
  }

  void place_checks(std::size_t trials) {
    check_places_ = places_of_checks(trials, static_cast<std::size_t>(adaptive().attention_every),
                                     session_.plan.seed, "attention");
  }

  void add_check(const std::string& block) {
    const ChainName name{check_word, 1, participant()};
    if (checks_ == 0) session_.starts[name.key()] = chain_start(design_, at_examples_, name);
    add_trial(block, {name, checks_, step_view(design_, name, checks_, 0)});
    Trial& trial = session_.plan.trials.back();
    trial.is_check = true;
    const std::size_t side =
        random_choice(2, session_.plan.seed, "side of check", static_cast<std::uint64_t>(checks_));
    trial.expected = word_of(check_side_words, side == 0 ? CheckSide::left : CheckSide::right);
    ++checks_;
  }

  void add_trial(const std::string& block, PlannedStep step) {
    session_.plan.trials.push_back({.number = static_cast<int>(session_.plan.trials.size()) + 1,
                                    .block = block,
                                    .kind = &chain_trials,
                                    .items = {{step.name.word, false}},
                                    .practice = block == practice_block});
    session_.steps.push_back(std::move(step));
  }

  void add_practice() {
    if (adaptive().practice == 0) return;
    const ChainName name{practice_block, 1, participant()};
    session_.starts[name.key()] = chain_start(design_, at_examples_, name);
    for (int step = 0; step < adaptive().practice; ++step) {
      PlannedStep planned{name, step, step_view(design_, name, step, 0)};
      planned.name.word = design_.words[static_cast<std::size_t>(step) % design_.words.size()];
      add_trial(practice_block, std::move(planned));
    }
  }

  /// The server chooses the steps.
  void add_open_trials() {
    place_checks(static_cast<std::size_t>(adaptive().trials_per_participant));
    for (int i = 0; i < adaptive().trials_per_participant; ++i) add_main("main", {});
  }

  void add_own_chains() {
    const auto index = static_cast<std::size_t>(session_.plan.index);
    place_checks(design_.words.size() * static_cast<std::size_t>(design_.chains) *
                 static_cast<std::size_t>(design_.steps));
    for (const std::size_t at : williams_row(design_.words.size(), index))
      add_block(design_.words[at]);
  }

  void add_block(const std::string& word) {
    for (int chain = 1; chain <= design_.chains; ++chain) {
      const ChainName name{word, chain, participant()};
      session_.starts[name.key()] = chain_start(design_, at_examples_, name);
    }
    const std::uint64_t seed = chain_seed(design_, word, participant());
    for (int step = 0; step < design_.steps; ++step)
      for (const std::size_t at : random_order(static_cast<std::size_t>(design_.chains), seed,
                                               fmt::format("chains of step {}", step))) {
        const ChainName name{word, static_cast<int>(at) + 1, participant()};
        add_main(word, {name, step, step_view(design_, name, step, 0)});
      }
  }

  const Manifest& manifest_;
  const ChainDesign& design_;
  const Eigen::MatrixXd& at_examples_;
  ChainSession session_;
  std::vector<std::size_t> check_places_;  ///< of the trials that checks follow
  std::size_t main_trials_ = 0;
  int checks_ = 0;
};

}  // namespace

std::string ChainName::key() const { return fmt::format("{}/{}", word, chain); }

GibbsSettings ChainDesign::gibbs(const std::string& word, const std::string& participant) const {
  return {.dimensions = dimensions.size(),
          .people_per_step = people_per_step,
          .aggregate = aggregate,
          .seed = chain_seed(*this, word, participant)};
}

ChoiceSettings ChainDesign::choices(const std::string& word, const std::string& participant) const {
  return {.space = space, .deviation = deviation, .seed = chain_seed(*this, word, participant)};
}

std::size_t ChainDesign::steps_per_sweep() const {
  return method == ChainMethod::gibbs ? dimensions.size() : 1;
}

ChainDesign chain_design(const Manifest& manifest, const Eigen::MatrixXd& at_examples) {
  const Adaptive& adaptive = adaptive_of(manifest);
  ChainDesign design{.method = adaptive.method,
                     .dimensions = dimension_names(manifest),
                     .chains = adaptive.chains,
                     .steps = static_cast<int>(chain_steps(manifest)),
                     .people_per_step = adaptive.people_per_step,
                     .aggregate = adaptive.aggregate == StepAggregate::mean
                                      ? SliderAggregate::mean
                                      : SliderAggregate::median,
                     .deviation = adaptive.deviation,
                     .seed = manifest.seed,
                     .has_relative_values = adaptive.space.kind == MotionSpace::Kind::weights,
                     .until = adaptive.until};
  for (const auto& [id, shown] : adaptive.words) design.words.push_back(id);
  if (adaptive.space.kind == MotionSpace::Kind::recipe) {
    for (const auto& [name, limits] : dimensions_of(adaptive.space.recipe))
      design.space.push_back({limits[0], limits[1]});
    return design;
  }
  for (std::size_t i = 0; i < design.dimensions.size(); ++i) {
    if (at_examples.size() == 0) {
      design.space.push_back({least_weight, 1.0});
      continue;
    }
    const auto row = at_examples.row(static_cast<Eigen::Index>(i));
    const DimensionRange range{rounded(row.minCoeff()), rounded(row.maxCoeff())};
    if (!(range.low < range.high))
      throw Error({manifest.file.string()},
                  fmt::format("all examples have the same value of {}", design.dimensions[i]),
                  "remove this dimension from adaptive.space");
    design.space.push_back(range);
  }
  return design;
}

std::vector<double> chain_start(const ChainDesign& design, const Eigen::MatrixXd& at_examples,
                                const ChainName& name) {
  const std::uint64_t seed = chain_seed(design, name.word, name.participant);
  std::vector<double> point = at_examples.size() == 0
                                  ? random_start(design.space, seed, name.chain)
                                  : blended_start(at_examples, seed, name.chain);
  for (std::size_t i = 0; i < point.size(); ++i)
    point[i] = std::clamp(rounded(point[i]), design.space[i].low, design.space[i].high);
  return point;
}

StepView step_view(const ChainDesign& design, const ChainName& name, int step, int person) {
  if (design.method == ChainMethod::mcmc) {
    const ChoiceSettings settings = design.choices(name.word, name.participant);
    return {.normals = proposal_deviates(settings, name.chain, step),
            .is_proposal_first = shows_proposal_first(settings, name.chain, step)};
  }
  const GibbsSettings settings = design.gibbs(name.word, name.participant);
  GibbsSlider slider = gibbs_slider(settings, name.chain, step, person);
  slider.start = rounded(slider.start);
  return {.dimension = gibbs_dimension(settings, name.chain, step), .slider = slider};
}

std::vector<ChainSession> plan_chains(const Manifest& manifest, const ChainDesign& design,
                                      const Eigen::MatrixXd& at_examples, int count) {
  const int participants = count != 0 ? count : adaptive_of(manifest).participants;
  std::vector<ChainSession> sessions;
  for (int index = 0; index < participants; ++index)
    sessions.push_back(SessionPlanner(manifest, design, at_examples, index).session());
  return sessions;
}

}  // namespace mien::pipeline

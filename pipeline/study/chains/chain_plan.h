#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "pipeline/base/adaptive/choice_chain.h"
#include "pipeline/base/adaptive/gibbs_chain.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/study/questionnaire/session_plan.h"

namespace mien::pipeline {

/// A chain of a word, numbered from 1. Chains of one participant are named after the participant as
/// well: those of different participants are different chains.
struct ChainName {
  std::string word;
  int chain = 1;
  std::string participant;  ///< empty if the chain goes across participants

  /// "sad/1", the key of its start in experiment.json.
  std::string key() const;
  friend auto operator<=>(const ChainName&, const ChainName&) = default;
};

/// What all chains of a study have in common.
struct ChainDesign {
  ChainMethod method = ChainMethod::gibbs;
  std::vector<std::string> dimensions;  ///< names
  ChainSpace space;                     ///< one range for each dimension
  std::vector<std::string> words;       ///< ids
  int chains = 1;                       ///< of each word
  int steps = 1;                        ///< of a complete chain
  int people_per_step = 1;
  SliderAggregate aggregate = SliderAggregate::median;
  double deviation = 0.15;
  std::uint64_t seed = 0;            ///< of the study
  bool has_relative_values = false;  ///< weights of examples: only their ratios count
  std::optional<ChainEnd> until;     ///< when chains end before their last step

  std::size_t steps_per_sweep() const;
  /// Settings of the chains of a word; `participant` as in ChainName.
  GibbsSettings gibbs(const std::string& word, const std::string& participant) const;
  ChoiceSettings choices(const std::string& word, const std::string& participant) const;
};

/// The design of a manifest's experiment. `at_examples` has the values of the dimensions at the
/// examples: one row per dimension, one column per example; the ranges are those of the examples.
/// For weights it is empty, and the range of each is 0.01 to 1: weights are relative, and not all
/// of them may be 0. For modifications it is empty, too, and the ranges are those of the manifest.
ChainDesign chain_design(const Manifest& manifest, const Eigen::MatrixXd& at_examples);

/// The point at which a chain starts, rounded to 0.001: a blend of three random examples with
/// weights that are uniformly distributed among those with a sum of 1, so that it is within what
/// the examples reach; for weights of examples and modifications, a uniformly distributed point of
/// the ranges.
std::vector<double> chain_start(const ChainDesign& design, const Eigen::MatrixXd& at_examples,
                                const ChainName& name);

/// What a step shows, apart from the point. Of Gibbs sampling the first two members count,
/// otherwise the others.
struct StepView {
  std::size_t dimension = 0;
  GibbsSlider slider;
  std::vector<double> normals;  ///< standard normal deviates, one for each dimension
  bool is_proposal_first = false;
};

/// The view of a step, from 0, for the person, from 0, of its people. Depends only on the design
/// and these.
StepView step_view(const ChainDesign& design, const ChainName& name, int step, int person);

/// The word, in tables and records, of attention checks.
inline constexpr char check_word[] = "check";

/// What an attention check asks for: the slider at an end, or the figure at a side.
enum class CheckSide { left, right };

inline constexpr Words<CheckSide> check_side_words = {{"left", CheckSide::left},
                                                      {"right", CheckSide::right}};

/// A trial of a session. Across participants, trials that count have an empty word: a server
/// assigns their step.
/// The attention checks of a session are steps of a chain of their own, check_word/1, all at its
/// start.
struct PlannedStep {
  ChainName name;
  int step = 0;
  StepView view;
};

/// A session with its steps, one for each trial of the plan.
struct ChainSession {
  SessionPlan plan;
  std::vector<PlannedStep> steps;
  std::map<std::string, std::vector<double>> starts;  ///< by ChainName::key
};

/// The sessions of `count` participants, or of all planned ones if `count` is 0. A trial has the
/// word as its item. Practice comes first and has a chain of its own, "practice/1". Unless chains
/// go across participants, one block per word follows, in the order of a row of Williams' square,
/// in which the chains of the word take turns in an order that is random in each round. Each plan
/// is a pure function of (manifest, index).
std::vector<ChainSession> plan_chains(const Manifest& manifest, const ChainDesign& design,
                                      const Eigen::MatrixXd& at_examples, int count = 0);

}  // namespace mien::pipeline

#pragma once

#include <cstdint>
#include <vector>

#include "pipeline/base/adaptive/chain_space.h"

namespace mien::pipeline {

/// Markov chain Monte Carlo with people (Sanborn and Griffiths 2008): in each step a person chooses
/// between the chain's point and a proposal near it. If choices follow Luce's rule, p(proposal)/
/// (p(proposal) + p(current)), which is Barker's acceptance function, the points are samples of p.
struct ChoiceSettings {
  ChainSpace space;
  /// Standard deviation of the proposals in each dimension, as a share of its range. Proposals are
  /// normal and reflected at the bounds, so that those from x to y are as probable as from y to x.
  double deviation = 0.15;
  std::uint64_t seed = 0;
};

/// What a step shows.
struct ChoiceTrial {
  std::vector<double> current;
  std::vector<double> proposal;
  bool is_proposal_first = false;  ///< or on the left; as often as not
};

/// The standard normal deviates of a step's proposal, one for each dimension, and whether the
/// proposal is first. They depend only on settings, chain and step.
std::vector<double> proposal_deviates(const ChoiceSettings& settings, int chain, int step);
bool shows_proposal_first(const ChoiceSettings& settings, int chain, int step);

/// The trial of a step, from 0, of a chain at a point; depends only on these and the settings.
ChoiceTrial choice_trial(const ChoiceSettings& settings, int chain, int step,
                         std::vector<double> current);

/// A value of the real line folded into a range by reflection at both ends, as often as needed.
double reflected(double value, const DimensionRange& range);

/// A chain after some answers. It follows from settings, chain, start and answers alone.
struct ChoiceChain {
  std::vector<std::vector<double>> path;  ///< the point after each step
  ChoiceTrial next;
};

/// Replays the choices, true if the first of the two was chosen.
ChoiceChain choice_chain(const ChoiceSettings& settings, int chain,
                         const std::vector<double>& start, const std::vector<bool>& chose_first);

/// Luce's rule: the probability of choosing a of a and b if they are chosen in proportion to the
/// exponentials of these utilities.
double luce_probability(double utility_a, double utility_b);

}  // namespace mien::pipeline

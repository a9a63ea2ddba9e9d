#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace mien::pipeline {

/// How the answers to one step become the next value.
enum class SliderAggregate { median, mean };

/// Gibbs sampling with people (Harrison, Marjieh and others 2020): each step frees one dimension of
/// a chain's point, and people move a slider to what looks most like a word. If their choices are
/// samples of the distribution of that dimension given the others, the points after the sweeps are
/// samples of the distribution over the whole space. With several people per step the aggregate of
/// their answers moves the chain towards the maximum of the distribution instead.
struct GibbsSettings {
  std::size_t dimensions = 1;
  int people_per_step = 1;
  SliderAggregate aggregate = SliderAggregate::median;
  std::uint64_t seed = 0;
};

/// The dimension, from 0, that a step, from 0, of a chain frees. A sweep is as many steps as there
/// are dimensions, and frees each once, in an order that depends only on seed, chain and sweep.
std::size_t gibbs_dimension(const GibbsSettings& settings, int chain, int step);

/// How the slider of a person, from 0, within a step is shown; depends only on the numbers given.
struct GibbsSlider {
  double start = 0.5;        ///< uniform in (0, 1): 0 is the lowest value that the slider offers
  bool is_reversed = false;  ///< the highest value is where the lowest is otherwise
};

GibbsSlider gibbs_slider(const GibbsSettings& settings, int chain, int step, int person);

/// The next value from the answers to one step, of which there is at least one. The median of an
/// even number is the mean of the middle two.
double aggregated(std::vector<double> answers, SliderAggregate aggregate);

/// A chain after some answers. It follows from settings, chain, start and answers alone.
struct GibbsChain {
  std::vector<std::vector<double>> path;  ///< the point after each complete step
  std::vector<double> point;              ///< the present point
  int person = 0;                         ///< number of answers to the present step
};

/// Replays the values that were chosen, in the order of steps and people.
GibbsChain gibbs_chain(const GibbsSettings& settings, int chain, std::vector<double> start,
                       const std::vector<double>& answers);

}  // namespace mien::pipeline

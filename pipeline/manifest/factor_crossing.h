#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace mien::pipeline {

/// Stimuli by their levels of some factors.
struct FactorTable {
  std::vector<std::string> factors;
  /// For each stimulus the level of each factor; empty if it has none. A stimulus that is not
  /// rated has no levels at all.
  std::vector<std::vector<std::string>> rows;

  /// The levels of a factor, in the order in which they first occur.
  std::vector<std::string> levels_of(std::size_t factor) const;
};

/// A part of a design in which every level of each factor occurs with every level of the others.
struct Crossing {
  /// Indices of FactorTable::factors that have at least two levels here, ascending.
  std::vector<std::size_t> factors;
  std::vector<std::vector<std::string>> levels;         ///< of each of these factors
  std::vector<std::pair<std::size_t, std::string>> at;  ///< the other factors, with their level
  std::vector<std::vector<std::size_t>> cells;  ///< stimuli; the last factor's levels vary fastest

  bool empty() const { return factors.empty(); }
  /// Number of stimuli in all cells.
  std::size_t stimuli() const;
};

/// The largest crossing: with the most factors, then the most cells; of several, always the same.
/// Factors that cannot be crossed with the others keep the level at which the others are crossed.
/// Empty if no factor has two levels, or if the design is incomplete and has too many levels to be
/// searched (searchable()).
Crossing largest_crossing(const FactorTable& table);

/// Whether largest_crossing can search an incomplete design: its factors, without the one with the
/// most levels, have at most 16 levels together.
bool is_searchable(const FactorTable& table);

/// Levels of a factor with their weights in a contrast.
using LevelWeights = std::vector<std::pair<std::string, double>>;

/// The cells that a contrast compares: for each setting, which is a combination of levels of the
/// factors that the contrast does not weight, the stimuli with their weights.
struct MatchedSetting {
  std::vector<std::pair<std::size_t, std::string>> levels;         ///< of the unweighted factors
  std::vector<std::pair<double, std::vector<std::size_t>>> cells;  ///< weight, stimuli
};

/// The settings in which all weighted combinations of levels occur; others are not comparable. A
/// cell's weight is the product of the weights of its levels, and weights of 0 are left out. `at`
/// restricts settings to those with these levels. Factors are names of `table`; others are ignored.
std::vector<MatchedSetting> matched_settings(
    const FactorTable& table, const std::vector<std::pair<std::string, LevelWeights>>& weights,
    const std::vector<std::pair<std::string, std::string>>& at = {});

}  // namespace mien::pipeline

#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "pipeline/base/documents/fault.h"
#include "pipeline/base/reading/yaml_json.h"

namespace mien::pipeline {

/// The greatest number of levels of one stimulus, and of stimuli with all of their levels (also
/// stated by the schema).
inline constexpr std::size_t most_levels = 100;
inline constexpr std::size_t most_stimuli = 10000;

/// A manifest's document in which each stimulus with `levels:` is replaced by those of its levels.
struct LevelledDocument {
  JsonReading reading;
  std::vector<Fault> faults;  ///< levels that cannot be made; their stimuli are as before
  /// For each stimulus of the document, the index of the one that it was made from. Empty if no
  /// stimulus has levels.
  std::vector<std::size_t> origins;
};

/// Replaces each stimulus with `levels:` by the stimuli of its levels, in the order of the values.
/// Each is as the stimulus is written, with the value at `of` and as its level of `factor`, and
/// with the value appended to its id: woman and 0.3 make woman-0.3. If `of` is a weight, those of
/// the other examples are multiplied so that the sum of all is 1. The places of all values are
/// those of the values that they were made from. What the schema refuses is left as it is.
LevelledDocument with_all_levels(JsonReading reading);

/// Faults of the new document as those of the old one: with the paths of its stimuli, and of each
/// value at each place the first.
std::vector<Fault> with_written_paths(std::vector<Fault> faults,
                                      const std::vector<std::size_t>& origins);

/// The values of `values:`: a list, or from `from` to `to` in `steps` values with equal differences
/// or, with `spacing: log`, equal ratios. They are exact decimals: values between the ends are
/// rounded to four digits of the difference from the one before and, with `whole: true`, to whole
/// numbers. Throws Error if the ends are equal or, with `spacing: log`, not both above 0, or if two
/// values are equal. `values` must be as the schema demands.
std::vector<double> level_values(const nlohmann::json& values);

}  // namespace mien::pipeline

#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "pipeline/base/documents/concerns.h"

namespace mien::pipeline {

struct Manifest;

/// The level of a stimulus that was made from a stimulus with `levels:`, which stands for one
/// stimulus for each value of a number (reading/levelled_document.h).
struct StimulusLevel {
  std::string factor;  ///< of the design; empty: the stimulus was not made from another
  std::string option;  ///< the number that varies, by its path in the stimulus: "modify.strength"
  std::string text;    ///< its value: "0.3"
};

/// `levels: {factor: sadness, of: modify.strength, values: {from: 0, to: 1, steps: 11}}`, as
/// with_all_levels leaves it. A manifest is written with the stimuli of all levels.
struct StimulusLevelForm {
  static void read(const DocumentValue& given, StimulusLevel& level);
  static nlohmann::ordered_json write(const StimulusLevel& level, const WritingOptions& how);
  static void walk(auto& names) {
    for (const char* name : {"factor", "of", "values", "values.from", "values.to", "values.steps",
                             "values.spacing", "values.whole"})
      names.add(name);
  }
};

/// The levels that were made, a text for each stimulus with `levels:`: "woman: 10 levels of sadness
/// (modify.strength): 0.05, 0.1, …, 1".
std::vector<std::string> levels_made(const Manifest& manifest);

}  // namespace mien::pipeline

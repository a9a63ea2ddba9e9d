#pragma once

#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "pipeline/base/documents/concerns.h"

namespace mien::pipeline {

struct Manifest;
struct Stimulus;

/// Factor of the design → its level, in the order of the manifest: {actor: k, emotion: sad}.
using Factors = std::vector<std::pair<std::string, std::string>>;

/// `factors:` whose levels may be texts, numbers and truth values.
struct FactorsForm {
  static void read(const DocumentValue& given, Factors& factors);
  static nlohmann::ordered_json write(const Factors& factors, const WritingOptions&);
};

/// The levels of a stimulus: those that it states and, of these four, what it does not state but is
/// plain from how it is made: `emotion` and `strength` of the recipes that modify it (several are
/// joined by "+"), `example` when one alone has weight, `clip`, the name of its file.
Factors levels_of(const Stimulus& stimulus);

/// All factors of a study: first those that are stated, as they come up, then the others.
std::vector<std::string> factors_of(const Manifest& manifest);

/// The level of one factor; empty where the stimulus has none.
std::string level_of(const Stimulus& stimulus, const std::string& factor);

}  // namespace mien::pipeline

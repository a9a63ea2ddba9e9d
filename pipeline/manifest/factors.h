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

/// A level as text: that of a number is its shortest notation.
std::string level_text(const nlohmann::json& level);

/// `factors:`, whose levels may be texts, numbers or booleans.
struct FactorsForm {
  static void read(const DocumentValue& given, Factors& factors);
  static nlohmann::ordered_json write(const Factors& factors, const WritingOptions&);
};

/// Returns the levels of a stimulus: the stated ones, followed by those that are not stated but
/// follow from how it is made: `emotion` and `strength` of the recipes that modify it (several are
/// joined by "+"), `example` if a single example has weight, `clip`, the stem of its file's name,
/// and `audio`: matched or mismatched (sound_level).
Factors levels_of(const Stimulus& stimulus);

/// Returns all factors of a study: first the stated ones in order of first appearance, then the
/// derived ones.
std::vector<std::string> factors_of(const Manifest& manifest);

/// Whether any stimulus states the factor.
bool is_stated(const Manifest& manifest, const std::string& factor);

/// Returns the factors that a design is checked and analysed by: those that any stimulus states,
/// and `emotion` and `audio`. Other derived factors describe single motions.
std::vector<std::string> studied_factors(const Manifest& manifest);

/// Returns the level of one factor; empty if the stimulus has none.
std::string level_of(const Stimulus& stimulus, const std::string& factor);

}  // namespace mien::pipeline

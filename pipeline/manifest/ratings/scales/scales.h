#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "pipeline/manifest/ratings/words/lexicon.h"

namespace mien::pipeline {

/// A rating scale with two ends, as a study names it.
struct Scale {
  std::string id;    ///< id in manifests and answers: "sad-happy", "extraversion"
  std::string low;   ///< English name of the low end
  std::string high;  ///< English name of the high end
  std::string japanese_low;
  std::string japanese_high;
  double least = -2.0;  ///< the answer that means `low`
  double most = 2.0;    ///< the answer that means `high`

  /// For simulated raters only: the weight of each style impression (simulated_raters.h).
  std::vector<std::pair<std::string, double>> loadings = {};

  /// Names of the ends, low and high, in further languages, by tag (BCP 47).
  std::vector<std::pair<std::string, std::array<std::string, 2>>> words = {};
};

/// A group of scales whose mean is a parameter.
struct ScaleGroup {
  std::string id;  ///< "quickness"
  std::string japanese;
  std::vector<std::string> scales;  ///< ids
};

/// The scales of a study.
struct ScaleSet {
  std::string name;
  std::vector<Scale> scales;
  std::vector<ScaleGroup> groups;  ///< primary parameters; may be empty
  Lexicon lexicon = {};            ///< for answers in words; may be empty
};

/// Returns the 41 adjective pairs and the four primary groups (Table 2) of the adjective paper,
/// with answers on −2 … 2.
ScaleSet builtin_scales();

/// Reads a scales file. Throws Faults that list its faults, and Error if it cannot be read.
/// Example:
///
///     name: five factors
///     range: [-3, 3]              # of every scale that does not give its own
///     scales:
///       extraversion: {low: introverted, high: extraverted, ja: [内向的な, 外向的な]}
///       calmness: {low: nervous, high: calm, de: [nervös, ruhig], in: {sv: [nervös, lugn]}}
///     groups:                     # optional
///       energy: {scales: [extraversion], ja: 活力}
///     languages:                  # optional: for answers in words
///       english: {called: [en], strengthened: [very], softened: [a little], negated: [not]}
///     words:
///       extraversion: {low: {english: [shy]}, high: {english: [outgoing]}}
ScaleSet read_scales(const std::filesystem::path& file);
ScaleSet parse_scales(std::string_view yaml, const std::string& file);

/// Returns the scale with that id, or nullptr.
const Scale* find_scale(const ScaleSet& set, std::string_view id);

/// Returns the names of a scale's ends, low and high, in a language; nullopt if it has none.
std::optional<std::array<std::string, 2>> ends_in(const Scale& scale, std::string_view language);

/// Returns all scales by id, for repeated look-ups. The pointers refer to `set`.
std::unordered_map<std::string_view, const Scale*> scales_by_id(const ScaleSet& set);

/// Returns an answer as a share of the scale's range: 0 at the low end, 1 at the high end.
double share_of(const Scale& scale, double answer);

/// Returns the six adjective pairs of the emotion thesis, with answers on −2 … 2: sad-happy,
/// tired-excited, angry-relaxed, weak-strong, afraid-confident, masculine-feminine. The Japanese
/// names are our own.
ScaleSet emotion_scales();

}  // namespace mien::pipeline

#pragma once

#include <string>
#include <vector>

#include "pipeline/base/documents/table.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/production/design/design_warning.h"
#include "pipeline/production/design/property_values.h"

namespace mien::pipeline {

/// How a property is related to a factor of the design.
enum class PropertyRelation {
  same,      ///< all stimuli have the same value (numbers: within 1 %)
  varies,    ///< values differ within a level
  follows,   ///< the value is constant within levels and differs between them: a confound
  intended,  ///< it follows the factor, but `design.varies` states that it may, or the factor has
             ///< the property's name
};

/// The values of a property among the stimuli with one level of a factor.
struct LevelProperty {
  std::string level;
  int stimuli = 0;
  std::string text;  ///< the values of texts, each once, joined by "; "
  double lowest = 0.0;
  double highest = 0.0;
  double mean = 0.0;
};

/// A property among the levels of a factor.
struct FactorProperty {
  std::string factor;
  const StimulusProperty* property = nullptr;
  PropertyRelation relation = PropertyRelation::same;
  /// Share of the variance of a number that the levels explain (η²); NaN for texts, and for numbers
  /// that do not differ.
  double explained = 0.0;
  std::vector<LevelProperty> levels;
};

/// Returns the relation of every property to every factor (studied_factors) with two levels or
/// more, except properties that are unknown for a stimulus. A number follows a factor only if a
/// level has several stimuli, because a single motion always differs from others in speed and
/// duration.
std::vector<FactorProperty> factor_properties(const Manifest& manifest,
                                              const std::vector<PropertyValues>& values);

/// Returns a warning for each property that follows a factor, and for each pair of factors that
/// cannot be told apart, because each level of one occurs with one level of the other only.
std::vector<DesignWarning> confound_warnings(const Manifest& manifest,
                                             const std::vector<FactorProperty>& relations);

extern const TableForm confounds_form;
std::string confounds_csv(const std::vector<FactorProperty>& relations);

}  // namespace mien::pipeline

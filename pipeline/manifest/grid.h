#pragma once

#include <string>
#include <vector>

#include "pipeline/base/documents/concerns.h"
#include "pipeline/manifest/questionnaire_forms.h"

namespace mien::pipeline {

/// The sets of stimuli of grid trials (multiple stimuli with hidden reference and anchor, MUSHRA:
/// ITU-R BS.1534-3).
struct GridSettings {
  /// Stimuli with equal levels of all of these factors are a set, shown in one trial.
  std::vector<std::string> alike;
  std::vector<std::vector<std::string>> sets;  ///< or the stimuli of each set, by id
  /// The reference of each set, shown openly and, in a place of its own, among the others; empty:
  /// there is none.
  StimulusChoice reference;
  StimulusChoice anchor;  ///< the anchor of each set, shown among the others; empty: there is none
};

/// Numbers of stimuli of a set, with the hidden reference and the anchor (BS.1534-3: at most 12).
inline constexpr std::size_t least_grid_stimuli = 2;
inline constexpr std::size_t most_grid_stimuli = 12;

void fields_of(auto&& field, MaybeConst<GridSettings> auto& grid) {
  field("alike", grid.alike, concerns::nothing);
  field("sets", grid.sets, concerns::nothing);
  field.by("reference", grid.reference, concerns::nothing, StimulusChoiceForm());
  field.by("anchor", grid.anchor, concerns::nothing, StimulusChoiceForm());
}

}  // namespace mien::pipeline

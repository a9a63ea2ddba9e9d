#pragma once

#include "pipeline/manifest/look/look.h"
#include "pipeline/manifest/stimulus.h"
#include "scenes/figures/figure.h"

namespace mien::pipeline {

/// Returns the figure of one of several people, with its face.
scenes::Figure figure_of(const Person& person, const Look& look);

/// Whether browsers can show people with this figure in 3-D (`view: turn`): stick figures,
/// mannequins and characters.
bool can_be_turned(const scenes::Figure& figure);

}  // namespace mien::pipeline

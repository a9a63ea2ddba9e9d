#pragma once

#include <string>
#include <vector>

#include "pipeline/documents/fault.h"
#include "pipeline/documents/places.h"
#include "pipeline/look/look.h"

namespace mien::pipeline {

/// Reads the set that a look names, and finds what is wrong with the look that the schema cannot
/// tell; `path` is the look's. `joints` are those that point lights and traces may name; none: not
/// known before the motion is read.
std::vector<Fault> complete_look(Look& look, const std::string& path, const Places& places,
                                 const std::vector<std::string>& joints);

}  // namespace mien::pipeline

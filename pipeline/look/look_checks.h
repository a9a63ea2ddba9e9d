#pragma once

#include <string>
#include <vector>

#include "pipeline/documents/fault.h"
#include "pipeline/documents/places.h"
#include "pipeline/look/look.h"
#include "scenes/sets/set_plan.h"

namespace mien::pipeline {

/// The set that a look names. Throws Faults that list what is wrong with its file.
scenes::SetPlan set_of(const Look& look);

/// What is wrong with a look that the schema cannot tell; `path` is the look's. `joints` are those
/// that point lights and traces may name; none: not known before the motion is read.
std::vector<Fault> check_look(const Look& look, const std::string& path, const Places& places,
                              const std::vector<std::string>& joints);

}  // namespace mien::pipeline

#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "pipeline/base/documents/fault.h"
#include "pipeline/base/documents/places.h"
#include "pipeline/manifest/look/look.h"

namespace mien::pipeline {

/// What the looks of one document named and was found good, so that each file is read once.
struct LookFiles {
  std::map<std::pair<std::string, std::filesystem::path>, scenes::SetPlan> sets;
  std::set<std::filesystem::path> characters;
};

/// Reads the set that a look names, and finds what is wrong with the look that the schema cannot
/// tell; `path` is the look's. `joints` are those that point lights and traces may name; none: not
/// known before the motion is read.
std::vector<Fault> complete_look(Look& look, const std::string& path, const Places& places,
                                 const std::vector<std::string>& joints, LookFiles& files);

}  // namespace mien::pipeline

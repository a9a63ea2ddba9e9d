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

/// Sets that looks of one document named, by name and file, so that each is read once.
using ReadSets = std::map<std::pair<std::string, std::filesystem::path>, scenes::SetPlan>;

/// Characters that looks of one document named and that were found good.
using CheckedFiles = std::set<std::filesystem::path>;

/// Reads the set that a look names; `path` is the look's. Faults: those of the set.
std::vector<Fault> resolve_set(Look& look, const std::string& path, const Places& places,
                               ReadSets& sets);

/// Faults of a look that the schema cannot express. `joints` are those that point lights and
/// traces may name; none: not known before the motion is read.
std::vector<Fault> check_look(const Look& look, const std::string& path, const Places& places,
                              const std::vector<std::string>& joints, CheckedFiles& characters);

}  // namespace mien::pipeline

#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "pipeline/base/documents/fault.h"
#include "pipeline/base/documents/places.h"
#include "pipeline/manifest/look/look.h"
#include "scenes/character/face_control.h"

namespace mien::pipeline {

/// The sets named by the looks of one document, by name and file, so that each is read once.
using ReadSets = std::map<std::pair<std::string, std::filesystem::path>, scenes::SetPlan>;

/// Character files that are named by the looks of one document and have been checked successfully,
/// with what moves the face of each.
using CheckedFiles = std::map<std::filesystem::path, scenes::FaceControls>;

/// Reads the set of a look (scene_of); `path` is the path of the look in the document. Returns the
/// faults of the set.
std::vector<Fault> resolve_set(Look& look, const std::string& path, const Places& places,
                               ReadSets& sets);

/// Returns faults of a look that the schema cannot express. `joints` are the joint names that
/// point-light figures and traces may use; empty if they are unknown until the motion is read.
std::vector<Fault> check_look(const Look& look, const std::string& path, const Places& places,
                              const std::vector<std::string>& joints, CheckedFiles& characters);

}  // namespace mien::pipeline

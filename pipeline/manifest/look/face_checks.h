#pragma once

#include <string>

#include "pipeline/base/documents/fault_list.h"
#include "pipeline/manifest/look/look.h"
#include "pipeline/manifest/look/look_checks.h"

namespace mien::pipeline {

/// Adds faults of a look's face: if the figure has none, if names are not those of the character,
/// and if the file of weights cannot be read. `path` is the path of the look in the document.
/// `characters` contains the character, unless that has faults.
void check_face(const Look& look, const std::string& path, FaultList& list,
                const CheckedFiles& characters);

}  // namespace mien::pipeline

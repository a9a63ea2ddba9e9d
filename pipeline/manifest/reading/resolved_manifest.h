#pragma once

#include <vector>

#include "pipeline/base/documents/fault.h"
#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

/// A manifest with all that its parts take from each other and from the files that they name: what
/// each modification does, the motions of foils, the references of holds, the sets of looks, scales
/// and texts for participants.
struct ResolvedManifest {
  Manifest manifest;
  std::vector<Fault> faults;        ///< what could not be had, and is left as it was
  bool knows_what_is_asked = true;  ///< the scales and texts are there
};

/// Resolves a manifest that is as it was written (build_manifest). A file of scales that is not
/// there is left to the checks.
ResolvedManifest resolve(Manifest manifest);

}  // namespace mien::pipeline

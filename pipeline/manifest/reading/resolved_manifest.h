#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "pipeline/base/documents/fault.h"
#include "pipeline/base/reading/yaml_json.h"
#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

/// A manifest with all that its parts take from each other and from the files that they name: what
/// each modification does, the motions of foils, the references of holds, the sets of looks, scales
/// and texts for participants.
struct ResolvedManifest {
  Manifest manifest;
  std::vector<Fault> faults;             ///< what could not be had, and is left as it was
  bool are_experiments_resolved = true;  ///< the scales and texts are there
};

/// Resolves a manifest that is as it was written (build_manifest). A file of scales that is not
/// there is left to the checks.
ResolvedManifest resolve(Manifest manifest);

/// The manifest that a document describes, as it was written: paths resolved from the folder of
/// `file`, a stimulus's own values laid over the manifest's. Values that are absent or of a wrong
/// type keep their defaults; check_schema reports them. Reads no file: `names` is called for each
/// file or folder that the document names, with its path as written and as resolved.
Manifest build_manifest(
    JsonReading reading, const std::filesystem::path& file,
    const std::function<void(const std::string&, const std::filesystem::path&)>& names = {});

}  // namespace mien::pipeline

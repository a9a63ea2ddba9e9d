#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "pipeline/base/documents/fault.h"
#include "pipeline/base/reading/yaml_json.h"
#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

/// A manifest in which all references are resolved: the settings of modifications, the motions of
/// foils, the stimuli whose values `hold:` keeps, the sets of `look:`, the scales and the texts for
/// participants.
struct ResolvedManifest {
  Manifest manifest;
  std::vector<Fault> faults;  ///< references that could not be resolved and remain unchanged
  bool are_experiments_resolved = true;  ///< false: reading scales or texts gave faults
};

/// Resolves a manifest as returned by build_manifest. A missing scales file is reported later by
/// the checks.
ResolvedManifest resolve(Manifest manifest);

/// Called with a path as written in a document and as resolved, which it may replace.
using PathVisitor = std::function<void(const std::string&, std::filesystem::path&)>;

/// Returns the manifest that a document describes. Paths are resolved against the folder of `file`;
/// other references are not resolved. A stimulus's own values replace the manifest's. Values that
/// are absent or of a wrong type keep their defaults; check_schema reports wrong types. Reads no
/// file; `names` is called for each file or folder that the document names, with its path as
/// written and as resolved, and may replace the latter.
Manifest build_manifest(JsonReading reading, const std::filesystem::path& file,
                        const PathVisitor& names = {});

}  // namespace mien::pipeline

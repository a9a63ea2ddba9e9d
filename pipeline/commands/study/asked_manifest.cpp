#include "pipeline/commands/study/asked_manifest.h"

#include "pipeline/base/documents/environment.h"
#include "pipeline/commands/line/installed_manifests.h"
#include "pipeline/manifest/asked.h"
#include "pipeline/manifest/checks/checked_manifest.h"

namespace mien::pipeline {

Manifest asked_manifest(const std::string& name, const Console& console) {
  Manifest manifest = load_manifest(manifest_meant(name, console), process_environment());
  questionnaire_of(manifest);
  return manifest;
}

Manifest participants_manifest(const std::string& name, const Console& console) {
  Manifest manifest = load_manifest(manifest_meant(name, console), process_environment());
  if (!manifest.matching) questionnaire_of(manifest);
  return manifest;
}

}  // namespace mien::pipeline

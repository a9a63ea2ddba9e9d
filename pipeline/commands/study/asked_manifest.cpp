#include "pipeline/commands/study/asked_manifest.h"

#include "pipeline/checks/checked_manifest.h"
#include "pipeline/commands/installed_manifests.h"
#include "pipeline/documents/environment.h"
#include "pipeline/manifest/asked.h"

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

#pragma once

#include <string>

#include "pipeline/commands/line/console.h"
#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

/// The manifest of that name, which must have a questionnaire. Throws Faults, or Error where it has
/// none.
Manifest asked_manifest(const std::string& name, const Console& console);

/// The manifest of that name, which must have a questionnaire or a matching experiment. Throws
/// likewise.
Manifest participants_manifest(const std::string& name, const Console& console);

inline constexpr char asked_manifest_help[] =
    "Manifest (YAML) with a questionnaire or a matching experiment, the name of one of mien "
    "manifests, or a study's "
    "provenance.json";

}  // namespace mien::pipeline

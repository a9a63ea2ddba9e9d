#pragma once

#include <filesystem>
#include <string>

#include "pipeline/base/documents/table.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/production/synthesis/motions.h"

namespace mien::pipeline {

extern const TableForm stimuli_form;
extern const TableForm warnings_form;

/// The table that all others join: how each stimulus was made and shown, and its files, as they lie
/// in the study's folder.
std::string stimuli_csv(const Manifest& manifest, Motions& motions,
                        const std::filesystem::path& folder);

/// What a run has to say about examples, design, motions and films; of these the records in the
/// study's folder tell.
std::string warnings_csv(const Manifest& manifest, Motions& motions,
                         const std::filesystem::path& folder);

}  // namespace mien::pipeline

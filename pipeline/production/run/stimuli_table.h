#pragma once

#include <filesystem>
#include <string>

#include "pipeline/base/documents/table.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/production/synthesis/motions.h"

namespace mien::pipeline {

extern const TableForm stimuli_form;
extern const TableForm warnings_form;

/// Returns the table to which all others can be joined: the sources, the presentation and the files
/// of each stimulus and overlay, as found in the study's folder.
std::string stimuli_csv(const Manifest& manifest, Motions& motions,
                        const std::filesystem::path& folder);

/// Returns the warnings of a run about examples, design, motions and films; those about films are
/// read from the records in the study's folder.
std::string warnings_csv(const Manifest& manifest, Motions& motions,
                         const std::filesystem::path& folder);

}  // namespace mien::pipeline

#pragma once

#include <filesystem>
#include <string>

#include "pipeline/base/documents/table.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/production/design/design_findings.h"
#include "pipeline/production/synthesis/motions.h"

namespace mien::pipeline {

extern const TableForm stimuli_form;
extern const TableForm warnings_form;

/// Returns the table of stimuli and overlays, to which other tables can be joined by id: sources,
/// presentation and files, as found in the study's folder.
std::string stimuli_csv(const Manifest& manifest, Motions& motions,
                        const std::filesystem::path& folder);

/// Returns the warnings of a run about examples, design, motions and films; those about films are
/// read from the records in the study's folder. `design` are the
/// findings about the factors.
std::string warnings_csv(const Manifest& manifest, Motions& motions,
                         const std::filesystem::path& folder, const DesignFindings& design);

}  // namespace mien::pipeline

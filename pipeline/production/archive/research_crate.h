#pragma once

#include <string>
#include <vector>

#include "pipeline/production/archive/pack.h"

namespace mien::pipeline {

/// Describes a packed study as a research object: RO-Crate 1.1 metadata (JSON-LD; Soiland-Reyes et
/// al. 2022, doi:10.3233/DS-210053) that follows the profiles Workflow RO-Crate 1.0 and Workflow
/// Run Crate 0.5 (Leo et al. 2024, doi:10.1371/journal.pone.0309210). The manifest
/// inputs/as-run.yaml is the workflow, the run of mien an action with the inputs as its objects and
/// the artifacts as its results; recordings that are not in `payload` are described without a file.
/// A frame sequence is one folder. The metadata contain no times of the run, because a study's
/// provenance has none, and a date of publication, author and licence only if `info` does.
std::string crate_metadata(const StudyContents& contents, const std::vector<PayloadFile>& payload,
                           const BagInfo& info);

/// What RO-Crate requires of a published crate and `info` does not state, as options of mien pack.
std::vector<std::string> lacking_of_crate(const BagInfo& info);

}  // namespace mien::pipeline

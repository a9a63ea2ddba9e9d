#pragma once

#include <vector>

#include "pipeline/base/documents/fault.h"
#include "pipeline/manifest/reading/resolved_manifest.h"

namespace mien::pipeline {

/// What a schema cannot say: ids that occur twice, files that are missing, sizes that no encoder
/// takes, values that need examples or ratings where there are none, sheets of one motion, looks
/// and questionnaires that contradict themselves. No check needs that others went before.
std::vector<Fault> check_meaning(const ResolvedManifest& resolved);

}  // namespace mien::pipeline

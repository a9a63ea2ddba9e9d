#pragma once

#include <vector>

#include "pipeline/base/documents/fault.h"
#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

/// Returns a fault for each motion that participants' browsers would get although the licence of a
/// recording it is made from does not permit sharing (`licence: {share: false}`). They get motions,
/// which anyone can copy, in matching and adaptive experiments and in questionnaires with `view:
/// turn`; other questionnaires give them videos alone. The manifest has one or the other.
std::vector<Fault> restricted_motions(const Manifest& manifest);

}  // namespace mien::pipeline

#pragma once

#include <vector>

#include "pipeline/base/documents/fault.h"
#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

/// Faults of keys and constraints (`modify: {keys: …, constraints: …}`) that do not depend on the
/// motion.
std::vector<Fault> check_animation(const Manifest& manifest);

}  // namespace mien::pipeline

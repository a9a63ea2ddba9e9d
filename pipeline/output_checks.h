#pragma once

#include <vector>

#include "pipeline/fault.h"
#include "pipeline/manifest.h"

namespace mien::pipeline {

/// Pictures and videos that cannot be as they are described: sizes, rates, shutters, names.
std::vector<Fault> check_outputs(const Manifest& manifest);

}  // namespace mien::pipeline

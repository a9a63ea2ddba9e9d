#pragma once

#include "pipeline/base/documents/fault_list.h"
#include "pipeline/manifest/stimulus.h"

namespace mien::pipeline {

/// Finds what cannot be walked in a stimulus' `path:`, if it has one: moods that are none, steps
/// that contradict themselves, points that are too near, and what would take too long.
void check_walk_path(const Stimulus& stimulus, FaultList& list);

}  // namespace mien::pipeline

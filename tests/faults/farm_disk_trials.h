#pragma once

#include "faults/trial.h"

namespace mien::test {

// Slurm's programs are replaced by fakes.

/// `mien farm resume` on a full disk: all jobs stay unchanged.
Figures resumed_on_full_disks();

/// Batch files whose study's folder is full or read-only for a while: they wait and continue, and
/// `mien farm status` shows the problem.
Figures jobs_on_failing_disks();

}  // namespace mien::test

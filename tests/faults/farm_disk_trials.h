#pragma once

#include "faults/trial.h"

namespace mien::test {

// Slurm's programs are stood in for.

/// `mien farm resume` on a disk that is full: all jobs stay as they are.
Figures resumed_on_full_disks();

/// Batch files whose study's folder is full or read-only for a while: they wait and go on, and
/// `mien farm status` tells what ails it.
Figures jobs_on_ailing_disks();

}  // namespace mien::test

#pragma once

#include "faults/trial.h"

namespace mien::test {

/// `mien farm resume` on a disk that is full: all jobs stay as they are. Slurm's programs are stood
/// in for.
Figures resumed_on_full_disks();

}  // namespace mien::test

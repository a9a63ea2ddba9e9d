#pragma once

#include "faults/trial.h"

namespace mien::test {

/// A disk with space for part of the study, or for a limited number of files: expects one clear
/// error, and that the same command continues once there is more space.
Figures full_disks(Trial& trial, int disks);

/// A disk that fills up while two processes work, and has free space again after a while.
Figures disks_full_for_a_while(Trial& trial, int disks);

/// A store that is read-only from the start or from some moment on.
Figures read_only_stores(Trial& trial, int stores);

}  // namespace mien::test

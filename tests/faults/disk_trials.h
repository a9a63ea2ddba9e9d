#pragma once

#include "faults/trial.h"

namespace mien::test {

/// A disk that has room for a part of the study, or for so many files: one clear error; with more
/// room the same command goes on.
Figures full_disks(Trial& trial, int disks);

/// A disk that fills up while two processes work, and has room again after a while.
Figures disks_full_for_a_while(Trial& trial, int disks);

/// A store that cannot be written to, from the beginning or from some moment on.
Figures read_only_stores(Trial& trial, int stores);

}  // namespace mien::test

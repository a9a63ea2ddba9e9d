#pragma once

#include "faults/trial.h"

namespace mien::test {

/// Artifacts, frames and receipts of a finished study are damaged, swapped and forged, so many in
/// all, some at a time; one or two processes make it good, and say what they found.
Figures damaged_files(Trial& trial, int faults);

/// The same in a study that was killed on the way: frames in the making and notes of them, claims,
/// records of workers.
Figures damaged_work(Trial& trial, int faults);

/// Times of all files of a finished study, or of one that was killed on the way and is gone on
/// with, lie in the far past or future: a clock that was set.
Figures set_clocks(Trial& trial, int times);

}  // namespace mien::test

#pragma once

#include "faults/trial.h"

namespace mien::test {

/// Damages, swaps and forges artifacts, frames and receipts of a finished study, `faults` in total,
/// several at a time; one or two processes repair it and report what they found.
Figures damaged_files(Trial& trial, int faults);

/// The same for a study killed half-way: unpublished frames and their notes, claims, and records of
/// workers.
Figures damaged_work(Trial& trial, int faults);

/// Sets the times of all files of a finished study, or of one that was killed and is resumed, to
/// the far past or future, as a changed clock would.
Figures set_clocks(Trial& trial, int times);

}  // namespace mien::test

#pragma once

#include "faults/trial.h"

namespace mien::test {

/// Two processes at a time on one study: `mien run` twice, or beside a worker of the farm. One of
/// them, by chance both, is killed at a random moment and begun again, until the study is made;
/// then the next study. After so many kills in all it is enough.
Figures random_kills(Trial& trial, int kills);

/// Two processes begin the same at the same moment, undisturbed.
Figures duplicated_workers(Trial& trial, int pairs);

/// One process is stopped at a random moment; another one does its work; then the first one wakes.
/// `waits`: the other one has to find out by its silence that the first one is to be counted as
/// dead; else its record is taken away, so that it counts as dead at once.
Figures paused_workers(Trial& trial, int pauses, bool waits);

}  // namespace mien::test

#pragma once

#include "faults/trial.h"

namespace mien::test {

/// Two processes at a time on one study: `mien run` twice, or with a worker of the farm. One of
/// them, at random both, is killed at a random moment and restarted until the study is complete;
/// then follows the next study, until there were `kills` kills.
Figures random_kills(Trial& trial, int kills);

/// Two processes start the same study at the same moment, undisturbed.
Figures duplicated_workers(Trial& trial, int pairs);

/// One process is stopped at a random moment; another one does its work; then the first continues.
/// `waits`: the other one has to detect by the missing heartbeat that the first counts as dead;
/// otherwise its record is removed, so that it counts as dead at once.
Figures paused_workers(Trial& trial, int pauses, bool waits);

}  // namespace mien::test

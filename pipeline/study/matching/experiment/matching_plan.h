#pragma once

#include <vector>

#include "pipeline/manifest/manifest.h"
#include "pipeline/study/questionnaire/session_plan.h"

namespace mien::pipeline {

/// The sessions of a matching experiment for all planned participants, or for `count` when that is
/// not 0. A trial is a target (its stimulus) and an interface (its item).
///
/// Practice comes first: its motions one after the other, with the interfaces in the participant's
/// own order, so many trials that each motion and each interface comes. Then one block an
/// interface, in each of which every target comes once. Blocks follow a row of Williams' square of
/// the interfaces (latin_square.h); targets a row of theirs, another one in each block and for each
/// participant of the same order of blocks.
///
/// Where guesses come first, blocks are targets in that participant's row, in each of which every
/// interface comes once, in another row of theirs in each block; so practice has every motion with
/// every interface. Every plan is a pure function of (manifest, its index).
std::vector<SessionPlan> plan_matching(const Manifest& manifest, int count = 0);

/// What a session is reckoned to take: its texts read, for each trial a guess (30 s), half of the
/// limit to match, and a pause (15 s).
double matching_seconds(const Manifest& manifest, const SessionPlan& plan);

}  // namespace mien::pipeline

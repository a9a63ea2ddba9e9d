#pragma once

#include <vector>

#include "pipeline/manifest/manifest.h"
#include "pipeline/study/trials/trial_kind.h"

namespace mien::pipeline {

/// The main part of a session with adaptive trials: those of the tracks and, of yes–no and
/// same–different trials, those without the signal. Everything that is drawn at random is drawn
/// here, also which of several stimuli of a level a trial would show, and in which order; only the
/// levels depend on the answers.
///
/// In each round all tracks have one trial, in random order. Trials without the signal stand at
/// random places. Of the trials of each track, half show the signal first, and each stimulus of a
/// level (or without the signal) is drawn equally often, as far as the number of trials permits.
/// The trials have the block "main", no items and no numbers. Deterministic in `seed`, that of the
/// session.
std::vector<Trial> adaptive_part(const Manifest& manifest, std::uint64_t seed);

/// The trial as it is shown at a level, given as its place in the grid; it must be adaptive.
/// `levels` are the levels of the grid as stated (TrackProcedure).
Trial shown_at(const Trial& trial, std::size_t place, const std::vector<std::string>& levels);

}  // namespace mien::pipeline

#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "pipeline/farm/jobs/job_fates.h"
#include "pipeline/farm/stages.h"

namespace mien::pipeline {

/// By task of a film ("film:walk").
using PiecesByFilm = std::map<std::string, FilmPieces>;

/// Frames that are kept of films that are due: drawn before, or published beside a video that is
/// missing. `planned`: an outcome a task. `frames`: lengths of the films. `folder`: the study's.
/// Goes by what lies there; a worker checks it, and draws again what is damaged.
PiecesByFilm kept_pieces(const TaskGraph& graph, const std::vector<TaskOutcome>& planned,
                         const std::map<std::string, int>& frames,
                         const std::filesystem::path& folder);

/// Adds the frames that live jobs draw, and keeps films cut as those jobs have them.
void add_live_pieces(const std::vector<JobFate>& fates, const std::map<std::string, int>& frames,
                     const std::filesystem::path& folder, PiecesByFilm& pieces);

}  // namespace mien::pipeline

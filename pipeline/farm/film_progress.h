#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "pipeline/farm/jobs/job_status.h"
#include "pipeline/farm/stages.h"
#include "pipeline/production/film/film_task.h"

namespace mien::pipeline {

/// Where a film's task stores its frames. `planned`: one outcome per task; the film is due.
StoredSequence stored_sequence(const Task& film, const TaskGraph& graph,
                               const std::vector<TaskOutcome>& planned);

/// Stored frames and chunk count of each film, by its task ("film:walk").
using ProgressByFilm = std::map<std::string, FilmProgress>;

/// Determines which frames of the films that are due exist already: unpublished frames, and those
/// of a published frame sequence whose video is missing. `planned`: one outcome per task. `frames`:
/// number of frames of each film. `folder`: the study's. Published frames are compared with their
/// hashes. Of unpublished ones, only the existence is checked; a worker verifies them and renders
/// damaged ones again.
ProgressByFilm stored_film_progress(const TaskGraph& graph, const std::vector<TaskOutcome>& planned,
                                    const std::map<std::string, int>& frames,
                                    const std::filesystem::path& folder);

/// Adds the frames assigned to live jobs, and sets the number of chunks of each film on which these
/// jobs work.
void add_frames_of_live_jobs(const std::vector<JobStatus>& statuses,
                             const std::map<std::string, int>& frames,
                             const std::filesystem::path& folder, ProgressByFilm& film_progress);

}  // namespace mien::pipeline

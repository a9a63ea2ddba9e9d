#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "pipeline/farm/jobs/job_problems.h"
#include "pipeline/farm/jobs/worker_reports.h"
#include "pipeline/production/run/production.h"

namespace mien::pipeline {

/// Progress of one stage: how many of its tasks (or, for "frames", frames) are completed.
struct StageProgress {
  std::string name;  ///< "films"
  int done = 0;
  int total = 0;
};

/// Activity of one machine for a study.
struct NodeStatus {
  std::string name;
  int elements = 0;                ///< number of running elements of job arrays and final jobs
  int workers = 0;                 ///< number of live worker processes (WorkerReport::is_alive)
  std::vector<std::string> tasks;  ///< tasks in progress
  double frames_per_second = 0.0;  ///< sum over these workers of their mean so far
};

/// Progress of a study's production over all workers, started by Slurm or by hand.
struct FarmStatus {
  std::string study;
  std::string folder;
  std::string words;  ///< arguments that name the study in commands: "my.yaml --out /scratch"
  /// Those of motions, films, clips, dots, sheets and study that have tasks.
  std::vector<StageProgress> stages;
  StageProgress frames;  ///< frames of all films; `done` includes stored frames of incomplete films
  std::vector<NodeStatus> nodes;
  std::map<std::string, int>
      waiting;  ///< number of pending elements and final jobs, except held ones, by Slurm's reason
  std::vector<JobProblem> problems;  ///< those of cancelled jobs are omitted
  std::vector<FailedItem> failed;
  std::vector<std::string> losses;  ///< lost_job_messages
  std::string disk;                 ///< current problem of the study's folder; empty if none
  std::optional<double>
      seconds_left;  ///< estimated time for the remaining frames; empty if no live worker has
                     ///< rendered a frame, or if the study is complete
  /// All artifacts exist, and provenance.json describes them.
  bool is_complete = false;
  bool lacks_record = false;  ///< all artifacts exist, but provenance.json does not describe them
  std::string without_slurm;  ///< why job states are unknown; empty if they are known

  int running() const;
  /// Whether a worker or a job is running, or a job is pending and not held.
  bool is_active() const;
};

/// Determines the status from receipts and file sizes, the workers' reports and the queue. `queue`:
/// Slurm's jobs; nullopt if they are unknown, and then `fault` gives the reason. `words`: the
/// study's arguments in commands. `nodes`: states of Slurm's nodes.
FarmStatus farm_status(const Production& production, const std::filesystem::path& folder,
                       const std::optional<std::vector<QueueRow>>& queue, const std::string& fault,
                       const std::string& words, const NodeStates& nodes = {});

/// The study's present state, against which `job_problems` compares jobs.
StudyState study_state(const Production& production, const std::filesystem::path& folder,
                       const std::string& words);

/// Recorded failures of tasks that the study still has to do.
std::vector<FailedItem> present_failures(const TaskGraph& graph, const StudyState& state);

/// Number of a film's unpublished frames in the store, by the key under which they are kept.
std::map<Hash, int> frames_in_the_making(const std::filesystem::path& folder,
                                         const std::string& film);

/// The status as text for the terminal.
std::string status_text(const FarmStatus& status);
nlohmann::ordered_json status_json(const FarmStatus& status);

}  // namespace mien::pipeline

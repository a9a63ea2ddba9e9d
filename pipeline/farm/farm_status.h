#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "pipeline/farm/jobs/job_troubles.h"
#include "pipeline/farm/jobs/worker_reports.h"
#include "pipeline/production/run/production.h"

namespace mien::pipeline {

/// How far something is.
struct Share {
  std::string name;  ///< "films"
  int done = 0;
  int total = 0;
};

/// What a machine does for a study.
struct NodeStatus {
  std::string name;
  int elements = 0;  ///< of job arrays that run there
  int workers = 0;   ///< processes that were heard of a short time ago
  std::vector<std::string> tasks;
  double frames_per_second = 0.0;
};

/// How a study's production goes on, whoever works on it.
struct FarmStatus {
  std::string study;
  std::string folder;
  std::string words;          ///< how it is told in commands: "my.yaml --out /scratch"
  std::vector<Share> stages;  ///< tasks: motions, films, clips, sheets, study
  Share frames;               ///< of all films; those in the making count
  std::vector<NodeStatus> nodes;
  std::map<std::string, int> waiting;  ///< elements by Slurm's reason
  std::vector<JobTrouble> troubles;
  std::vector<FailedItem> failed;
  std::vector<std::string> losses;  ///< told_losses
  std::string disk;                 ///< what ails the study's folder now; empty when nothing does
  std::optional<double> seconds_left;  ///< at the present pace; none while no frame is drawn
  bool is_complete = false;            ///< all is there, the study's record too
  std::string without_slurm;           ///< why nothing is known of jobs; empty when it is

  int running() const;
  /// Whether anybody works on it, or will.
  bool is_active() const;
};

/// From the store at a glance, the workers' own reports and the queue; `queue` may be missing,
/// `fault` says why. `words`: how the study is told in commands. `nodes`: how Slurm's nodes are.
FarmStatus farm_status(const Production& production, const std::filesystem::path& folder,
                       const std::optional<std::vector<QueueRow>>& queue, const std::string& fault,
                       const std::string& words, const NodeStates& nodes = {});

/// What `job_troubles` are told against.
StudyState study_state(const Production& production, const std::filesystem::path& folder,
                       const std::string& words);

/// Frames of a film that are kept until it is encoded, of whatever version of it.
int frames_in_the_making(const std::filesystem::path& folder, const std::string& film);

/// For people.
std::string status_text(const FarmStatus& status);
nlohmann::ordered_json status_json(const FarmStatus& status);

}  // namespace mien::pipeline

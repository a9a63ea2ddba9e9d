#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "pipeline/farm/jobs/job_fates.h"

namespace mien::pipeline {

/// A job, or an element of an array, that somebody has to look at.
struct JobTrouble {
  enum class Kind {
    held,      ///< Slurm keeps it, and it will not run by itself
    outdated,  ///< waits or runs, but the study is another by now: it will make nothing
    silent,    ///< runs, as Slurm counts, but its node or its worker gives no sign of life
    ended,     ///< is over and left something undone
    cancelled  ///< likewise, because somebody took it back
  };
  Kind kind = Kind::ended;
  std::string submission;  ///< "0001"
  std::string element;     ///< "2-frames.3"; of the job for what is left "6-rest.1"
  std::string job;         ///< Slurm's: "17_3"
  std::string reason;      ///< Slurm's word for it: "JobHeldUser"; empty when it has forgotten it
  std::string cause;       ///< "wrong set-up (exit code 78)"
  std::string remedy;      ///< the command that goes on, and what to do before
};

/// The study as it is now, against which its jobs are held.
struct StudyState {
  std::filesystem::path folder;
  std::string graph_key;       ///< of submission.h
  std::set<std::string> done;  ///< tasks whose products are there
  bool is_complete = false;    ///< the study's record is there too
  std::string words;           ///< the study in commands that are proposed: "my.yaml --out o"
};

/// Of all submissions, in their order. What ended badly counts as long as something that it was to
/// make is missing and was not submitted again since. From what Slurm still knows, and from the
/// codes that jobs leave in ends/.
std::vector<JobTrouble> job_troubles(const std::vector<JobFate>& fates, const StudyState& study);

/// Troubles of one kind and cause together, for people.
std::string troubles_text(const std::vector<JobTrouble>& troubles);

}  // namespace mien::pipeline

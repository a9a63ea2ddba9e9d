#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "pipeline/farm/jobs/submission_journal.h"
#include "pipeline/farm/slurm/slurm_output.h"

namespace mien::pipeline {

/// Status of a job that the journal records.
struct JobStatus {
  enum class Kind {
    live,   ///< at least one element is pending or running
    ended,  ///< all elements have ended, successfully or not, or the job was refused or cancelled
    lost,   ///< accepted, but now unknown to Slurm, and no element has written a log
    unconfirmed  ///< the client stopped before Slurm's answer was recorded, and the job is
                 ///< unknown to Slurm
  };
  Kind kind = Kind::ended;
  JournalJob journal;          ///< with Slurm's job ID, even if the journal lacks it
  bool is_adopted = false;     ///< the ID was found by the job's comment, not in the journal
  std::vector<QueueRow> rows;  ///< its rows in the output of squeue

  /// Rows of elements that are pending or running, including held ones.
  std::vector<QueueRow> live() const;
};

/// Status of each of a study's jobs according to squeue. Jobs are matched by their comments, since
/// Slurm may reuse IDs. `folder`: the study's; a log in it shows that a job had started.
std::vector<JobStatus> job_statuses(const JournalContent& journal,
                                    const std::vector<QueueRow>& queue,
                                    const std::filesystem::path& folder);

/// Slurm's IDs of all live jobs and elements, as scancel accepts them: "17_3", or "17".
std::vector<std::string> live_jobs(const std::vector<JobStatus>& statuses);

/// Slurm's IDs of pending and running jobs of the study with this graph key (submission.h),
/// including jobs that its journal does not record.
std::vector<std::string> live_jobs_of_graph(const std::vector<QueueRow>& queue,
                                            const std::string& graph_key);

/// One sentence for each job of the newest submission that Slurm has lost or never confirmed; empty
/// if there are none.
std::vector<std::string> lost_job_messages(const std::vector<JobStatus>& statuses);

/// The ID of a row's job in Slurm's commands: "17_3".
std::string name_of(const QueueRow& row);

/// How the last attempt at an element failed.
struct ElementExit {
  int code = 0;  ///< exit code of the program (`mien farm worker`; `mien run` for the final job),
                 ///< or 128 + signal number
  int restarts = 0;            ///< number of times Slurm had requeued it before
  bool out_of_memory = false;  ///< the job's control group counted an out-of-memory kill
};

/// Failures that jobs of a submission recorded in ends/, by job ("2-frames") and element number,
/// from 1. `submission`: its folder, out/<study>/farm/0001. Unreadable files are ignored.
std::map<std::pair<std::string, int>, ElementExit> read_element_exits(
    const std::filesystem::path& submission);

/// Number of newest submissions whose folders are never removed.
inline constexpr std::size_t retained_submissions = 3;

/// Numbers of older submissions whose folders may be removed: none of their jobs is pending or
/// running, and none of their tasks is in `due`, the tasks still to be done. `folder`: the study's.
std::vector<std::string> removable_submissions(const std::vector<JobStatus>& statuses,
                                               const std::set<std::string>& due,
                                               const std::filesystem::path& folder);

/// Removes the batch files, task lists, recorded exit codes and logs of submissions; their journal
/// entries remain. Returns the number of removed folders. `folder`: the study's.
int remove_submissions(const std::vector<std::string>& numbers,
                       const std::filesystem::path& folder);

}  // namespace mien::pipeline

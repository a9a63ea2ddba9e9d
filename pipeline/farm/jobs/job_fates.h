#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "pipeline/farm/jobs/submission_journal.h"
#include "pipeline/farm/slurm/slurm_answers.h"

namespace mien::pipeline {

/// What became of a job of the journal.
struct JobFate {
  enum class Kind {
    live,       ///< some of it waits or runs
    ended,      ///< all of it is over, well or not
    lost,       ///< Slurm forgot it before any of it wrote a log, or gave its number to another
    unanswered  ///< the client stopped between intent and answer, and Slurm does not have it
  };
  Kind kind = Kind::ended;
  JournalJob journal;          ///< with the number that Slurm gave, even if the journal lacks it
  bool is_adopted = false;     ///< the journal lacked it
  std::vector<QueueRow> rows;  ///< of it, as squeue has them

  /// Rows that wait or run; stuck ones too.
  std::vector<QueueRow> live() const;
};

/// What squeue knows of the jobs of a study. A job counts as the study's by its comment, never by
/// its number alone. `folder`: the study's, where logs tell that a job had begun.
std::vector<JobFate> job_fates(const JournalContent& journal, const std::vector<QueueRow>& queue,
                               const std::filesystem::path& folder);

/// Of all of them: "17_3", as scancel takes it, or "17".
std::vector<std::string> live_jobs(const std::vector<JobFate>& fates);

/// Jobs that wait or run, whoever submitted them, of the study with this graph key (submission.h).
std::vector<std::string> live_jobs_called(const std::vector<QueueRow>& queue,
                                          const std::string& graph_key);

/// The jobs of the newest submission that Slurm lost, and those it never answered for, in
/// sentences; empty when all is well.
std::vector<std::string> told_losses(const std::vector<JobFate>& fates);

/// How a row is called in commands of Slurm: "17_3".
std::string name_of(const QueueRow& row);

/// How the last attempt at an element ended, when it did not end well.
struct ElementEnd {
  int code = 0;                ///< of the worker, or 128 + the signal that ended it
  int restarts = 0;            ///< how often Slurm had begun it anew before
  bool lacked_memory = false;  ///< the job's control group counts a kill for want of memory
};

/// What jobs of a submission left in ends/, by job ("2-frames") and element, from 1. `submission`:
/// its folder, out/<study>/farm/0001. A file that says nothing is left out.
std::map<std::pair<std::string, int>, ElementEnd> ends_in(const std::filesystem::path& submission);

/// So many of the newest submissions keep their folders.
inline constexpr std::size_t kept_submissions = 3;

/// Older submissions whose folders nobody needs any more, by number: none of their jobs waits or
/// runs, and nothing of what they were to make is `due` (tasks that are to be made). `folder`: the
/// study's.
std::vector<std::string> spent_submissions(const std::vector<JobFate>& fates,
                                           const std::set<std::string>& due,
                                           const std::filesystem::path& folder);

/// Removes the batch files, lists, notes and logs of submissions. The journal keeps what they were,
/// and their numbers. How many had a folder.
int remove_submissions(const std::vector<std::string>& numbers,
                       const std::filesystem::path& folder);

}  // namespace mien::pipeline

#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "pipeline/farm/jobs/submission_journal.h"
#include "pipeline/farm/slurm/batch_script.h"
#include "pipeline/farm/slurm/slurm.h"
#include "pipeline/farm/stages.h"

namespace mien::pipeline {

/// A job with the items of its elements, from which its batch file and task list are written.
struct SubmissionJob {
  BatchJob job;
  JobRequest request;
  std::vector<Element> elements;  ///< empty: the final job that completes the study
};

/// Job arrays that may run at the same time.
struct SubmissionStage {
  int place = 0;  ///< 1 motions, 2 frames, 3 films, 4 sheets, 5 study, 6 remaining tasks
  std::vector<SubmissionJob> jobs;
};

/// Jobs submitted to Slurm together. The jobs of a stage wait until those of the previous stage
/// have ended, the last job until all others have. They do not wait for success, because a job
/// produces its missing inputs itself.
struct Submission {
  JournalSubmission requested;
  std::filesystem::path folder;  ///< out/<study>/farm/0001, absolute
  StudyCall call;
  SlurmSite site;
  std::vector<SubmissionStage> stages;  ///< the last one completes the study

  int elements() const;
  /// Number of jobs as counted by Slurm: elements and the final job.
  int jobs() const { return elements() + 1; }
};

/// Special treatment of single items of a study.
struct ItemNeeds {
  std::set<std::string> covered;  ///< items already assigned to live jobs
  /// Memory to request after a job ran out of it, by task and for the final job, which may have to
  /// make any task and so gets the largest amount of all.
  std::map<std::string, std::string> memory;
  std::string rest_memory;
};

/// Number of the next submission, such as "0004": the first number that is used neither by a folder
/// in farm/ nor in the journal.
std::string next_submission(const std::filesystem::path& study_folder);

/// A key that identifies Slurm's jobs as belonging to this study: a hash of its tasks, their
/// determinants and the study's folder.
std::string graph_key(const TaskGraph& graph, const std::filesystem::path& study_folder);

/// Distributes the elements of all stages, without the covered items, over job arrays of at most
/// the site's maximum size, and adds the final job that completes the study.
Submission submission_of(const std::vector<Stage>& stages, const ItemNeeds& needs,
                         const std::string& graph_key, JournalSubmission requested,
                         const std::filesystem::path& study_folder, const StudyCall& call,
                         const SlurmSite& site);

/// The texts of a job's batch file and of its task list.
std::string script_text(const Submission& submission, const SubmissionJob& job);
std::string list_text(const SubmissionJob& job);

/// Creates the submission's folder with all its files and records the intended jobs in the journal.
/// All of this is written before Slurm is called, so that a full disk leaves the queue unchanged.
/// Throws WriteFailure, Error for a path that a batch file cannot express, and std::runtime_error
/// if another client has just created a folder with that number; if it throws, this client leaves
/// no folder behind.
void write_submission(const Submission& submission, const SubmissionJournal& journal);

/// Withdraws a written submission: records `why` in the journal, if that can be written, and
/// removes its folder unless one of its jobs has started.
void withdraw(const Submission& submission, const SubmissionJournal& journal,
              const std::string& why);

/// A job that Slurm has accepted.
struct SubmittedJob {
  std::string name;  ///< "2-frames"
  std::string job;   ///< Slurm's job ID
  int elements = 0;
};

/// The accepted jobs of a submission.
struct Submitted {
  std::vector<SubmittedJob> jobs;
  std::string unrecorded;  ///< why a job's ID is missing from the journal; empty if none is
};

/// Submits a written submission to Slurm. Films and later stages also wait for `live`, jobs of
/// earlier submissions. If a job is refused, the jobs accepted before it are cancelled, the
/// submission is withdrawn and SlurmFault is thrown; if Slurm does not answer, SlurmTimeout is
/// thrown and the accepted jobs remain.
Submitted submit(const Submission& submission, const Slurm& slurm, const SubmissionJournal& journal,
                 const std::vector<std::string>& live);

}  // namespace mien::pipeline

#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/commands/farm/farm.h"
#include "pipeline/farm/film_progress.h"
#include "pipeline/farm/jobs/job_status.h"
#include "pipeline/farm/submission.h"

namespace mien::pipeline {

/// Options that determine how a study is split and which resources its jobs request. A member is
/// empty if its option was not given.
struct SubmissionOptions {
  std::string chunk;
  std::string partition;
  std::string time;
  std::string memory;
  std::string account;
  std::optional<int> array_limit;
  std::optional<int> jobs;
  std::string program;
};

std::vector<CommandOption> submission_options(SubmissionOptions& options);

/// The newest submission of which Slurm refused no jobs; nullptr if there is none.
const JournalSubmission* last_accepted(const JournalContent& journal);

/// Returns a copy of the earlier submission (which may be empty) in which the given options replace
/// the former values. Throws Error for an invalid value.
JournalSubmission requested_submission(const SubmissionOptions& options, JournalSubmission earlier);

/// Throws Error if an array task requests more processors than the largest node of its partition
/// has, since it would never start. Accepts any number if sinfo fails.
void refuse_too_many_processors(const JobRequest& request, const Slurm& slurm);

/// The remaining tasks of a study, and information for estimating their duration.
struct DueWork {
  std::vector<bool> is_due;           ///< for each task: whether it remains
  std::map<std::string, int> frames;  ///< number of frames of each film, by its task
  ProgressByFilm film_progress;       ///< progress of films that have been started
  double pace = 1.0;     ///< measured seconds of an array task per estimated second of its
                         ///< work, with the requested number of processors
  bool is_done = false;  ///< all artifacts exist, and provenance.json describes them
};

/// The tasks whose artifacts are missing from the store. Frames that are stored or assigned to live
/// jobs are not due again. Films keep the number of chunks used by those jobs.
DueWork due_work(FarmStudy& study, const JournalSubmission& requested,
                 const std::vector<JobStatus>& statuses);

/// The stages of all tasks, including completed ones.
std::vector<Stage> all_stages(FarmStudy& study, const JournalSubmission& requested);

/// A submission of the remaining tasks that fits into Slurm's queue. If array tasks (elements) must
/// be longer than usual in order to fit, prints a message. Throws Error if no submission fits.
Submission fitting_submission(const FarmStudy& study, const StudyCall& call, const DueWork& work,
                              const ItemNeeds& needs, const JournalSubmission& requested,
                              const SlurmSite& site, const std::vector<QueueRow>& queue,
                              const Console& console);

/// Removes folders of older submissions that are no longer needed, and prints a message.
/// `statuses`: status of all jobs in the journal.
void remove_old_submissions(const std::vector<JobStatus>& statuses, const DueWork& work,
                            const FarmStudy& study, const Console& console);

/// Prints the submitted jobs and suggested commands.
void print_submitted(const Submission& submission, const Submitted& submitted,
                     const FarmArguments& arguments, bool json, const Console& console);

/// Prints the submission instead of submitting it: its stages and the texts of its files.
void print_dry_run(const Submission& submission, const Console& console);

}  // namespace mien::pipeline

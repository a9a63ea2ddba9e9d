#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/commands/farm/farm.h"
#include "pipeline/farm/film_pieces.h"
#include "pipeline/farm/jobs/job_fates.h"
#include "pipeline/farm/submission.h"

namespace mien::pipeline {

/// How a study is cut and what is asked for its jobs; what nobody said is empty.
struct SubmissionOptions {
  std::string chunk;
  std::string partition;
  std::string time;
  std::string memory;
  std::string account;
  std::optional<int> array_limit;
  std::optional<int> jobs;
};

std::vector<CommandOption> submission_options(SubmissionOptions& options);

/// The newest submission of which Slurm refused nothing; null where there is none.
const JournalSubmission* last_accepted(const JournalContent& journal);

/// The options over those of an earlier submission (or over nothing). Throws Error for one that
/// makes no sense.
JournalSubmission asked_for(const SubmissionOptions& options, JournalSubmission earlier);

/// Throws Error when an element asks for more processors than any node of its partition has: its
/// job would wait for ever. Says nothing where Slurm does not tell.
void refuse_too_many_processors(const JobRequest& request, const Slurm& slurm);

/// What is to be made of a study, and what is known of how long it takes.
struct DueWork {
  std::vector<bool> is_due;           ///< by task
  std::map<std::string, int> frames;  ///< of each film, by its task
  PiecesByFilm pieces;                ///< of films that have been begun
  double pace = 1.0;                  ///< seconds that an estimated second of a task takes

  /// Whether everything is there, the study's record too.
  bool is_done(const FarmStudy& study) const;
};

/// All tasks that are not in the store yet, without frames that are kept or that jobs draw which
/// wait or run; films are cut as those jobs have them.
DueWork due_work(FarmStudy& study, const JournalSubmission& asked,
                 const std::vector<JobFate>& fates);

/// The stages of all tasks there are.
std::vector<Stage> all_stages(FarmStudy& study, const JournalSubmission& asked);

/// The submission of what is due, for which Slurm has room. Elements that are longer than usual for
/// that are told. Throws Error when there is no room.
Submission fitting_submission(const FarmStudy& study, const StudyCall& call, const DueWork& work,
                              const ItemNeeds& needs, const JournalSubmission& asked,
                              const SlurmSite& site, const std::vector<QueueRow>& queue,
                              const Console& console);

/// Removes the folders of older submissions that nobody needs any more, and says so. `fates`: of
/// all jobs of the journal.
void sweep_submissions(const std::vector<JobFate>& fates, const DueWork& work,
                       const FarmStudy& study, const Console& console);

/// What was submitted, and what to do next.
void tell_submitted(const Submission& submission, const Submitted& submitted,
                    const FarmArguments& arguments, bool json, const Console& console);

/// All that a submission would be: its stages and the texts of its files.
void tell_dry_run(const Submission& submission, const Console& console);

}  // namespace mien::pipeline

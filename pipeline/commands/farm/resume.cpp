#include <algorithm>
#include <iterator>
#include <memory>
#include <utility>

#include "motion/error.h"
#include "pipeline/commands/farm/submission_options.h"
#include "pipeline/farm/resumption.h"

namespace mien::pipeline {

namespace {

struct ResumeCommand {
  FarmArguments study;
  SubmissionOptions options;
  bool dry_run = false;
  bool json = false;
};

/// Records the numbers of jobs that Slurm accepted without the client receiving its answer.
void record_adopted_jobs(const std::vector<JobStatus>& statuses, const SubmissionJournal& journal) {
  for (const JobStatus& job_status : statuses)
    if (job_status.is_adopted) journal.note_job(job_status.journal.comment, job_status.journal.job);
}

std::vector<std::string> live_arrays(const std::vector<JobStatus>& statuses,
                                     const std::vector<std::string>& obsolete) {
  std::vector<std::string> arrays;
  for (const JobStatus& job_status : statuses) {
    for (const QueueRow& row : job_status.live()) {
      const bool is_kept = will_proceed(row) && std::find(obsolete.begin(), obsolete.end(),
                                                          name_of(row)) == obsolete.end();
      if (is_kept && std::find(arrays.begin(), arrays.end(), row.array) == arrays.end())
        arrays.push_back(row.array);
    }
  }
  return arrays;
}

/// Removes and returns the jobs of an earlier state of the manifest or program, whose workers no
/// longer produce anything.
std::vector<JobStatus> take_outdated(std::vector<JobStatus>& statuses,
                                     const std::string& graph_key) {
  const auto outdated =
      std::stable_partition(statuses.begin(), statuses.end(), [&](const auto& job_status) {
        return job_status.journal.comment.starts_with("mien:" + graph_key + ":");
      });
  std::vector<JobStatus> taken(std::make_move_iterator(outdated),
                               std::make_move_iterator(statuses.end()));
  statuses.erase(outdated, statuses.end());
  return taken;
}

bool waits_for_rest(const std::vector<JobStatus>& statuses) {
  return std::any_of(statuses.begin(), statuses.end(), [](const JobStatus& job_status) {
    if (job_status.journal.elements != 0) return false;
    const std::vector<QueueRow> live = job_status.live();
    return std::any_of(live.begin(), live.end(), will_proceed);
  });
}

ItemNeeds needs_of(const std::vector<JobStatus>& statuses, const FarmStudy& study,
                   const SubmissionOptions& options, const Console& console) {
  ItemNeeds needs;
  needs.covered = covered_items(statuses, study.folder);
  if (!options.memory.empty()) return needs;  // given by the user
  MemoryNeeds memory = memory_needs(statuses, study.folder);
  needs.memory = std::move(memory.more);
  needs.rest_memory = std::move(memory.rest);
  if (!memory.unknown.empty())
    console.err << "note: " << memory.unknown.front()
                << (memory.unknown.size() > 1 ? " and others" : "")
                << ": out of memory according to Slurm; request more with --mem\n";
  return needs;
}

/// The last accepted submission. Throws Error if there is none.
const JournalSubmission& resumable_submission(const JournalContent& journal,
                                              const FarmManifest& read,
                                              const FarmArguments& arguments) {
  const JournalSubmission* earlier = last_accepted(journal);
  if (earlier == nullptr)
    throw Error(read.folder.string() + ": nothing has been submitted yet" +
                    (journal.submissions.empty() ? "" : " (Slurm refused earlier submissions)"),
                "use mien farm submit " + study_arguments(arguments) +
                    ", or without Slurm mien run " + study_arguments(arguments));
  return *earlier;
}

/// Quality to resume with: without --quality, that of the last accepted submission.
std::string quality_to_resume(const FarmArguments& arguments, const JournalSubmission& earlier,
                              const Console& console) {
  if (!arguments.quality.empty() || earlier.quality.empty()) return arguments.quality;
  console.err << "note: --quality " << earlier.quality << ", as in submission " << earlier.number
              << '\n';
  return earlier.quality;
}

/// Jobs that a new submission replaces.
struct SupersededJobs {
  std::vector<std::string> outdated;
  std::vector<std::string> obsolete;
};

/// Cancels jobs, or in a dry run only reports it.
void cancel_superseded(const std::vector<std::string>& jobs, const char* why,
                       const ResumeCommand& command, const Slurm& slurm, const Console& console) {
  if (jobs.empty()) return;
  if (!command.dry_run) slurm.cancel(jobs);
  console.err << "note: " << jobs.size() << (jobs.size() == 1 ? " job is " : " jobs are ") << why
              << (jobs.size() == 1 ? ", and is" : ", and are")
              << (command.dry_run ? " to be cancelled\n" : " cancelled\n");
}

void cancel_superseded(const SupersededJobs& jobs, const ResumeCommand& command, const Slurm& slurm,
                       const Console& console) {
  cancel_superseded(jobs.outdated, "of the study before it was edited", command, slurm, console);
  cancel_superseded(jobs.obsolete, "held, or waiting for what is missing", command, slurm, console);
}

/// The new jobs are recorded before others are cancelled, so that a full disk leaves the queue
/// unchanged.
Submitted replace(const SupersededJobs& jobs, const Submission& submission,
                  const std::vector<std::string>& live, const ResumeCommand& command,
                  const Slurm& slurm, const SubmissionJournal& journal, const Console& console) {
  write_submission(submission, journal);
  try {
    cancel_superseded(jobs, command, slurm, console);
  } catch (const std::exception& fault) {
    withdraw(submission, journal, fault.what());
    throw;
  }
  return submit(submission, slurm, journal, live);
}

int resume_study(ResumeCommand command, const Console& console) {
  FarmManifest read(command.study, console);
  const SubmissionJournal journal(read.folder);
  const JournalContent content = journal.read();
  const JournalSubmission& earlier = resumable_submission(content, read, command.study);
  command.study.quality = quality_to_resume(command.study, earlier, console);
  JournalSubmission requested = requested_submission(command.options, earlier);
  requested.quality = command.study.quality;
  FarmStudy study(std::move(read), command.study);
  const Slurm slurm;
  const SlurmSite site = slurm.site();
  refuse_too_many_processors(requested.request, slurm);
  const std::vector<QueueRow> queue = slurm.queue();
  std::vector<JobStatus> statuses = job_statuses(content, queue, study.folder);
  if (!command.dry_run) record_adopted_jobs(statuses, journal);
  for (const std::string& loss : lost_job_messages(statuses)) console.err << loss << '\n';
  const std::string key = graph_key(study.production.graph(), study.folder);
  const std::vector<JobStatus> all_statuses = statuses;
  SupersededJobs superseded{live_jobs(take_outdated(statuses, key)), {}};

  const DueWork work = due_work(study, requested, statuses);
  if (!command.dry_run) remove_old_submissions(all_statuses, work, study, console);
  if (work.is_done) {
    cancel_superseded(superseded, command, slurm, console);
    console.out << study.folder.string() << ": nothing to do, everything is done\n";
    return exit_done;
  }
  requested.number = next_submission(study.folder);
  const Submission submission = fitting_submission(
      study, study.call(command.study), work, needs_of(statuses, study, command.options, console),
      requested, site, queue, console);
  if (submission.elements() == 0 && waits_for_rest(statuses)) {
    cancel_superseded(superseded, command, slurm, console);
    console.out << study.folder.string()
                << ": nothing to submit; queued and running jobs make what is missing\n";
    return exit_done;
  }
  superseded.obsolete = obsolete_jobs(statuses);
  if (command.dry_run) {
    cancel_superseded(superseded, command, slurm, console);
    print_dry_run(submission, console);
    return exit_done;
  }
  print_submitted(submission,
                  replace(superseded, submission, live_arrays(statuses, superseded.obsolete),
                          command, slurm, journal, console),
                  command.study, command.json, console);
  return exit_done;
}

}  // namespace

Command farm_resume_command() {
  const auto options = std::make_shared<ResumeCommand>();
  return {
      .name = "resume",
      .summary = "Submit what is missing and not covered by queued jobs",
      .options = all_of(
          farm_options(options->study), submission_options(options->options),
          flag("--dry-run", &options->dry_run,
               "Print the jobs and their batch files; write, cancel and submit nothing"),
          flag("--json", &options->json, "List of submitted jobs as JSON on standard output")),
      .notes =
          "Resources and quality are those of the last submission unless options say otherwise, "
          "with\n"
          "twice the memory for jobs that ran out of it. Jobs that Slurm holds are cancelled and\n"
          "submitted again.\n\n"
          "Example:\n"
          "  mien farm resume my.yaml --out /shared/studies",
      .run = [options](const Console& console) { return resume_study(*options, console); }};
}

}  // namespace mien::pipeline

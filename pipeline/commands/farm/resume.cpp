#include <algorithm>
#include <iterator>
#include <memory>

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
void note_adopted(const std::vector<JobFate>& fates, const SubmissionJournal& journal) {
  for (const JobFate& fate : fates)
    if (fate.is_adopted) journal.note_job(fate.journal.comment, fate.journal.job);
}

std::vector<std::string> arrays_that_live(const std::vector<JobFate>& fates,
                                          const std::vector<std::string>& obsolete) {
  std::vector<std::string> arrays;
  for (const JobFate& fate : fates) {
    for (const QueueRow& row : fate.live()) {
      const bool is_kept = goes_on(row) && std::find(obsolete.begin(), obsolete.end(),
                                                     name_of(row)) == obsolete.end();
      if (is_kept && std::find(arrays.begin(), arrays.end(), row.array) == arrays.end())
        arrays.push_back(row.array);
    }
  }
  return arrays;
}

/// Removes and returns the jobs of an earlier state of the manifest or program, whose workers no
/// longer produce anything.
std::vector<JobFate> take_outdated(std::vector<JobFate>& fates, const std::string& graph_key) {
  const auto outdated = std::stable_partition(fates.begin(), fates.end(), [&](const auto& fate) {
    return fate.journal.comment.starts_with("mien:" + graph_key + ":");
  });
  std::vector<JobFate> taken(std::make_move_iterator(outdated),
                             std::make_move_iterator(fates.end()));
  fates.erase(outdated, fates.end());
  return taken;
}

bool waits_for_rest(const std::vector<JobFate>& fates) {
  return std::any_of(fates.begin(), fates.end(), [](const JobFate& fate) {
    if (fate.journal.elements != 0) return false;
    const std::vector<QueueRow> live = fate.live();
    return std::any_of(live.begin(), live.end(), goes_on);
  });
}

ItemNeeds needs_of(const std::vector<JobFate>& fates, const FarmStudy& study,
                   const SubmissionOptions& options, const Console& console) {
  ItemNeeds needs;
  needs.covered = covered_items(fates, study.folder);
  if (!options.memory.empty()) return needs;  // given by the user
  MemoryNeeds memory = memory_needs(fates, study.folder);
  needs.memory = std::move(memory.more);
  if (!memory.unknown.empty())
    console.err << "note: " << memory.unknown.front()
                << (memory.unknown.size() > 1 ? " and others" : "")
                << ": out of memory according to Slurm; request more with --mem\n";
  return needs;
}

/// The options of the last accepted submission, overridden by those of this one.
JournalSubmission asked_again(const ResumeCommand& command, const JournalContent& journal,
                              const FarmStudy& study) {
  const JournalSubmission* earlier = last_accepted(journal);
  if (earlier == nullptr)
    throw Error(study.folder.string() + ": nothing has been submitted yet" +
                    (journal.submissions.empty() ? "" : " (Slurm refused earlier submissions)"),
                "use mien farm submit " + study_words(command.study) +
                    ", or without Slurm mien run " + study_words(command.study));
  JournalSubmission asked = asked_for(command.options, *earlier);
  asked.quality = command.study.quality;
  return asked;
}

/// Jobs that a new submission replaces.
struct InTheWay {
  std::vector<std::string> outdated;
  std::vector<std::string> obsolete;
};

/// Cancels jobs, or in a dry run only reports it.
void take_back(const std::vector<std::string>& jobs, const char* why, const ResumeCommand& command,
               const Slurm& slurm, const Console& console) {
  if (jobs.empty()) return;
  if (!command.dry_run) slurm.cancel(jobs);
  console.err << "note: " << jobs.size() << (jobs.size() == 1 ? " job is " : " jobs are ") << why
              << (jobs.size() == 1 ? ", and is" : ", and are")
              << (command.dry_run ? " to be cancelled\n" : " cancelled\n");
}

void take_back(const InTheWay& jobs, const ResumeCommand& command, const Slurm& slurm,
               const Console& console) {
  take_back(jobs.outdated, "of the study before it was edited", command, slurm, console);
  take_back(jobs.obsolete, "held, or waiting for what is missing", command, slurm, console);
}

/// The new jobs are recorded before others are cancelled, so that a full disk leaves the queue
/// unchanged.
Submitted replace(const InTheWay& jobs, const Submission& submission,
                  const std::vector<std::string>& live, const ResumeCommand& command,
                  const Slurm& slurm, const SubmissionJournal& journal, const Console& console) {
  write_submission(submission, journal);
  try {
    take_back(jobs, command, slurm, console);
  } catch (const std::exception& fault) {
    withdraw(submission, journal, fault.what());
    throw;
  }
  return submit(submission, slurm, journal, live);
}

int resume_study(const ResumeCommand& command, const Console& console) {
  FarmStudy study(command.study, console);
  const SubmissionJournal journal(study.folder);
  const JournalContent content = journal.read();
  JournalSubmission asked = asked_again(command, content, study);
  const Slurm slurm;
  const SlurmSite site = slurm.site();
  refuse_too_many_processors(asked.request, slurm);
  const std::vector<QueueRow> queue = slurm.queue();
  std::vector<JobFate> fates = job_fates(content, queue, study.folder);
  if (!command.dry_run) note_adopted(fates, journal);
  for (const std::string& loss : told_losses(fates)) console.err << loss << '\n';
  const std::string key = graph_key(study.production.graph(), study.folder);
  const std::vector<JobFate> all_fates = fates;
  InTheWay in_the_way{live_jobs(take_outdated(fates, key)), {}};

  const DueWork work = due_work(study, asked, fates);
  if (!command.dry_run) sweep_submissions(all_fates, work, study, console);
  if (work.is_done(study)) {
    take_back(in_the_way, command, slurm, console);
    console.out << study.folder.string() << ": nothing to do, everything is done\n";
    return exit_done;
  }
  asked.number = next_submission(study.folder);
  const Submission submission = fitting_submission(study, study.call(command.study), work,
                                                   needs_of(fates, study, command.options, console),
                                                   asked, site, queue, console);
  if (submission.elements() == 0 && waits_for_rest(fates)) {
    take_back(in_the_way, command, slurm, console);
    console.out << study.folder.string()
                << ": nothing to submit; queued and running jobs make what is missing\n";
    return exit_done;
  }
  in_the_way.obsolete = obsolete_jobs(fates);
  if (command.dry_run) {
    take_back(in_the_way, command, slurm, console);
    tell_dry_run(submission, console);
    return exit_done;
  }
  tell_submitted(submission,
                 replace(in_the_way, submission, arrays_that_live(fates, in_the_way.obsolete),
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
          "Resources are those of the last submission unless options say otherwise, with twice the "
          "memory for\n"
          "jobs that ran out of it. Jobs that Slurm holds are cancelled and submitted again.\n\n"
          "Example:\n"
          "  mien farm resume my.yaml --out /shared/studies",
      .run = [options](const Console& console) { return resume_study(*options, console); }};
}

}  // namespace mien::pipeline

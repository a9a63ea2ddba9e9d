#include <memory>

#include <fmt/format.h>

#include "motion/error.h"
#include "pipeline/commands/farm/submission_options.h"
#include "pipeline/farm/jobs/job_status.h"

namespace mien::pipeline {

namespace {

struct SubmitCommand {
  FarmArguments study;
  SubmissionOptions options;
  bool dry_run = false;
  bool json = false;
};

/// Refuses a missing study folder that has jobs: its disk may not be mounted, and a new folder
/// would be created at the mount point.
void refuse_absent_folder(const JournalContent& journal, const std::vector<QueueRow>& queue,
                          const FarmStudy& study) {
  if (!journal.jobs.empty()) return;
  const std::string key = graph_key(study.production.graph(), study.folder);
  const std::vector<std::string> live = live_jobs_of_graph(queue, key);
  if (live.empty()) return;
  throw Error("Slurm has jobs of this study (" + live.front() +
                  (live.size() > 1 ? fmt::format(" and {} more", live.size() - 1) : "") +
                  "), but " + study.folder.string() + " knows of none",
              "check that its disk is mounted on this machine; if the folder was removed, end the "
              "jobs with scancel");
}

void refuse_second(const std::vector<std::string>& live, const FarmArguments& arguments) {
  if (live.empty()) return;
  const std::string study_text = study_arguments(arguments);
  throw Error("the study has been submitted already: " + std::to_string(live.size()) +
                  (live.size() == 1 ? " of its jobs is queued or running"
                                    : " of its jobs are queued or running"),
              "mien farm status " + study_text + " shows them, mien farm resume " + study_text +
                  " submits what they do not cover, mien farm cancel " + study_text +
                  " cancels them");
}

/// The site's limits, or the usual ones if Slurm is not available.
SlurmSite site_for_dry_run(const Slurm& slurm, const Console& console) {
  try {
    return slurm.site();
  } catch (const SlurmFault& fault) {
    console.err << "note: " << fault.what() << '\n';
    return {};
  }
}

int submit_study(const SubmitCommand& command, const Console& console) {
  JournalSubmission requested = requested_submission(command.options, {});
  requested.quality = command.study.quality;
  FarmStudy study(command.study, console);
  const Slurm slurm;
  requested.number = next_submission(study.folder);
  const StudyCall call = study.call(command.study);
  if (command.dry_run) {
    const SlurmSite site = site_for_dry_run(slurm, console);
    std::string why;
    const auto queue = slurm.queue_if_any(why).value_or(std::vector<QueueRow>());
    const DueWork work = due_work(study, requested, {});
    print_dry_run(fitting_submission(study, call, work, {}, requested, site, queue, console),
                  console);
    return exit_done;
  }
  const SlurmSite site = slurm.site();
  refuse_too_many_processors(requested.request, slurm);
  const SubmissionJournal journal(study.folder);
  const std::vector<QueueRow> queue = slurm.queue();
  const JournalContent content = journal.read();
  refuse_absent_folder(content, queue, study);
  const std::vector<JobStatus> statuses = job_statuses(content, queue, study.folder);
  refuse_second(live_jobs(statuses), command.study);
  const DueWork work = due_work(study, requested, {});
  remove_old_submissions(statuses, work, study, console);
  if (work.is_done) {
    console.out << study.folder.string() << ": nothing to do, everything is done\n";
    return exit_done;
  }
  const Submission submission =
      fitting_submission(study, call, work, {}, requested, site, queue, console);
  write_submission(submission, journal);
  print_submitted(submission, submit(submission, slurm, journal, {}), command.study, command.json,
                  console);
  return exit_done;
}

}  // namespace

Command farm_submit_command() {
  const auto options = std::make_shared<SubmitCommand>();
  return {.name = "submit",
          .summary = "Submit a study to Slurm as job arrays",
          .options = all_of(
              farm_options(options->study), submission_options(options->options),
              flag("--dry-run", &options->dry_run,
                   "Print the jobs and their batch files; write and submit nothing"),
              flag("--json", &options->json, "List of submitted jobs as JSON on standard output")),
          .notes =
              "The batch files are in <out>/<study>/farm/0001, 0002, …; they can be read, changed "
              "and submitted again.\n\n"
              "Examples:\n"
              "  mien farm submit my.yaml --out /shared/studies --time 1:00:00 --mem 2G\n"
              "  mien farm submit my.yaml --dry-run",
          .run = [options](const Console& console) { return submit_study(*options, console); }};
}

}  // namespace mien::pipeline

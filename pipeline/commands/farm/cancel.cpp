#include <memory>

#include <nlohmann/json.hpp>

#include "pipeline/commands/farm/farm.h"
#include "pipeline/farm/jobs/job_status.h"
#include "pipeline/farm/slurm/slurm.h"

namespace mien::pipeline {

namespace {

struct CancelCommand {
  FarmArguments study;
  bool json = false;
};

/// Records cancelled jobs in the journal. A failure to write is only reported, since the jobs are
/// cancelled nevertheless.
void note_cancelled(const std::vector<JobStatus>& statuses, const SubmissionJournal& journal,
                    const Console& console) {
  try {
    for (const JobStatus& job_status : statuses)
      if (!job_status.live().empty())
        journal.note_cancel(job_status.journal.comment, job_status.journal.job);
  } catch (const std::exception& fault) {
    console.err << "note: " << fault.what() << "; the jobs are cancelled nevertheless\n";
  }
}

int cancel_study(const CancelCommand& command, const Console& console) {
  const FarmStudy study(command.study, console);
  const SubmissionJournal journal(study.folder);
  const JournalContent content = journal.read();
  const Slurm slurm;
  const std::vector<JobStatus> statuses = content.jobs.empty()
                                              ? std::vector<JobStatus>()
                                              : job_statuses(content, slurm.queue(), study.folder);
  const std::vector<std::string> jobs = live_jobs(statuses);
  slurm.cancel(jobs);
  note_cancelled(statuses, journal, console);
  if (command.json) {
    console.out << nlohmann::ordered_json{{"study", study.production.manifest().study},
                                          {"cancelled", jobs}}
                       .dump(2)
                << '\n';
  } else if (jobs.empty()) {
    console.out << study.folder.string() << ": no job of this study is queued or running\n";
  } else {
    console.out << study.folder.string() << ": " << jobs.size()
                << (jobs.size() == 1 ? " job" : " jobs")
                << " cancelled; finished work is kept, and mien farm resume continues from here\n";
  }
  return exit_done;
}

}  // namespace

Command farm_cancel_command() {
  const auto options = std::make_shared<CancelCommand>();
  return {.name = "cancel",
          .summary = "Cancel the jobs of a study",
          .options = all_of(
              farm_options(options->study),
              flag("--json", &options->json, "List of cancelled jobs as JSON on standard output")),
          .notes = "Example:\n  mien farm cancel my.yaml",
          .run = [options](const Console& console) { return cancel_study(*options, console); }};
}

}  // namespace mien::pipeline

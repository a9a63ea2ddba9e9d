#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "pipeline/commands/farm/farm.h"
#include "pipeline/farm/jobs/job_status.h"
#include "pipeline/farm/slurm/slurm.h"
#include "pipeline/farm/submission.h"

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

/// Jobs of the queue. Without Slurm there are none, unless the journal says that there were.
std::vector<QueueRow> queue_to_cancel(const JournalContent& journal, const Slurm& slurm) {
  return journal.jobs.empty() && !slurm.is_installed() ? std::vector<QueueRow>() : slurm.queue();
}

/// The live jobs of the study. Those that its journal lacks, for instance because the study's
/// folder is away, are known by their comments.
std::vector<std::string> jobs_to_cancel(const std::vector<JobStatus>& statuses,
                                        const std::vector<QueueRow>& queue,
                                        const FarmStudy& study) {
  std::vector<std::string> jobs = live_jobs(statuses);
  const std::string key = graph_key(study.production.graph(), study.folder);
  for (const std::string& job : live_jobs_of_graph(queue, key)) {
    if (std::ranges::find(jobs, job) == jobs.end()) jobs.push_back(job);
  }
  return jobs;
}

int cancel_study(const CancelCommand& command, const Console& console) {
  const FarmStudy study(command.study, console);
  const SubmissionJournal journal(study.folder);
  const JournalContent content = journal.read();
  const Slurm slurm;
  const std::vector<QueueRow> queue = queue_to_cancel(content, slurm);
  const std::vector<JobStatus> statuses = job_statuses(content, queue, study.folder);
  const std::vector<std::string> jobs = jobs_to_cancel(statuses, queue, study);
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
